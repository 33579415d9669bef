//! A pressure 1 out to x: on a strip |x'| < x in the plane, on a disc about the axis. An element is the difference of two.
use std::f64::consts::PI;

use crate::contact::problem::twin::Twin;
use crate::numeric::bessel;

impl Twin {
    /// Its resultant, in units of μ₀P' as the pressure: about an axis over 2π.
    pub(super) fn patch(self, x: f64) -> f64 {
        match self {
            Self::Plane => 2.0 * x,
            Self::Round => 0.5 * x * x,
        }
    }

    /// The resultant of the element between two patches.
    pub(super) fn element(self, [from, to]: [f64; 2]) -> f64 {
        match self {
            Self::Plane => 2.0 * (to - from),
            Self::Round => 0.5 * (to - from) * (to + from),
        }
    }

    /// Its transform less its resultant, at some wavenumbers.
    pub(super) fn patch_transform(self, zeta: &[f64], x: f64) -> Vec<f64> {
        let arguments: Vec<f64> = zeta.iter().map(|zeta| zeta * x).collect();
        let of_unit: Vec<f64> = match self {
            Self::Plane => arguments.iter().map(|z| bessel::sinc_minus_one(*z)).collect(),
            Self::Round => {
                let mut table = vec![0.0; 2 * zeta.len()];
                bessel::table(2, &arguments, &mut table);
                let first = &table[zeta.len()..];
                arguments.iter().zip(first).map(|(z, j)| bessel::jinc_minus_one_from(*z, *j)).collect()
            }
        };
        of_unit.into_iter().map(|minus_one| self.patch(x) * minus_one).collect()
    }

    /// What compliance times product of two transforms is divided by in an energy.
    pub(super) fn over_waves(self, zeta: f64) -> f64 {
        match self {
            Self::Plane => PI * zeta,
            Self::Round => 1.0,
        }
    }

    /// What [`Self::patches`] are multiplied by where the compliance of a half-space is g∞.
    pub(super) fn half_space(self, limit: f64) -> f64 {
        match self {
            // −g∞/π ln|x| responds to a line load
            Self::Plane => -limit / PI,
            Self::Round => limit,
        }
    }

    /// The energy of two patches on a half-space, in units of [`Self::half_space`]. In the plane it is known but for a constant times
    /// both resultants: `reference` is any unit of length.
    pub(super) fn patches(self, x: f64, y: f64, reference: f64) -> f64 {
        match self {
            // ∬ of ln|x|
            Self::Plane => {
                let twice = |x: f64| if x == 0.0 { 0.0 } else { x * x * (0.5 * (x.abs() / reference).ln() - 0.75) };
                2.0 * (twice(x + y) - twice(x - y))
            }
            // ∫ x J₁(ζx)/ζ y J₁(ζy)/ζ dζ
            Self::Round => {
                let (less, more) = (x.min(y), x.max(y));
                0.5 * more * less * less * discs(less / more.max(f64::MIN_POSITIVE))
            }
        }
    }

    /// What the work against a profile is weighed by.
    pub(super) fn patch_measure(self, x: f64) -> f64 {
        match self {
            Self::Plane => 2.0,
            Self::Round => x,
        }
    }
}

/// The hypergeometric function F(½, −½; 2; k²) = 4/(3πk²) ((1 + k²) E − (1 − k²) K), with the complete elliptic integrals from the
/// arithmetic-geometric mean, so that no digits are lost where k is small.
fn discs(k: f64) -> f64 {
    // equal discs have a limit that is this near
    let complement = ((1.0 - k) * (1.0 + k)).max(f64::EPSILON.powi(2)).sqrt();
    let (mut mean, mut geometric) = (1.0, complement);
    // c_1/k, and Σ 2^(n−1) c_n²/k² from n = 1
    let mut half_difference = 0.5 * k / (1.0 + complement);
    let (mut sum, mut power) = (0.0, 1.0);
    while half_difference > f64::EPSILON {
        sum += power * half_difference * half_difference;
        power *= 2.0;
        (mean, geometric) = (0.5 * (mean + geometric), (mean * geometric).sqrt());
        half_difference *= 0.5 * k * half_difference / (mean + geometric);
    }
    2.0 / (3.0 * mean) * (1.5 - 0.5 * k * k - (1.0 + k * k) * sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn discs_are_those_of_the_series() {
        for k in [0.0, 1e-9, 1e-3, 0.1, 0.5, 0.9] {
            let (mut term, mut sum) = (1.0, 0.0);
            for n in 0..400 {
                sum += term;
                let n = f64::from(n);
                term *= (n + 0.5) * (n - 0.5) / ((n + 1.0) * (n + 2.0)) * k * k;
            }
            assert!((discs(k) - sum).abs() < 1e-14, "{k}: {} {sum}", discs(k));
        }
        for (k, tolerance) in [(1.0, 1e-14), (1.0 - 1e-12, 1e-10)] {
            assert!((discs(k) - 8.0 / (3.0 * PI)).abs() < tolerance, "{k}: {}", discs(k));
        }
    }
}
