//! Gaps outside an axisymmetric contact.
use std::f64::consts::FRAC_2_PI;

use crate::contact::problem::accuracy::PLACES;

/// The gap w at x = a + step, a + 2 step, ... from its transform A(t) = t ∫ w'(r)/√(t² − r²) dr there, which vanishes on t ≤ a. It is
/// w(x) = (2/π) ∫ A'(t) acos(t/x) dt from a to x, with A' constant between two places: nowhere negative unless A is.
pub(super) fn gap(a: f64, step: f64, transformed: [f64; PLACES]) -> [f64; PLACES] {
    let mut before = 0.0;
    let differences = transformed.map(|here| here - std::mem::replace(&mut before, here));
    std::array::from_fn(|k| {
        let x = a + step * (k + 1) as f64;
        let of = |(j, difference): (usize, &f64)| difference * ((a + step * (j as f64 + 0.5)) / x).acos();
        FRAC_2_PI * differences[..=k].iter().enumerate().map(of).sum::<f64>()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Under a paraboloid on a half-space A = t² − a², and π w = (x² − 2a²) acos(a/x) + a √(x² − a²) of r²/2.
    #[test]
    fn gaps_are_those_of_hertz() {
        let (a, step) = (0.7, 0.02);
        let at = |k: usize| a + step * (k + 1) as f64;
        let found = gap(a, step, std::array::from_fn(|k| at(k) * at(k) - a * a));
        for (k, found) in found.into_iter().enumerate() {
            let x = at(k);
            let expected = ((x * x - 2.0 * a * a) * (a / x).acos() + a * (x * x - a * a).sqrt()) / std::f64::consts::PI;
            let ratio = found / expected;
            assert!((ratio - 1.0).abs() < if k < 6 { 0.07 } else { 0.006 }, "{x}: {ratio}");
        }
    }
}
