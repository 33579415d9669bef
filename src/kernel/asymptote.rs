//! Large wavenumbers: the short-wave asymptote of a kernel and the terms due to the grading at its own faces.
use crate::numeric::chebyshev::{self, Series};
use crate::numeric::quadrature::rule;
use crate::solution::Stats;
use crate::system::Unresolved;

use super::components::Sample;
use super::{Chains, DECAYED, short_wave_allowance};

/// Points of the fit.
const POINTS: usize = 17;
/// The fit is good if its last coefficients are below this part of the kernel.
const RESOLVED: f64 = 3e-15;
/// Powers of 1/ζ that are taken as sums of exponentials; the series is asymptotic, and more of them are worse.
const POWERS: usize = 4;
/// Steps, upwards from the wavenumber of the fit, in which a sum of exponentials is compared with a remainder, to some hundred times that.
const STEP: f64 = 1.25;
const MOST_STEPS: usize = 24;
/// Exponentials of one sum.
const EXPONENTIALS: usize = 48;

/// The diagonal of one contact for ζ ≥ `from`: a polynomial in from/ζ, constant next to homogeneous material,
/// 1 + O(β/ζ) next to a graded face.
#[derive(Clone, Debug)]
pub(crate) struct Asymptote {
    /// The lowest wavenumber at which it holds.
    pub(crate) from: f64,
    /// The short-wave limit g∞, for ζ → ∞, which makes the Cauchy kernel.
    pub(crate) limit: f64,
    /// The remainder: the kernel minus its short-wave limit, in u = from/ζ; `None` if it vanishes.
    remainder: Option<Series>,
    /// A bound on the remainder over u.
    rate: f64,
}

impl Asymptote {
    /// A kernel that is constant beyond a wavenumber.
    pub(super) fn constant(from: f64, limit: f64) -> Self {
        Self { from, limit, remainder: None, rate: 0.0 }
    }

    /// Fits the diagonal of one contact on ζ ≥ `from`; `None` if it is not yet smooth there.
    pub(super) fn fit(
        chains: &Chains,
        contact: usize,
        from: f64,
        stats: &mut Stats,
    ) -> Result<Option<Self>, Unresolved> {
        let wanted: Vec<bool> = (0..chains.contacts()).map(|i| i == contact).collect();
        let mut sample = Sample::new(chains.order());
        let mut values = Vec::with_capacity(POINTS);
        let points = chebyshev::points(0.0, 1.0, POINTS);
        for u in &points {
            // u = 0 stands for a wavenumber so large that the kernel depends on the material at the face only
            chains.sample(from / u.max(1e-25), &wanted, &mut sample, stats)?;
            values.push(sample.components[contact]);
        }
        let series = Series::from_values_at_points(0.0, 1.0, &values);
        if series.tail() > RESOLVED {
            return Ok(None);
        }
        let limit = series.eval(0.0);
        let spread = values.iter().map(|value| (value - limit).abs()).fold(0.0, f64::max);
        let mut found = Self::constant(from, limit);
        if spread > RESOLVED * limit {
            let remainder: Vec<f64> = values.iter().map(|value| value - limit).collect();
            let rates = points.iter().zip(&remainder).skip(1).map(|(u, remainder)| (remainder / u).abs());
            found.rate = rates.fold(0.0, f64::max);
            found.remainder = Some(Series::from_values_at_points(0.0, 1.0, &remainder));
        }
        Ok(Some(found))
    }

    /// Whether the kernel equals its limit.
    pub(crate) fn is_constant(&self) -> bool {
        self.remainder.is_none()
    }

    /// The wavenumber ζ beyond which the remainder is below `little` (1 + ζa) of the limit; 0 if that is before `from`.
    pub(super) fn vanishes(&self, half_length: f64, little: f64) -> f64 {
        let remainder = self.rate * self.from / (little * self.limit);
        // ζ (1 + ζa) = remainder, without a difference
        let from = 2.0 * remainder / (1.0 + (1.0 + 4.0 * half_length * remainder).sqrt());
        if from > self.from { from } else { 0.0 }
    }

    /// The kernel minus its short-wave limit at ζ ≥ `from`.
    pub(crate) fn remainder(&self, zeta: f64) -> f64 {
        self.remainder.as_ref().map_or(0.0, |series| series.eval(self.from / zeta))
    }

    /// The first powers of 1/ζ in the remainder as a sum of c exp(−ζb), in pairs of b and c: 1/ζⁿ = ∫ bⁿ⁻¹/(n − 1)! exp(−ζb) db, up to a depth b
    /// that no wave beyond `from` reaches. A half-plane with the kernel exp(−ζb) has at x the slope that it has at x + ib with the kernel 1.
    pub(crate) fn exponentials(&self) -> Vec<[f64; 2]> {
        let Some(remainder) = &self.remainder else { return Vec::new() };
        let powers: [f64; POWERS] = remainder.powers();
        let depth = 2.0 * DECAYED;
        // dense next to b = 0, in units of 1/from
        let of = |(t, weight): (f64, f64)| {
            let b = depth * t * t * t;
            let (mut sum, mut term) = (0.0, 1.0);
            for (n, power) in (1u32..).zip(powers) {
                sum += power * term;
                term *= b / f64::from(n);
            }
            [b / self.from, 3.0 * depth * t * t * weight * sum]
        };
        rule(EXPONENTIALS).on(0.0, 1.0).map(of).collect()
    }

    /// The wavenumber beyond which nothing of the remainder is left but these exponentials: less than `little` of the limit, weighted as for a contact of
    /// this half-length, and no less than the remainder is fitted to.
    pub(crate) fn exponentials_suffice(&self, half_length: f64, little: f64) -> f64 {
        let (exponentials, little) = (self.exponentials(), little.max(RESOLVED));
        let is_left = |zeta: f64| {
            let left = self.remainder(zeta) - sum_of(&exponentials, zeta);
            left.abs() > little * self.limit * short_wave_allowance(half_length, zeta)
        };
        let mut zeta = self.from;
        // the difference may change its sign at one wavenumber
        for _ in 0..MOST_STEPS {
            if !is_left(zeta) && !is_left(STEP * zeta) {
                return zeta;
            }
            zeta *= STEP;
        }
        f64::INFINITY
    }
}

/// Σ c exp(−ζb).
pub(crate) fn sum_of(exponentials: &[[f64; 2]], zeta: f64) -> f64 {
    exponentials.iter().map(|[b, c]| c * (-zeta * b).exp()).sum()
}
