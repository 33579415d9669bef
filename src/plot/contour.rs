//! Where a quantity on a grid exceeds a value: marching squares.

/// Closed rings around the places of a grid where values are `edge` or more; a place is in there if it is inside an odd
/// number of rings. What is not a number is outside. Places are counted in columns and rows, with fractions between them;
/// `values` has one row after the other.
pub(super) fn rings(values: &[f64], columns: usize, edge: f64) -> Vec<Vec<(f64, f64)>> {
    Squares { values, columns, rows: values.len() / columns, edge }.rings()
}

/// The grid with a margin all around that is nowhere inside, so that all rings are closed: corner (i, j) is the place
/// (i - 1, j - 1), and the margin lies upon the border.
struct Squares<'a> {
    values: &'a [f64],
    columns: usize,
    rows: usize,
    edge: f64,
}

impl Squares<'_> {
    fn rings(&self) -> Vec<Vec<(f64, f64)>> {
        let mut next = self.crossings();
        let mut rings = Vec::new();
        for first in 0..next.len() {
            let (mut ring, mut side) = (Vec::new(), first);
            while let Some(following) = next[side].take() {
                ring.push(self.crossing(side));
                side = following;
            }
            if !ring.is_empty() {
                rings.push(ring);
            }
        }
        rings
    }

    /// Of each side between two corners that a ring crosses, the one that it crosses next. Side 2k goes from corner k to the
    /// right, side 2k + 1 down.
    fn crossings(&self) -> Vec<Option<usize>> {
        let width = self.columns + 2;
        let mut next = vec![None; 2 * width * (self.rows + 2)];
        for (i, j) in (0..=self.rows).flat_map(|j| (0..=self.columns).map(move |i| (i, j))) {
            let corner = j * width + i;
            // clockwise
            let inside = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|corner| self.is_inside(corner));
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

    fn is_inside(&self, (i, j): (usize, usize)) -> bool {
        let within = (1..=self.columns).contains(&i) && (1..=self.rows).contains(&j);
        within && self.value(i, j) >= self.edge
    }

    fn value(&self, i: usize, j: usize) -> f64 {
        self.values[(j - 1) * self.columns + i - 1]
    }

    /// Where a ring crosses a side: in proportion to the values, or on the border.
    fn crossing(&self, side: usize) -> (f64, f64) {
        let (corner, width) = (side / 2, self.columns + 2);
        let (i, j) = (corner % width, corner / width);
        let (right, down) = if side.is_multiple_of(2) { (1, 0) } else { (0, 1) };
        let margin = i == 0 || j == 0 || i + right > self.columns || j + down > self.rows;
        let share = if margin {
            0.0
        } else {
            let (from, to) = (self.value(i, j), self.value(i + right, j + down));
            let share = (self.edge - from) / (to - from);
            // next to what is not a number
            if share.is_finite() { share } else { 0.5 }
        };
        let place = |corner: usize, step: usize, count: usize| {
            (corner as f64 + share * step as f64 - 1.0).clamp(0.0, (count - 1) as f64)
        };
        (place(i, right, self.columns), place(j, down, self.rows))
    }
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
