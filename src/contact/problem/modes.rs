//! The sine series of a contact pressure: orders, signs, coefficients, and how much of it is missing.
//!
//! p(x) = Σ c_j sin jφ with x = a cos φ and j = 2m + 1. The unknowns are y_m = ½ π j (−1)^m a c_j/(μ₀P'), y_0 = 1 by
//! equilibrium.
use crate::contact::problem::accuracy::SAFETY;

/// Modes of the coarsest refinement level. Half as many: Newton's method meets more non-physical roots; twice as many cost time and
/// change nothing.
pub(crate) const COARSEST: usize = 8;
/// Modes of the finest level of one contact; all contacts together have twice as many at most, which is what memory allows.
pub(crate) const FINEST: usize = 512;

/// Per contact, per mode.
pub(crate) type Modes = Vec<Vec<f64>>;

/// (−1)^m, the sign of the test functions and modes of order 2m + 1.
pub(crate) fn alternating(m: usize) -> f64 {
    if m.is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// Order j of mode m.
pub(crate) fn order(m: usize) -> f64 {
    (2 * m + 1) as f64
}

/// Σ_m |y_m|/order over a range of modes: how much they may add to the pressure at x = 0, in units of 2/(πa).
pub(crate) fn weight(modes: &[f64], range: std::ops::Range<usize>) -> f64 {
    range.map(|m| (modes[m] / order(m)).abs()).sum()
}

/// Σ |y_m|/order of the modes that are missing, by how the last ones fall, and that fall from quarter to quarter.
pub(crate) fn beyond(modes: &[f64]) -> (f64, f64) {
    let quarter = |k: usize| (modes.len() * k) / 4;
    let (third, fourth) = (weight(modes, quarter(2)..quarter(3)), weight(modes, quarter(3)..modes.len()));
    let fall = ratio(third, fourth);
    (SAFETY * fourth * fall / (1.0 - fall), fall)
}

/// The same as the last quarter falls from half to half: behind a change of sign modes may fall more slowly than before.
pub(crate) fn beyond_late(modes: &[f64]) -> f64 {
    let eighth = |k: usize| (modes.len() * k) / 8;
    let (early, late) = (weight(modes, eighth(6)..eighth(7)), weight(modes, eighth(7)..modes.len()));
    let fall = ratio(early, late);
    late * fall / (1.0 - fall)
}

/// last/before, not quite 1 at most.
fn ratio(before: f64, last: f64) -> f64 {
    const MOST: f64 = 0.9;
    if last < MOST * before {
        last / before
    } else if last == 0.0 {
        0.0
    } else {
        MOST
    }
}
