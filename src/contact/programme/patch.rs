//! Pressures that are constant on elements, by a pressure 1 from the middle out to x: an element is the difference of two.
use std::f64::consts::PI;

use crate::contact::problem::twin::Twin;
use crate::numeric::bessel;

/// What the elements are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Patch {
    /// Strips where nothing is even: from x = 0 to x, negative on the left.
    Strip,
    /// Strips with their mirror images: |x'| < x.
    Pair,
    /// Rings about an axis: a disc of radius x.
    Ring,
}

impl Patch {
    /// Plane or axisymmetric.
    pub(super) fn twin(self) -> Twin {
        if self == Self::Ring { Twin::Round } else { Twin::Plane }
    }

    /// Its resultant, in units of μ₀P' as the pressure: about an axis over 2π.
    pub(super) fn resultant(self, x: f64) -> f64 {
        match self {
            Self::Strip => x,
            Self::Pair => 2.0 * x,
            Self::Ring => 0.5 * x * x,
        }
    }

    /// Resultant and moment of the element between two patches; what is even has no moment.
    pub(super) fn element(self, [from, to]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Strip => [to - from, 0.5 * (to - from) * (to + from)],
            Self::Pair => [2.0 * (to - from), 0.0],
            Self::Ring => [0.5 * (to - from) * (to + from), 0.0],
        }
    }

    /// Its even transform less its resultant, at some wavenumbers.
    pub(super) fn transform(self, zeta: &[f64], x: f64) -> Vec<f64> {
        let arguments: Vec<f64> = zeta.iter().map(|zeta| zeta * x).collect();
        let of_unit: Vec<f64> = match self {
            Self::Strip | Self::Pair => arguments.iter().map(|z| bessel::sinc_minus_one(*z)).collect(),
            Self::Ring => {
                let mut table = vec![0.0; 2 * zeta.len()];
                bessel::table(2, &arguments, &mut table);
                let first = &table[zeta.len()..];
                arguments.iter().zip(first).map(|(z, j)| bessel::jinc_minus_one_from(*z, *j)).collect()
            }
        };
        of_unit.into_iter().map(|minus_one| self.resultant(x) * minus_one).collect()
    }

    /// The odd transform of a strip less ζ times its moment.
    pub(super) fn odd_transform(zeta: &[f64], x: f64) -> Vec<f64> {
        // (1 − cos z)/ζ = ½ ζx² (sin ½z/½z)²
        let of = |zeta: &f64| {
            let minus_one = bessel::sinc_minus_one(0.5 * zeta * x);
            0.5 * zeta * x * x * minus_one * (minus_one + 2.0)
        };
        zeta.iter().map(of).collect()
    }

    /// What compliance times product of two transforms is divided by in an energy.
    pub(super) fn over_waves(self, zeta: f64) -> f64 {
        if self == Self::Ring { 1.0 } else { PI * zeta }
    }

    /// What [`Self::both`] are multiplied by where the compliance of a half-space is g∞.
    pub(super) fn half_space(self, limit: f64) -> f64 {
        // −g∞/π ln|x| responds to a line load
        if self == Self::Ring { limit } else { -limit / PI }
    }

    /// The energy of two patches on a half-space, in units of [`Self::half_space`]. In the plane it is known but for a constant times
    /// both resultants: `reference` is any unit of length.
    pub(super) fn both(self, x: f64, y: f64, reference: f64) -> f64 {
        // ∬ of ln|x|
        let twice = |x: f64| if x == 0.0 { 0.0 } else { x * x * (0.5 * (x.abs() / reference).ln() - 0.75) };
        match self {
            Self::Strip => -twice(x - y),
            Self::Pair => 2.0 * (twice(x + y) - twice(x - y)),
            // ∫ x J₁(ζx)/ζ y J₁(ζy)/ζ dζ
            Self::Ring => {
                let (less, more) = (x.min(y), x.max(y));
                0.5 * more * less * less * discs(less / more.max(f64::MIN_POSITIVE))
            }
        }
    }

    /// The same of a patch and a pressure 1 on |x'| < y.
    pub(super) fn with_middle(self, x: f64, y: f64) -> f64 {
        let left = if self == Self::Strip { self.both(x, -y, y) } else { 0.0 };
        self.both(x, y, y) - left
    }

    /// The resultant of a pressure 1 on |x'| < x.
    pub(super) fn middle(self, x: f64) -> f64 {
        if self == Self::Strip { 2.0 * x } else { self.resultant(x) }
    }

    /// What the work against a profile is weighed by.
    pub(super) fn measure(self, x: f64) -> f64 {
        match self {
            Self::Strip => 1.0,
            Self::Pair => 2.0,
            Self::Ring => x,
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
