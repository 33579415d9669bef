//! Values between two ends, each computed on demand: exact decimals, rounded once.
use std::fmt;

use super::decimal::{Decimal, linear};

/// How values lie between their ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Spacing {
    /// At equal distances.
    Linear,
    /// At equal ratios.
    Logarithmic,
}

/// Values between two finite ends, both included.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Range {
    ends: [f64; 2],
    /// Number of values, 1 or more; 2 or more if the ends differ.
    pub(super) count: usize,
    spacing: Spacing,
}

impl Range {
    pub(super) fn new(ends: [f64; 2], count: usize, spacing: Spacing) -> Self {
        Self { ends, count, spacing }
    }

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

    /// Numbers of values, among which are the smallest, the largest and the one nearest to zero.
    pub(super) fn near_extremes(&self) -> impl Iterator<Item = usize> {
        let [start, stop] = self.ends;
        let last = self.count - 1;
        // where a straight line from end to end passes through zero, or the nearer end; ends that are the same have no such place
        let share = (0.5 * start / (0.5 * start - 0.5 * stop)).clamp(0.0, 1.0);
        let middle = if self.spacing == Spacing::Linear { (share * last as f64) as usize } else { 0 };
        // to rounding, the place is between two of these
        [0, last].into_iter().chain(middle.saturating_sub(1)..=(middle + 2).min(last))
    }
}

/// As it is written on a command line.
impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([start, stop], count) = (self.ends, self.count);
        let end = if self.spacing == Spacing::Logarithmic { ":log" } else { "" };
        write!(f, "{start:?}:{stop:?}:{count}{end}")
    }
}

/// start (stop/start)^(index/last): where the ratio is a power of ten, and that of the value a whole one, it is the decimal
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
