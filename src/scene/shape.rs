//! The profile of a punch: heights, slopes, curvatures, and where it is not smooth.
use std::borrow::Cow;

/// A dent is flat to rounding from here on, in half-widths.
const FLAT: f64 = 6.1;

/// A profile with its tip at x = 0, one of a few kinds that all punches are made of.
#[derive(Clone, Debug)]
pub(crate) enum Shape<'a> {
    /// Σ c (|x|/l)^n + t x.
    Powers {
        /// l, in length.
        length: f64,
        /// The exponents n ≥ 1 and the coefficients c, in length.
        terms: Vec<(f64, f64)>,
        /// The slope t everywhere, dimensionless: 0 if the profile is even.
        tilt: f64,
        /// Where the profile begins to fall for good, in length: the punch ends there.
        end: Option<f64>,
    },
    /// R − √(R² − x²) up to x = R.
    Circle(f64),
    /// 0 up to where it ends.
    Flat(f64),
    /// d (exp(−(x/c)²) − 1), which falls from 0 to −d.
    Dent {
        /// d, in length.
        depth: f64,
        /// c, in length.
        half_width: f64,
    },
    /// Cubic polynomials one after the other.
    Pieces {
        /// The polynomials, from left to right, with a start at the tip.
        pieces: Cow<'a, [Piece]>,
        /// Where the last one ends, in length; infinite if it does not.
        end: f64,
    },
}

/// The height Σ c_k (x − about)^k, k = 0, 1, 2, 3, from `start` to where the next piece starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Piece {
    /// Where the piece begins, in length; −∞ if it has no end on the left.
    pub(crate) start: f64,
    /// The place about which the powers are, in length.
    pub(crate) about: f64,
    /// c_k, in length^(1 − k).
    pub(crate) coefficients: [f64; 4],
}

impl Piece {
    /// The piece with powers about its start.
    pub(crate) fn starting(start: f64, coefficients: [f64; 4]) -> Self {
        Self { start, about: start, coefficients }
    }

    /// The slope as a polynomial in y = x − place: the coefficients of 1, y and y².
    pub(crate) fn slopes(&self, place: f64) -> [f64; 3] {
        let ([_, c1, c2, c3], t) = (self.coefficients, place - self.about);
        [c1 + t * (2.0 * c2 + 3.0 * c3 * t), 2.0 * c2 + 6.0 * c3 * t, 3.0 * c3]
    }

    /// The last place at which the piece falls, by more than rounding does, if it ends there.
    pub(super) fn last_fall(&self, end: f64) -> Option<f64> {
        const ROUNDING: f64 = 1e-12;
        let length = end - self.start;
        if length.is_infinite() {
            return None;
        }
        // the slope is a parabola
        let [c1, double, triple] = self.slopes(self.start);
        let (c2, c3) = (0.5 * double, triple / 3.0);
        let slope = |t: f64| c1 + t * (2.0 * c2 + t * 3.0 * c3);
        let zero = -ROUNDING * (c1.abs() + length * (c2.abs() + length * c3.abs()));
        if slope(length) < zero {
            return Some(end);
        }
        // where it is least, and its root beyond
        let least = if c3 > 0.0 { (-c2 / (3.0 * c3)).clamp(0.0, length) } else { 0.0 };
        let root = (c2 * c2 - 3.0 * c1 * c3).sqrt();
        let turn = if c2 > 0.0 { -c1 / (root + c2) } else { (root - c2) / (3.0 * c3) };
        (slope(least) < zero).then_some(self.start + turn)
    }

    /// The mirror image of the piece about x = 0 if the piece ends there.
    fn mirrored(&self, end: f64) -> Self {
        let [c0, c1, c2, c3] = self.coefficients;
        Self { start: -end, about: -self.about, coefficients: [c0, -c1, c2, -c3] }
    }
}

/// An even profile, from left to right, by its right half from x = 0 to `end`; pieces without length are left out.
pub(crate) fn even(right: &[Piece], end: f64) -> Vec<Piece> {
    let ends = right.iter().skip(1).map(|piece| piece.start).chain([end]);
    let inside: Vec<(&Piece, f64)> = right.iter().zip(ends).filter(|(piece, end)| piece.start < *end).collect();
    let left = inside.iter().rev().map(|(piece, end)| piece.mirrored(*end));
    left.chain(inside.iter().map(|(piece, _)| **piece)).collect()
}

impl Shape<'_> {
    /// c (|x|/l)^n.
    pub(crate) fn power(length: f64, exponent: f64, coefficient: f64) -> Self {
        Self::powers(length, vec![(exponent, coefficient)])
    }

    /// Σ c (|x|/l)^n.
    pub(crate) fn powers(length: f64, terms: Vec<(f64, f64)>) -> Self {
        Self::Powers { length, terms, tilt: 0.0, end: None }
    }

    /// With a slope that grows by a curvature times x more; circles, sharp corners and dents stay as they are.
    pub(crate) fn bent(mut self, curvature: f64) -> Self {
        match &mut self {
            Self::Powers { length, terms, .. } => {
                let own = 0.5 * curvature * *length * *length;
                match terms.iter_mut().find(|(exponent, _)| *exponent == 2.0) {
                    Some((_, coefficient)) => *coefficient += own,
                    None => terms.push((2.0, own)),
                }
                terms.retain(|(_, coefficient)| *coefficient != 0.0);
                terms.sort_by(|a, b| a.0.total_cmp(&b.0));
            }
            Self::Pieces { pieces, .. } => {
                for Piece { about, coefficients: [c0, c1, c2, _], .. } in pieces.to_mut() {
                    *c0 += 0.5 * curvature * *about * *about;
                    *c1 += curvature * *about;
                    *c2 += 0.5 * curvature;
                }
            }
            Self::Circle(_) | Self::Flat(_) | Self::Dent { .. } => {}
        }
        self
    }

    /// Whether it falls without end.
    pub(crate) fn falls(&self) -> bool {
        match self {
            Self::Powers { terms, end: None, .. } => terms.last().is_some_and(|(_, coefficient)| *coefficient < 0.0),
            _ => false,
        }
    }

    /// Height above the tip, in length; infinite beyond the edge of a circle or a flat punch.
    pub(crate) fn height(&self, x: f64) -> f64 {
        match self {
            Self::Powers { length, terms, tilt, .. } => {
                let s = x.abs() / length;
                // one factor at a time: s alone may be small enough
                terms.iter().map(|(n, coefficient)| coefficient * s * s.powf(n - 1.0)).sum::<f64>() + tilt * x
            }
            Self::Circle(edge) | Self::Flat(edge) if x.abs() > *edge => f64::INFINITY,
            Self::Flat(_) => 0.0,
            Self::Dent { depth, half_width } => depth * (-(x / half_width).powi(2)).exp_m1(),
            // R − √(R² − x²) without the difference of two large numbers
            Self::Circle(radius) => x * (x / radius) / (1.0 + cosine(x / radius)),
            Self::Pieces { .. } => self.piece(x, |t, [c0, c1, c2, c3]| c0 + t * (c1 + t * (c2 + t * c3))),
        }
    }

    /// Slope, dimensionless: odd in x if the profile is even, at a sharp tip the mean of both sides; infinite at and beyond the edge of a circle.
    pub(crate) fn slope(&self, x: f64) -> f64 {
        let sign = if x == 0.0 { 0.0 } else { x.signum() };
        match self {
            Self::Powers { length, terms, tilt, .. } => {
                let s = x.abs() / length;
                sign * terms.iter().map(|(n, coefficient)| coefficient * n / length * s.powf(n - 1.0)).sum::<f64>()
                    + tilt
            }
            Self::Circle(edge) | Self::Flat(edge) if x.abs() >= *edge => sign * f64::INFINITY,
            Self::Flat(_) => 0.0,
            Self::Dent { depth, half_width } => {
                let s = x / half_width;
                -2.0 * depth / half_width * s * (-s * s).exp()
            }
            Self::Circle(radius) => sign * (x.abs() / radius / cosine(x / radius)),
            Self::Pieces { .. } => self.piece(x, |t, [_, c1, c2, c3]| c1 + t * (2.0 * c2 + t * 3.0 * c3)),
        }
    }

    /// Derivative of the slope, in 1/length; infinite at and beyond the edge of a circle.
    pub(crate) fn curvature(&self, x: f64) -> f64 {
        match self {
            Self::Powers { length, terms, .. } => {
                let s = x.abs() / length;
                // a wedge is straight on either side
                let curved = terms.iter().filter(|(n, _)| *n != 1.0);
                curved.map(|(n, coefficient)| coefficient * n * (n - 1.0) / (length * length) * s.powf(n - 2.0)).sum()
            }
            Self::Circle(edge) | Self::Flat(edge) if x.abs() >= *edge => f64::INFINITY,
            Self::Flat(_) => 0.0,
            Self::Dent { depth, half_width } => {
                let square = (x / half_width).powi(2);
                2.0 * depth / (half_width * half_width) * (2.0 * square - 1.0) * (-square).exp()
            }
            Self::Circle(radius) => radius.recip() / cosine(x / radius).powi(3),
            Self::Pieces { .. } => self.piece(x, |t, [_, _, c2, c3]| 2.0 * c2 + t * 6.0 * c3),
        }
    }

    /// Whether the profile is its own mirror image about x = 0.
    pub(crate) fn is_even(&self) -> bool {
        match self {
            Self::Powers { tilt, .. } => *tilt == 0.0,
            Self::Pieces { pieces, end } => {
                let right = &pieces[pieces.partition_point(|piece| piece.start < 0.0)..];
                even(right, *end)[..] == pieces[..]
            }
            Self::Circle(_) | Self::Flat(_) | Self::Dent { .. } => true,
        }
    }

    /// Half-length that no contact can exceed.
    pub(crate) fn edge(&self) -> Option<f64> {
        match self {
            Self::Circle(edge) | Self::Flat(edge) => Some(*edge),
            Self::Pieces { .. } => {
                let [left, right] = self.ends();
                Some(0.5 * (right - left)).filter(|half| half.is_finite())
            }
            Self::Powers { end, .. } => *end,
            Self::Dent { .. } => None,
        }
    }

    /// Where the profile ends on the left and on the right, in length; infinite where it does not.
    pub(crate) fn ends(&self) -> [f64; 2] {
        match self {
            Self::Pieces { pieces, end } => [pieces.first().map_or(f64::NEG_INFINITY, |piece| piece.start), *end],
            _ => self.edge().map_or([f64::NEG_INFINITY, f64::INFINITY], |edge| [-edge, edge]),
        }
    }

    /// The last place x > 0 at which the profile falls, in length; 0 if it falls nowhere.
    pub(crate) fn last_fall(&self) -> f64 {
        self.ends_of_falls().last().map_or(0.0, |last| last.max(0.0))
    }

    /// The smallest height: at x = 0, or where a fall ends.
    pub(crate) fn lowest(&self) -> f64 {
        self.ends_of_falls().into_iter().map(|x| self.height(x)).fold(self.height(0.0), f64::min)
    }

    /// Places, ascending, among which are the last ones of all falls from left to right; of a power only places x > 0, and also where falls begin.
    fn ends_of_falls(&self) -> Vec<f64> {
        match self {
            Self::Powers { length, terms, end, .. } => {
                let turns = turns(terms).into_iter().map(|turn| turn * length);
                turns.filter(|turn| end.is_none_or(|end| *turn < end)).collect()
            }
            Self::Circle(_) | Self::Flat(_) => Vec::new(),
            Self::Dent { half_width, .. } => vec![FLAT * half_width],
            Self::Pieces { pieces, end, .. } => {
                let ends = pieces.iter().skip(1).map(|piece| piece.start).chain([*end]);
                pieces.iter().zip(ends).filter_map(|(piece, end)| piece.last_fall(end)).collect()
            }
        }
    }

    /// Where the pieces begin of which the profile consists, from left to right; none if it is one piece.
    pub(crate) fn starts(&self) -> Vec<f64> {
        let Self::Pieces { pieces, .. } = self else { return Vec::new() };
        pieces.iter().map(|piece| piece.start).collect()
    }

    /// Half-length that any contact exceeds: the half-length of the flat part of an even profile, 0 if there is none.
    pub(crate) fn flat(&self) -> f64 {
        match self {
            Self::Pieces { pieces, .. } if self.is_even() => {
                let is_level = |piece: &Piece| piece.coefficients[1..].iter().all(|c| *c == 0.0);
                pieces.iter().find(|piece| piece.start >= 0.0 && !is_level(piece)).map_or(0.0, |piece| piece.start)
            }
            Self::Flat(edge) => *edge,
            Self::Pieces { .. } | Self::Powers { .. } | Self::Circle(_) | Self::Dent { .. } => 0.0,
        }
    }

    /// By how much its slope grows with x, in 1/length, if it is a parabola, or flat all along.
    pub(crate) fn even_curvature(&self) -> Option<f64> {
        let Self::Powers { length, terms, .. } = self else { return None };
        let of =
            |(exponent, coefficient): &(f64, f64)| (*exponent == 2.0).then_some(2.0 * coefficient / (length * length));
        terms.iter().map(of).sum()
    }

    /// Whether the profile is analytic, also at its tip.
    pub(crate) fn is_smooth(&self) -> bool {
        match self {
            Self::Powers { terms, .. } => terms.iter().all(|(exponent, _)| exponent % 2.0 == 0.0),
            Self::Circle(_) | Self::Flat(_) | Self::Dent { .. } => true,
            Self::Pieces { .. } => false,
        }
    }

    /// The highest of the exponents of powers, 0 of all others.
    pub(crate) fn degree(&self) -> f64 {
        let Self::Powers { terms, .. } = self else { return 0.0 };
        terms.iter().fold(0.0, |highest: f64, (exponent, _)| highest.max(*exponent))
    }

    /// A value of the piece at x; between two pieces, of the piece farther from the tip.
    fn piece(&self, x: f64, value: impl Fn(f64, [f64; 4]) -> f64) -> f64 {
        let Self::Pieces { pieces, .. } = self else { return 0.0 };
        let after = pieces.partition_point(|piece| piece.start < x || piece.start == x && x >= 0.0);
        let piece = pieces.get(after.saturating_sub(1));
        piece.map_or(0.0, |piece| value(x - piece.about, piece.coefficients))
    }
}

/// The last s > 0 at which Σ c s^n ceases to rise; infinite if it rises without end, `None` if it rises nowhere.
pub(super) fn end_of_rise(terms: &[(f64, f64)]) -> Option<f64> {
    let last = terms.iter().rev().find(|(_, c)| *c != 0.0)?;
    if last.1 > 0.0 { Some(f64::INFINITY) } else { turns(terms).last().copied() }
}

/// All s > 0 at which the slope of Σ c s^n changes its sign, ascending; two of them that differ by less than a per cent may
/// be missed. The exponents n ascend.
fn turns(terms: &[(f64, f64)]) -> Vec<f64> {
    const STEPS: usize = 64;
    let slopes = terms.iter().filter(|(_, c)| *c != 0.0).map(|(n, c)| (n - 1.0, c.signum(), (c * n).abs().ln()));
    let slopes: Vec<(f64, f64, f64)> = slopes.collect();
    let [Some((lowest, _, small)), Some((highest, _, large))] = [slopes.first(), slopes.last()] else {
        return Vec::new();
    };
    if slopes.iter().all(|(_, sign, _)| *sign == slopes[0].1) {
        return Vec::new();
    }
    // the logarithms of s between which no single term outweighs all others together
    let all = (slopes.len() as f64).ln();
    let below = slopes[1..].iter().map(|(n, _, c)| (small - c - all) / (n - lowest)).fold(f64::INFINITY, f64::min);
    let others = &slopes[..slopes.len() - 1];
    let above = others.iter().map(|(n, _, c)| (c - large + all) / (highest - n)).fold(f64::NEG_INFINITY, f64::max);
    let rises = |x: f64| {
        let largest = slopes.iter().map(|(n, _, c)| n * x + c).fold(f64::NEG_INFINITY, f64::max);
        slopes.iter().map(|(n, sign, c)| sign * (n * x + c - largest).exp()).sum::<f64>() > 0.0
    };
    let steps = (STEPS as f64 * (above - below).clamp(1.0, 64.0)) as usize;
    let at = |k: usize| below + (above - below) * k as f64 / steps as f64;
    let mut found = Vec::new();
    for k in 0..steps {
        let (mut from, mut to) = (at(k), at(k + 1));
        if rises(from) == rises(to) {
            continue;
        }
        while to - from > 4.0 * f64::EPSILON * from.abs().max(1.0) {
            let middle = 0.5 * (from + to);
            if rises(middle) == rises(from) { from = middle } else { to = middle }
        }
        found.push(to.exp());
    }
    found
}

/// √(1 − s²), accurate also near |s| = 1.
fn cosine(s: f64) -> f64 {
    ((1.0 - s) * (1.0 + s)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::spline::smooth;

    #[test]
    fn the_last_fall_of_a_profile_is_found() {
        let fall = |terms: &[f64]| {
            let terms: Vec<(f64, f64)> = terms.iter().enumerate().map(|(k, c)| ((2 * k + 2) as f64, *c)).collect();
            let end = end_of_rise(&terms).map(|end| 2.0 * end);
            let shape = Shape::Powers { length: 2.0, terms, tilt: 0.0, end: end.filter(|end| end.is_finite()) };
            (shape.last_fall(), end)
        };
        let close = |found: f64, exact: f64| assert!((found / exact - 1.0).abs() < 1e-13, "{found} {exact}");
        // s² − 2 s⁴: rises up to s = 1/2
        close(fall(&[1.0, -2.0]).1.unwrap(), 1.0);
        assert_eq!(fall(&[1.0, -2.0]).0, 0.0);
        assert_eq!(fall(&[1.0, 2.0]), (0.0, Some(f64::INFINITY)));
        assert_eq!(fall(&[-1.0, -2.0]), (0.0, None));
        // slope 2 s (1 − t/a) (1 − t/b), t = s²
        for (a, b) in [(0.25, 4.0), (1e-9, 1e9), (3.0, 3.1)] {
            let heights = [1.0, -0.5 * (1.0 / a + 1.0 / b), 1.0 / (3.0 * a * b)];
            close(fall(&heights).0, 2.0 * b.sqrt());
            let heights = heights.map(|h| -h);
            let (last, end) = fall(&heights);
            close(last, 2.0 * a.sqrt());
            close(end.unwrap(), 2.0 * b.sqrt());
        }
        let rows = [(0.0, 0.0), (1.0, 0.1), (2.0, 0.05), (3.0, 0.5), (4.0, 1.6)];
        let table = Shape::Pieces { pieces: smooth(&rows).into(), end: 4.0 };
        let lowest = table.last_fall();
        assert!((1.0..3.0).contains(&lowest) && table.slope(lowest).abs() < 1e-14 && table.curvature(lowest) > 0.0);
        let falling = Shape::Pieces { pieces: smooth(&[(0.0, 1.0), (1.0, 0.0)]).into(), end: 1.0 };
        assert_eq!(falling.last_fall(), 1.0);
    }

    #[test]
    fn flat_parts_are_found() {
        let [flat, round] = [(0.0, 0.0), (2.0, 0.5)].map(|(start, c)| Piece::starting(start, [0.0, 0.0, c, 0.0]));
        for right in [&[flat, round][..], &[Piece::starting(0.0, round.coefficients)]] {
            let shape = Shape::Pieces { pieces: even(right, f64::INFINITY).into(), end: f64::INFINITY };
            assert!(shape.is_even() && shape.ends() == [f64::NEG_INFINITY, f64::INFINITY]);
            assert_eq!(shape.flat(), right[right.len() - 1].start);
        }
        assert_eq!(Shape::Circle(1.0).flat(), 0.0);
    }
}
