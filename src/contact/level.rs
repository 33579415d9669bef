//! One level of refinement: half-lengths, pressures, and how far they may be from the truth.
use super::galerkin::{alternating, order};
use super::newton::Converged;

/// What rounding leaves of a half-length, relative: kernels are resolved to 1e-13 of themselves.
const ROUNDING: f64 = 1e-13;
/// No level is judged better than this.
pub(super) const BEST: f64 = 5.0 * ROUNDING;

/// Half-lengths and pressures at one level of refinement.
pub(super) struct Level {
    /// Half-lengths in units of L.
    pub(super) half_lengths: Vec<f64>,
    /// y_ij per unit of P', see [`super::galerkin`].
    pub(super) modes: Vec<Vec<f64>>,
    /// How many of the modes were solved for, not iterated.
    pub(super) solved: Vec<usize>,
    /// Relative errors of half-lengths and of pressures at x = 0, estimated.
    pub(super) errors: Vec<[f64; 2]>,
    /// Part of the highest modes in the pressure of a contact.
    pub(super) tails: Vec<f64>,
}

impl Level {
    /// Errors are judged by what the iterated modes changed, by what changed since the level before, and by how fast the
    /// highest modes fall: what is missing beyond them is to their last half as that is to the first.
    pub(super) fn new(found: Converged, modes: &[usize], before: Option<&Level>) -> Self {
        let Converged { half_lengths, pressures, shift, unsettled, missing } = found;
        let mut errors = Vec::new();
        let mut tails = Vec::new();
        for (i, y) in pressures.modes.iter().enumerate() {
            let size = |range: std::ops::Range<usize>| -> f64 {
                range.map(|m| (y[m] / order(m)).abs()).sum::<f64>() / std::f64::consts::PI
            };
            let (solved, all, peak) = (modes[i], y.len(), peak(y));
            let tail = size(solved..all) / peak;
            let falls = size((solved + all) / 2..all) / size(solved..all).max(f64::MIN_POSITIVE);
            let [length_change, peak_change] = match before {
                Some(before) => [
                    (half_lengths[i] / before.half_lengths[i] - 1.0).abs(),
                    (peak / self::peak(&before.modes[i]) - 1.0).abs(),
                ],
                None => [0.0, tail],
            };
            let beyond = (shift[i].abs() * falls.powi(2)).max(length_change * falls.powi(3));
            let length = beyond + unsettled[i].abs() + missing + ROUNDING;
            let averaged = (self::peak(&y[..(3 * all).div_ceil(4)]) / peak - 1.0).abs();
            let beyond = averaged.max(peak_change * falls.powi(3));
            errors.push([length, beyond + pressures.unsettled_pressure[i] / peak + 3.0 * length]);
            tails.push(tail);
        }
        Self { half_lengths, modes: pressures.modes, solved: modes.to_vec(), errors, tails }
    }

    /// The largest of the error estimates.
    pub(super) fn worst_error(&self) -> f64 {
        self.errors.iter().flatten().fold(0.0, |worst: f64, error| worst.max(*error))
    }
}

/// p(0) per unit of μ₀P', Σ y_j/(πj). Next to a graded face the terms fall like ± j⁻⁴, alternating, since the pressure
/// has a logarithm at its ends: the last partial sums are averaged, which leaves little of what is missing.
pub(super) fn peak(modes: &[f64]) -> f64 {
    const AVERAGED: [f64; 6] = [63.0 / 64.0, 57.0 / 64.0, 42.0 / 64.0, 22.0 / 64.0, 7.0 / 64.0, 1.0 / 64.0];
    let last = modes.len().saturating_sub(AVERAGED.len());
    let terms = modes.iter().enumerate().map(|(m, y)| {
        let weight = m.checked_sub(last).map_or(1.0, |k| AVERAGED[k]);
        weight * y / order(m)
    });
    terms.sum::<f64>() / std::f64::consts::PI
}

/// c_j of p = Σ c_j sin jφ with x = a cos φ, per unit of μ₀P', from y_j = π j (−1)^((j−1)/2) c_j.
pub(super) fn coefficients(modes: &[f64]) -> Vec<f64> {
    let coefficient = |(m, y): (usize, &f64)| alternating(m) * y / (order(m) * std::f64::consts::PI);
    modes.iter().enumerate().map(coefficient).collect()
}
