//! The highest place of the polynomial through the values of a stress at the points of a piece.
use super::measure::Measure;
use super::mesh::{LayerPiece, POINTS, Pair, PieceSample};
use crate::numeric::chebyshev::{self, barycentric_weights, interpolation_row};
use crate::numeric::dot;

/// The first and the last step of the search for the highest place, in parts of half a piece. Twice as large, the last one loses digits of
/// places; values change by its square.
const FIRST: f64 = 0.1;
const LAST: f64 = 1e-4;

/// Intervals between neighbouring points in which the search looks where to begin.
const BETWEEN: usize = 4;

/// A place, and the value there.
pub(super) type Height = (Pair<f64>, f64);

/// A polynomial of x and of the depth.
pub(super) struct Polynomial {
    pub(super) piece: LayerPiece,
    measure: Measure,
    /// The points of the piece along x and in depth, between −1 and 1.
    coordinates: Pair<Vec<f64>>,
    /// The values at these points, row by row; their squares if it is a norm.
    values: Vec<Vec<f64>>,
}

impl Polynomial {
    /// Along the lower face of the layer, for a stress there; `None` if the piece does not reach to the face.
    pub(super) fn new(
        PieceSample { piece, points }: &PieceSample,
        measure: Measure,
        thickness: Option<f64>,
    ) -> Option<Self> {
        let (mut piece, mut rows) = (*piece, &points[..]);
        if measure.is_on_face() {
            let face = thickness.filter(|face| piece.ends[1][1] == *face)?;
            (piece.ends[1], piece.smooth[1]) = ([face; 2], [face; 2]);
            rows = &rows[rows.len() - 1..];
        }
        let values: Vec<Vec<f64>> =
            rows.iter().map(|row| row.iter().map(|point| measure.smooth(point)).collect()).collect();
        let coordinates = [values.first()?.len(), values.len()].map(|count| chebyshev::points(-1.0, 1.0, count));
        Some(Self { piece, measure, coordinates, values })
    }

    /// The highest of its points.
    pub(super) fn highest_point(&self) -> Height {
        self.height(self.start())
    }

    /// The highest place of the polynomial, by ever smaller steps from the highest point, and the value of the polynomial at another place.
    pub(super) fn highest(&self, other: Pair<f64>) -> (Height, f64) {
        let weights = [0, 1].map(|axis| barycentric_weights(&self.coordinates[axis]));
        let shares = |axis: usize, s: f64| {
            let mut shares = [0.0; POINTS];
            let points = &self.coordinates[axis];
            interpolation_row(points, &weights[axis], s, &mut shares[..points.len()]);
            shares
        };
        let at = |along: &[f64], down: &[f64]| {
            self.values.iter().zip(down).map(|(row, share)| share * dot(row, along)).sum::<f64>()
        };
        // there may be several high places: the search begins at the highest of the points in between
        let between = [0, 1].map(|axis| {
            let count = BETWEEN * (self.coordinates[axis].len() - 1) + 1;
            let points = chebyshev::points(-1.0, 1.0, count);
            points.into_iter().map(|s| (s, shares(axis, s))).collect::<Vec<_>>()
        });
        let mut best = self.start();
        for (t, down) in &between[1] {
            for (s, along) in &between[0] {
                let value = at(along, down);
                if value > best.1 {
                    best = ([*s, *t], value);
                }
            }
        }
        let mut step = FIRST;
        while step > LAST {
            let around = best.0.map(|s| [-step, 0.0, step].map(|by| (s + by).clamp(-1.0, 1.0)));
            let [along, down] = [0, 1].map(|axis| around[axis].map(|s| shares(axis, s)));
            let before = best;
            for (i, k) in (0..9).map(|n| (n / 3, n % 3)) {
                let value = at(&along[i], &down[k]);
                if value > best.1 {
                    best = ([around[0][i], around[1][k]], value);
                }
            }
            if best == before {
                step *= 0.5;
            }
        }
        let [along, down] = [0, 1].map(|axis| {
            let [from, to] = self.piece.ends[axis];
            shares(axis, if from < to { ((other[axis] - from) + (other[axis] - to)) / (to - from) } else { 0.0 })
        });
        (self.height(best), self.measure.value(at(&along, &down)))
    }

    /// The highest of its points, between −1 and 1.
    fn start(&self) -> Height {
        let [along, down] = &self.coordinates;
        let in_row = |(t, row): (&f64, &Vec<f64>)| along.iter().zip(row).map(|(s, value)| ([*s, *t], *value)).collect();
        let points = down.iter().zip(&self.values).flat_map(|row| -> Vec<Height> { in_row(row) });
        points.fold(([0.0; 2], f64::NEG_INFINITY), |best, point| if point.1 > best.1 { point } else { best })
    }

    /// The place in the layer, and the stress.
    fn height(&self, (place, value): Height) -> Height {
        let on = |axis: usize| {
            let ([from, to], s) = (self.piece.ends[axis], place[axis]);
            // exact at both ends
            if s <= 0.0 { from + 0.5 * (1.0 + s) * (to - from) } else { to - 0.5 * (1.0 - s) * (to - from) }
        };
        ([on(0), on(1)], self.measure.value(value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_is_highest_where_it_is_level_or_on_an_edge() {
        let of = |function: fn(f64, f64) -> f64| {
            let piece = LayerPiece { layer: 0, ends: [[1.0, 3.0], [0.0, 0.5]], smooth: [[1.0, 3.0], [0.0, 0.5]] };
            let points = |axis: usize| chebyshev::points(piece.ends[axis][0], piece.ends[axis][1], POINTS);
            let coordinates = [0, 1].map(|_| chebyshev::points(-1.0, 1.0, POINTS));
            let row = |d: &f64| points(0).iter().map(|x| function(*x, *d)).collect();
            let values = points(1).iter().map(row).collect();
            Polynomial { piece, measure: Measure::Tension, coordinates, values }
        };
        let close = |(place, value): Height, expected: Pair<f64>, height: f64| {
            let off = [place[0] - expected[0], place[1] - expected[1]].map(f64::abs);
            assert!(off[0] < 2e-4 && off[1] < 1e-4 && (value - height).abs() < 1e-7, "{place:?} {value}");
        };
        let inside = of(|x, d| 2.0 - (x - 1.7).powi(2) - 3.0 * (d - 0.2).powi(2) - (x - 1.7) * (d - 0.2));
        close(inside.highest([1.0, 0.0]).0, [1.7, 0.2], 2.0);
        let edge = of(|x, d| x.powi(3) - 4.0 * (d - 0.1).powi(2));
        close(edge.highest([1.0, 0.0]).0, [3.0, 0.1], 27.0);
        assert!((edge.highest([1.5, 0.1]).1 - 3.375).abs() < 1e-13);
        assert!((of(|_, _| 2.0).highest([2.0, 0.0]).0.1 - 2.0).abs() < 1e-14);
    }
}
