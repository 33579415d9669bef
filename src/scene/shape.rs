//! What the profile of a punch is made of: heights, slopes, curvatures, and where it is not smooth.
use std::borrow::Cow;

/// A symmetric profile with its tip at x = 0, one of a few kinds that all punches are made of.
#[derive(Clone, Debug)]
pub(crate) enum Shape<'a> {
    /// Σ c (|x|/l)^n.
    Powers {
        /// l, in length.
        length: f64,
        /// The exponents n ≥ 1 and the coefficients c, in length.
        terms: Vec<(f64, f64)>,
    },
    /// R − √(R² − x²) up to x = R.
    Circle(f64),
    /// 0 up to where it ends.
    Flat(f64),
    /// Cubic polynomials one after the other from x = 0 on.
    Pieces {
        /// The polynomials; the first begins at x = 0.
        pieces: Cow<'a, [Piece]>,
        /// Where the last one ends, in length; `None` if it does not.
        end: Option<f64>,
    },
}

/// The height Σ c_k (x − start)^k, k = 0, 1, 2, 3, from `start` to where the next piece starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Piece {
    /// Where it begins, in length.
    pub(crate) start: f64,
    /// c_k, in length^(1 − k).
    pub(crate) coefficients: [f64; 4],
}

impl Shape<'_> {
    /// Height above the tip, in length; infinite beyond the edge of a circle or a flat punch.
    pub(crate) fn height(&self, x: f64) -> f64 {
        match self {
            Self::Powers { length, terms } => {
                let s = x.abs() / length;
                // one factor at a time: s alone may be small enough
                terms.iter().map(|(n, coefficient)| coefficient * s * s.powf(n - 1.0)).sum()
            }
            Self::Circle(edge) | Self::Flat(edge) if x.abs() > *edge => f64::INFINITY,
            Self::Flat(_) => 0.0,
            // R − √(R² − x²) without the difference of two large numbers
            Self::Circle(radius) => x * (x / radius) / (1.0 + cosine(x / radius)),
            Self::Pieces { .. } => self.piece(x, |t, [c0, c1, c2, c3]| c0 + t * (c1 + t * (c2 + t * c3))),
        }
    }

    /// Slope, dimensionless: odd in x, at a sharp tip 0; infinite at and beyond the edge of a circle.
    pub(crate) fn slope(&self, x: f64) -> f64 {
        let sign = if x == 0.0 { 0.0 } else { x.signum() };
        sign * match self {
            Self::Powers { length, terms } => {
                let s = x.abs() / length;
                terms.iter().map(|(n, coefficient)| coefficient * n / length * s.powf(n - 1.0)).sum()
            }
            Self::Circle(edge) | Self::Flat(edge) if x.abs() >= *edge => f64::INFINITY,
            Self::Flat(_) => 0.0,
            Self::Circle(radius) => x.abs() / radius / cosine(x / radius),
            Self::Pieces { .. } => self.piece(x, |t, [_, c1, c2, c3]| c1 + t * (2.0 * c2 + t * 3.0 * c3)),
        }
    }

    /// Derivative of the slope, in 1/length; infinite at and beyond the edge of a circle.
    pub(crate) fn curvature(&self, x: f64) -> f64 {
        match self {
            Self::Powers { length, terms } => {
                let s = x.abs() / length;
                // a wedge is straight on either side
                let curved = terms.iter().filter(|(n, _)| *n != 1.0);
                curved.map(|(n, coefficient)| coefficient * n * (n - 1.0) / (length * length) * s.powf(n - 2.0)).sum()
            }
            Self::Circle(edge) | Self::Flat(edge) if x.abs() >= *edge => f64::INFINITY,
            Self::Flat(_) => 0.0,
            Self::Circle(radius) => radius.recip() / cosine(x / radius).powi(3),
            Self::Pieces { .. } => self.piece(x, |t, [_, _, c2, c3]| 2.0 * c2 + t * 6.0 * c3),
        }
    }

    /// Half-length that no contact can exceed.
    pub(crate) fn edge(&self) -> Option<f64> {
        match self {
            Self::Powers { .. } => None,
            Self::Circle(edge) | Self::Flat(edge) => Some(*edge),
            Self::Pieces { end, .. } => *end,
        }
    }

    /// Half-length that any contact exceeds: that of the flat part.
    pub(crate) fn flat(&self) -> f64 {
        match self {
            Self::Pieces { pieces, .. } => {
                let risen = pieces.iter().find(|piece| piece.coefficients[1..].iter().any(|c| *c != 0.0));
                risen.map_or(0.0, |piece| piece.start)
            }
            Self::Flat(edge) => *edge,
            Self::Powers { .. } | Self::Circle(_) => 0.0,
        }
    }

    /// Whether the profile is analytic, also at its tip.
    pub(crate) fn is_smooth(&self) -> bool {
        match self {
            Self::Powers { terms, .. } => terms.iter().all(|(exponent, _)| exponent % 2.0 == 0.0),
            Self::Circle(_) | Self::Flat(_) => true,
            Self::Pieces { .. } => false,
        }
    }

    fn piece(&self, x: f64, value: impl Fn(f64, [f64; 4]) -> f64) -> f64 {
        let Self::Pieces { pieces, .. } = self else { return 0.0 };
        let after = pieces.partition_point(|piece| piece.start <= x.abs());
        let piece = pieces.get(after.saturating_sub(1));
        piece.map_or(0.0, |piece| value(x.abs() - piece.start, piece.coefficients))
    }
}

/// √(1 − s²), accurate also near |s| = 1.
fn cosine(s: f64) -> f64 {
    ((1.0 - s) * (1.0 + s)).sqrt()
}

/// The cubic spline through (x, height), x increasing from 0: even, and one polynomial across the last two intervals.
pub(crate) fn spline(rows: &[(f64, f64)]) -> Vec<Piece> {
    let n = rows.len();
    let steps: Vec<f64> = rows.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
    let secants: Vec<f64> = rows.windows(2).zip(&steps).map(|(pair, step)| (pair[1].1 - pair[0].1) / step).collect();
    // slopes at the rows: a tridiagonal system, (below, diagonal, above, right-hand side)
    let mut system = vec![(0.0, 1.0, 0.0, 0.0)];
    for i in 1..n.saturating_sub(1) {
        let (before, after) = (steps[i - 1].recip(), steps[i].recip());
        let right = 3.0 * (secants[i - 1] * before + secants[i] * after);
        system.push((before, 2.0 * (before + after), after, right));
    }
    system.push(match (steps.as_slice(), secants.as_slice()) {
        ([.., h0, h1], [.., d0, d1]) => {
            let both = h0 + h1;
            (both, *h0, 0.0, (h1 * h1 * d0 + (2.0 * both + h1) * h0 * d1) / both)
        }
        (_, secants) => (0.0, 1.0, 0.0, 2.0 * secants.first().copied().unwrap_or(0.0)),
    });
    for i in 1..system.len() {
        let (_, pivot, above, known) = system[i - 1];
        let factor = system[i].0 / pivot;
        system[i].1 -= factor * above;
        system[i].3 -= factor * known;
    }
    let mut slopes = vec![0.0; system.len() + 1];
    for (i, (_, pivot, above, known)) in system.iter().enumerate().rev() {
        slopes[i] = (known - above * slopes[i + 1]) / pivot;
    }
    let piece = |i: usize| {
        let ((x, height), step, secant) = (rows[i], steps[i], secants[i]);
        let [m0, m1] = [slopes[i], slopes[i + 1]];
        let second = (3.0 * secant - 2.0 * m0 - m1) / step;
        let third = (m0 + m1 - 2.0 * secant) / (step * step);
        Piece { start: x, coefficients: [height - rows[0].1, m0, second, third] }
    };
    (0..n.saturating_sub(1)).map(piece).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spline_through_points_of_an_even_cubic_is_that_cubic() {
        let height = |x: f64| 0.3 + 0.5 * x * x + 0.25 * x.powi(3);
        let rows: Vec<(f64, f64)> = [0.0, 0.3, 0.5, 1.1, 1.2].iter().map(|x| (*x, height(*x))).collect();
        for rows in [&rows[..], &rows[..3]] {
            let shape = Shape::Pieces { pieces: spline(rows).into(), end: None };
            for x in [0.0, 0.1, 0.42, 0.5] {
                assert!((shape.height(x) - height(x) + 0.3).abs() < 1e-15, "{x}");
                assert!((shape.slope(-x) + x + 0.75 * x * x).abs() < 1e-14, "{x}");
                assert!((shape.curvature(x) - 1.0 - 1.5 * x).abs() < 1e-13, "{x}");
            }
        }
        let two = Shape::Pieces { pieces: spline(&[(0.0, 0.0), (2.0, 3.0)]).into(), end: None };
        assert!((two.height(1.0) - 0.75).abs() < 1e-15);
    }

    #[test]
    fn between_its_points_a_spline_is_smooth() {
        let rows: Vec<(f64, f64)> = (0..12).map(|i| (0.1 * f64::from(i), (0.17 * f64::from(i * i)).sin())).collect();
        let pieces = spline(&rows);
        for (i, (pair, row)) in pieces.windows(2).zip(&rows[1..]).enumerate() {
            let step = pair[1].start - pair[0].start;
            let [c0, c1, c2, c3] = pair[0].coefficients;
            let [d0, d1, d2, _] = pair[1].coefficients;
            assert!((c0 + step * (c1 + step * (c2 + step * c3)) - d0).abs() < 1e-14 && (d0 - row.1).abs() < 1e-14);
            assert!((c1 + step * (2.0 * c2 + step * 3.0 * c3) - d1).abs() < 1e-12, "{i}");
            assert!((c2 + 3.0 * step * c3 - d2).abs() < 1e-10, "{i}");
        }
    }

    #[test]
    fn flat_parts_are_found() {
        let flat = Piece { start: 0.0, coefficients: [0.0; 4] };
        let round = Piece { start: 2.0, coefficients: [0.0, 0.0, 0.5, 0.0] };
        assert_eq!(Shape::Pieces { pieces: vec![flat, round].into(), end: None }.flat(), 2.0);
        assert_eq!(Shape::Pieces { pieces: vec![round].into(), end: None }.flat(), 2.0);
        assert_eq!(Shape::Circle(1.0).flat(), 0.0);
    }
}
