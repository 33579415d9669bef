//! Values between two ends, each computed on demand: exact decimals, rounded once.
use std::{fmt, ops};

use super::decimal::{Decimal, linear};

/// How values lie between their ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Spacing {
    /// At equal distances.
    Linear,
    /// At equal ratios.
    Logarithmic,
}

/// A logarithm of any number below 1e308 is rounded by less than 1e-13, and its power by less than this part.
const ROUNDING: f64 = 1e-12;

/// Values between two finite ends, both included.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Range {
    pub(super) ends: [f64; 2],
    /// Number of values, 1 or more; 2 or more if the ends differ.
    pub(super) count: usize,
    pub(super) spacing: Spacing,
}

impl Range {
    /// The value with a number below the count; both ends are met exactly.
    pub(super) fn at(&self, index: usize) -> f64 {
        let [start, stop] = self.ends;
        let last = self.count - 1;
        match self.spacing {
            _ if index == 0 => start,
            _ if index == last => stop,
            Spacing::Linear => linear(start, stop, index, last),
            Spacing::Logarithmic => logarithmic(start, stop, index, last),
        }
    }

    /// Numbers of values, among which are all that are this one.
    pub(super) fn near(&self, value: f64) -> ops::Range<usize> {
        if value.is_nan() {
            return 0..0;
        }
        let [start, stop] = self.ends;
        let is_before = |a: f64, b: f64| if start < stop { a < b } else { a > b };
        // values at equal ratios are in order but for rounding
        let mut ends = [value - ROUNDING * value.abs(), value + ROUNDING * value.abs()];
        if start > stop {
            ends.reverse();
        }
        let [first, last] = ends;
        let [begin, end] =
            [self.leading(|value| is_before(value, first)), self.leading(|value| !is_before(last, value))];
        begin.saturating_sub(1)..(end + 1).min(self.count)
    }

    /// How many values, from the first one on, are of a kind to which none belongs behind one that does not.
    fn leading(&self, belongs: impl Fn(f64) -> bool) -> usize {
        let (mut least, mut most) = (0, self.count);
        while least < most {
            let middle = least + (most - least) / 2;
            if belongs(self.at(middle)) { least = middle + 1 } else { most = middle }
        }
        least
    }

    /// Numbers of values, among which are the smallest, the largest and the one nearest to zero.
    pub(super) fn near_extremes(&self) -> impl Iterator<Item = usize> {
        let last = self.count - 1;
        // the values on both sides of a change of sign
        let beyond = self.leading(|value| (value > 0.0) == (self.ends[0] > 0.0));
        [0, last].into_iter().chain(beyond.saturating_sub(1)..=beyond.min(last))
    }
}

/// The range as it is written on a command line.
impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([start, stop], count) = (self.ends, self.count);
        let end = if self.spacing == Spacing::Logarithmic { ":log" } else { "" };
        write!(f, "{start:?}:{stop:?}:{count}{end}")
    }
}

/// start (stop/start)^(index/last): where the ratio is a power of ten, and the power of the value is a whole number, it is the decimal
/// with the digits of `start`.
fn logarithmic(start: f64, stop: f64, index: usize, last: usize) -> f64 {
    let (first, end) = (Decimal::of(start), Decimal::of(stop));
    let steps = (i64::from(end.exponent) - i64::from(first.exponent)) * index as i64;
    if first.digits == end.digits && steps % last as i64 == 0 {
        return Decimal { digits: first.digits, exponent: first.exponent + (steps / last as i64) as i32 }.nearest();
    }
    let share = index as f64 / last as f64;
    10f64.powf(start.log10() * (1.0 - share) + stop.log10() * share)
}
