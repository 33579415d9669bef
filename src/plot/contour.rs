//! Where a quantity on a grid exceeds a value: marching squares.

/// Closed rings around the places of a grid where values are `edge` or more; a place is in there if it is inside an odd
/// number of rings. What is not a number is outside. Places are counted in columns and rows, with fractions between them;
/// `values` has one row after the other.
pub(super) fn rings(values: &[f64], columns: usize, edge: f64) -> Vec<Vec<(f64, f64)>> {
    // a margin all around that is nowhere inside closes the rings: corner (i, j) is the place (i - 1, j - 1)
    let (width, rows) = (columns + 2, values.len() / columns);
    let mut corners = vec![f64::NAN; width * (rows + 2)];
    for (j, row) in values.chunks_exact(columns).enumerate() {
        let first = (j + 1) * width + 1;
        corners[first..first + columns].copy_from_slice(row);
    }
    // a ring crosses a side in proportion to the values, next to what is not a number in the middle, and the margin on the border
    let crossing = |side: usize| {
        let (from, is_across) = (side / 2, side.is_multiple_of(2));
        let to = from + if is_across { 1 } else { width };
        let share = (edge - corners[from]) / (corners[to] - corners[from]);
        let share = if share.is_finite() { share } else { 0.5 };
        let [right, down] = if is_across { [share, 0.0] } else { [0.0, share] };
        let place = |at: f64, count: usize| (at - 1.0).clamp(0.0, (count - 1) as f64);
        (place((from % width) as f64 + right, columns), place((from / width) as f64 + down, rows))
    };
    let mut next = crossings(&corners, width, edge);
    let mut rings = Vec::new();
    for first in 0..next.len() {
        let (mut ring, mut side) = (Vec::new(), first);
        while let Some(following) = next[side].take() {
            ring.push(crossing(side));
            side = following;
        }
        if !ring.is_empty() {
            rings.push(ring);
        }
    }
    rings
}

/// For each side between two corners that a ring crosses, the side that the ring crosses next. Side 2k goes from corner k to the
/// right, side 2k + 1 down.
fn crossings(corners: &[f64], width: usize, edge: f64) -> Vec<Option<usize>> {
    let mut next = vec![None; 2 * corners.len()];
    // the margin on the right and below begins no square
    for corner in (0..corners.len() - width).filter(|corner| (corner + 1) % width != 0) {
        // clockwise
        let inside = [corner, corner + 1, corner + width + 1, corner + width].map(|corner| corners[corner] >= edge);
        let sides = [2 * corner, 2 * (corner + 1) + 1, 2 * (corner + width), 2 * corner + 1];
        let leaves = |k: &usize| inside[*k] && !inside[(k + 1) % 4];
        let enters = |k: &usize| !inside[*k] && inside[(k + 1) % 4];
        for k in (0..4).filter(leaves) {
            // of four crossings each ring takes the next: opposite corners that are inside belong together
            let entry = (1..4).map(|step| (k + step) % 4).find(enters);
            next[sides[k]] = entry.map(|entry| sides[entry]);
        }
    }
    next
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Twice the area inside, from the corners of all rings.
    fn doubled_area(rings: &[Vec<(f64, f64)>]) -> f64 {
        let of = |ring: &Vec<(f64, f64)>| -> f64 {
            let next = ring.iter().cycle().skip(1);
            ring.iter().zip(next).map(|((x, y), (u, v))| x * v - u * y).sum()
        };
        rings.iter().map(of).sum()
    }

    #[test]
    fn a_plane_is_cut_where_it_has_the_value() {
        let values: Vec<f64> = (0..5).flat_map(|j| (0..4).map(move |i| f64::from(i + j))).collect();
        // above the line x + y = 2.5 of the rectangle of 3 by 4
        assert!((doubled_area(&rings(&values, 4, 2.5)).abs() - (24.0 - 6.25)).abs() < 1e-12);
        assert_eq!(doubled_area(&rings(&values, 4, -1.0)).abs(), 24.0);
        assert!(rings(&values, 4, 8.0).is_empty());
    }

    #[test]
    fn holes_are_left_out() {
        let mut values = vec![1.0; 25];
        values[12] = 0.0;
        let rings = rings(&values, 5, 0.5);
        assert_eq!(rings.len(), 2);
        // a diamond with diagonals of 1 is missing
        assert_eq!(doubled_area(&rings).abs(), 32.0 - 1.0);
    }

    #[test]
    fn opposite_corners_belong_together() {
        let saddle = [1.0, 0.0, 0.0, 1.0];
        assert_eq!(rings(&saddle, 2, 0.5).len(), 1);
        assert_eq!(doubled_area(&rings(&saddle, 2, 0.5)).abs(), 2.0 - 0.5);
    }
}
