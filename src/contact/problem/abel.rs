//! Gaps outside an axisymmetric contact.
use std::f64::consts::FRAC_2_PI;

/// The gap w at places x > a from its transform A(t) = t ∫ w'(r)/√(t² − r²) dr there, which vanishes on t ≤ a. It is
/// w(x) = (2/π) ∫ A'(t) acos(t/x) dt from a to x, with A' constant between two places: nowhere negative unless A is.
pub(crate) fn gaps(a: f64, transformed: &[(f64, f64)]) -> Vec<f64> {
    let mut before = (a, 0.0);
    let of = |(x, here): &(f64, f64)| {
        let (last, transform) = std::mem::replace(&mut before, (*x, *here));
        (0.5 * (last + x), here - transform)
    };
    let differences: Vec<(f64, f64)> = transformed.iter().map(of).collect();
    let at = |(k, (x, _)): (usize, &(f64, f64))| {
        let of = |(middle, difference): &(f64, f64)| difference * (middle / x).acos();
        FRAC_2_PI * differences[..=k].iter().map(of).sum::<f64>()
    };
    transformed.iter().enumerate().map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::problem::accuracy::PLACES;

    /// Under a paraboloid on a half-space A = t² − a², and π w = (x² − 2a²) acos(a/x) + a √(x² − a²) of r²/2.
    #[test]
    fn gaps_are_those_of_hertz() {
        let (a, step) = (0.7, 0.02);
        let at = |k: usize| a + step * (k + 1) as f64;
        let transformed: Vec<(f64, f64)> = (0..PLACES).map(|k| (at(k), at(k) * at(k) - a * a)).collect();
        for (k, found) in gaps(a, &transformed).into_iter().enumerate() {
            let x = at(k);
            let expected = ((x * x - 2.0 * a * a) * (a / x).acos() + a * (x * x - a * a).sqrt()) / std::f64::consts::PI;
            let ratio = found / expected;
            assert!((ratio - 1.0).abs() < if k < 6 { 0.07 } else { 0.006 }, "{x}: {ratio}");
        }
    }
}
