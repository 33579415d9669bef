//! One level of refinement: half-lengths, pressures, and how far they may be from the truth.
use std::f64::consts::PI;

use crate::kernel::Kernel;

use super::galerkin::{Modes, alternating, order};
use super::newton::Converged;
use super::pressures::weight;

/// What rounding leaves of a half-length, relative: kernels are resolved to 1e-13 of themselves.
const ROUNDING: f64 = 1e-13;
/// No level is judged better than this.
pub(super) const BEST: f64 = 5.0 * ROUNDING;
/// What is missing is estimated from how the last modes fall, and then taken so many times.
const SAFETY: f64 = 3.0;

/// Half-lengths and pressures at one level of refinement.
pub(super) struct Level {
    /// Half-lengths in units of L.
    pub(super) half_lengths: Vec<f64>,
    /// y_im of contact i, y_i0 = 1, see [`super::galerkin`].
    pub(super) modes: Modes,
    /// Whether the iteration was done with the modes.
    pub(super) settled: Vec<bool>,
    /// Relative errors of half-lengths and of pressures at x = 0, estimated.
    pub(super) errors: Vec<[f64; 2]>,
    /// Part of the highest modes in the pressure of a contact.
    pub(super) tails: Vec<f64>,
    /// Where modes fall like a power, the terms of the pressure at x = 0 are averaged.
    pub(super) averaged: Vec<bool>,
}

impl Level {
    /// Errors are judged by what the iterated modes have changed, and by how fast the highest of them fall.
    /// Parts of the kernels below `negligible` were left out.
    pub(super) fn new(found: Converged, kernel: &Kernel, negligible: f64) -> Self {
        let Converged { half_lengths, modes, solved, shift, unsettled, rounding } = found;
        let averaged: Vec<bool> = (0..modes.len()).map(|i| !kernel.far(i).is_constant()).collect();
        let (mut errors, mut tails, mut settled) = (Vec::new(), Vec::new(), Vec::new());
        for (i, y) in modes.iter().enumerate() {
            let quarter = |k: usize| (y.len() * k) / 4;
            let (third, fourth) = (weight(y, quarter(2)..quarter(3)), weight(y, quarter(3)..y.len()));
            let iterated = weight(y, solved[i]..y.len());
            let fall = ratio(third, fourth);
            let beyond = SAFETY * fourth * fall / (1.0 - fall);
            let peak = peak(y, averaged[i]);
            // half-lengths feel what is missing squared, and no more than pressures do
            let further = (beyond / iterated.max(f64::MIN_POSITIVE)).powi(2);
            let beyond_length = (shift[i].abs() * further).min(beyond / (PI * peak.abs()));
            let length = beyond_length + unsettled[i][0] + negligible + ROUNDING + rounding[i];
            let missing = if averaged[i] {
                // an averaged sum is as good as the next one differs from it
                let change = (self::peak(&y[..quarter(3)], true) - peak).abs();
                (change * SAFETY * fall).min(beyond / PI)
            } else {
                beyond / PI
            };
            let pressure = (missing + unsettled[i][1] / PI) / peak.abs();
            errors.push([length, pressure + 3.0 * length]);
            settled.push(unsettled[i][0] < 0.1 * length && unsettled[i][1] < 0.1 * pressure * peak.abs() * PI);
            tails.push(weight(y, y.len() / 2..y.len()) / (PI * peak.abs()));
        }
        Self { half_lengths, modes, settled, errors, tails, averaged }
    }

    /// The largest of the error estimates.
    pub(super) fn worst_error(&self) -> f64 {
        self.errors.iter().flatten().fold(0.0, |worst: f64, error| worst.max(*error))
    }
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

/// p(0) a/(2 μ₀P'), Σ y_m/(πj). Next to a graded face the terms fall like ± j⁻⁴, alternating, since the pressure
/// has a logarithm at its ends: the last partial sums are averaged, which leaves little of what is missing.
pub(super) fn peak(modes: &[f64], averaged: bool) -> f64 {
    const AVERAGED: [f64; 6] = [63.0 / 64.0, 57.0 / 64.0, 42.0 / 64.0, 22.0 / 64.0, 7.0 / 64.0, 1.0 / 64.0];
    let last = if averaged { modes.len().saturating_sub(AVERAGED.len()) } else { modes.len() };
    let terms = modes.iter().enumerate().map(|(m, y)| {
        let weight = m.checked_sub(last).map_or(1.0, |k| AVERAGED[k]);
        weight * y / order(m)
    });
    terms.sum::<f64>() / PI
}

/// c_j a/(2 μ₀P') of p = Σ c_j sin jφ with x = a cos φ, from y_m = ½ π j (−1)^m a c_j/(μ₀P').
pub(super) fn coefficients(modes: &[f64]) -> Vec<f64> {
    let coefficient = |(m, y): (usize, &f64)| alternating(m) * y / (order(m) * PI);
    modes.iter().enumerate().map(coefficient).collect()
}
