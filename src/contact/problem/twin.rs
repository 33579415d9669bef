//! What differs between a plane problem and its axisymmetric twin: orders of Bessel functions, weights of integrals, and units.
//!
//! Modes of the pressure have the transforms (2P'/ζ) Σ y_m ψ_m, with ψ_m = J_j(ζa)/a in the plane. In the axisymmetric case
//! P' = F/(2πμ₀L²), transforms are ∫ p J₀(ζr) r dr, and ψ_m = (3/2) κ_m j_j(ζa)/a with spherical Bessel functions, j = 2m + 1; the gap is tested
//! with Legendre polynomials after an Abel transform. So all equations are the same with Bessel functions of orders larger by s = 1/2,
//! f_n = z^(−s) J_(n+s), of which f_n' = (f_(n−1) − f_(n+1))/2 − s f_n/z and f_(n−1) + f_(n+1) = 2 (n + s) f_n/z.
//!
//! Modes are scaled by κ_m so that the pressure at the middle is the sum of y_m/j in both.
use std::f64::consts::PI;
use std::sync::LazyLock;

use crate::contact::problem::modes::{FINEST, alternating, order};
use crate::geometry::Geometry;
use crate::numeric::bessel::Kind;
use crate::solution::jacobi_weights;

/// A plane problem, or its axisymmetric twin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Twin {
    Plane,
    Round,
}

/// (2j + 1) w_m (−1)^m ∫ P_j from 0 to 1: the coefficients of arcosh(1/s) as a sum of √(1 − s²) times Jacobi polynomials.
static TIPS: LazyLock<Vec<f64>> = LazyLock::new(|| {
    let mut integral = 0.5;
    let tip = |m: usize| {
        let tip = (2.0 * order(m) + 1.0) * integral / (order(m) * SCALES[m]);
        integral *= order(m) / (order(m) + 3.0);
        tip
    };
    (0..8 * FINEST).map(tip).collect()
});

/// κ_m = 1/(j w_m).
static SCALES: LazyLock<Vec<f64>> =
    LazyLock::new(|| jacobi_weights().take(8 * FINEST).enumerate().map(|(m, w)| 1.0 / (order(m) * w)).collect());

impl Twin {
    pub(crate) fn of(geometry: Geometry) -> Self {
        if geometry.is_axisymmetric() { Self::Round } else { Self::Plane }
    }

    /// In which words a punch is written.
    pub(crate) fn geometry(self) -> Geometry {
        if self == Self::Round { Geometry::Axisymmetric } else { Geometry::PlaneStrain }
    }

    /// s, by which orders of Bessel functions are larger.
    pub(crate) fn shift(self) -> f64 {
        if self == Self::Round { 0.5 } else { 0.0 }
    }

    /// Which Bessel functions these are.
    pub(crate) fn bessel(self) -> Kind {
        if self == Self::Round { Kind::Spherical } else { Kind::Integer }
    }

    /// 1 + s: Bessel functions are multiplied by it, so that the first mode has the resultant P.
    pub(crate) fn norm(self) -> f64 {
        1.0 + self.shift()
    }

    /// The factors κ_m by which modes are scaled; none in the plane.
    pub(crate) fn scales(self) -> Option<&'static [f64]> {
        (self == Self::Round).then(|| &SCALES[..])
    }

    /// κ_m.
    pub(crate) fn scale(self, m: usize) -> f64 {
        if self == Self::Round { SCALES[m] } else { 1.0 }
    }

    /// P' of a force in the unit of the scene, with μ₀ and L.
    pub(crate) fn force(self, force: f64, modulus: f64, length: f64) -> f64 {
        match self {
            Self::Plane => force / (modulus * length),
            Self::Round => force / (2.0 * PI * modulus * length * length),
        }
    }

    /// The force of P'.
    pub(crate) fn total_force(self, force: f64, modulus: f64, length: f64) -> f64 {
        match self {
            Self::Plane => force * modulus * length,
            Self::Round => 2.0 * PI * force * modulus * length * length,
        }
    }

    /// What dζ/ζ of the plane problem is multiplied by.
    pub(crate) fn measure(self, zeta: f64) -> f64 {
        if self == Self::Round { zeta } else { 1.0 }
    }

    /// g∞ ∫ ψ_m² over all wavenumbers, for a contact of half-length a.
    pub(crate) fn diagonal(self, limit: f64, m: usize, half_length: f64) -> f64 {
        match self {
            Self::Plane => 0.5 * limit / (order(m) * half_length.powi(2)),
            Self::Round => 1.125 * PI * limit * SCALES[m].powi(2) / ((2.0 * order(m) + 1.0) * half_length.powi(3)),
        }
    }

    /// The force at which a compliance of all waves makes a contact of half-length a under a profile with this first row.
    pub(crate) fn force_under(self, first_row: f64, half_length: f64, compliance: f64) -> f64 {
        match self {
            Self::Plane => first_row * half_length / compliance,
            Self::Round => first_row * half_length * half_length / (PI * compliance),
        }
    }

    /// The first row of a parabola of radius 1 on a contact of half-length 1.
    pub(crate) fn parabola_row(self) -> f64 {
        if self == Self::Round { 4.0 / 3.0 } else { 0.5 * PI }
    }

    /// The power of 1/a in [`Self::diagonal`].
    pub(crate) fn diagonal_power(self) -> f64 {
        2.0 + 2.0 * self.shift()
    }

    /// What the test of the slope of a punch with mode m is multiplied by.
    pub(crate) fn load(self, m: usize) -> f64 {
        if self == Self::Round { 0.375 * self.scale(m) } else { 0.5 }
    }

    /// The pressure at the middle per unit of Σ y_m/(πj), over P'.
    pub(crate) fn unit(self, half_length: f64) -> f64 {
        match self {
            Self::Plane => 2.0 / half_length,
            Self::Round => 3.0 * PI / half_length.powi(2),
        }
    }

    /// The pressure next to sharp corners less a unit pressure of the same resultant has the modes of this factor times 1/√(1 − s²) minus
    /// [`Self::edge_unit`] times √(1 − s²), in the unit of [`Self::unit`] over π.
    pub(crate) fn edge(self) -> f64 {
        if self == Self::Round { 1.0 / 3.0 } else { 0.5 }
    }

    /// √(1 − s²) that has the resultant of 1/√(1 − s²).
    pub(crate) fn edge_unit(self) -> f64 {
        if self == Self::Round { 3.0 } else { 2.0 }
    }

    /// The logarithm arcosh(1/s) under a sharp tip, in the unit of [`Self::unit`] over π, of which all modes are like the modes of the
    /// asymptotic pressure; `first` is the first of the latter.
    pub(crate) fn tip(self, first: f64) -> f64 {
        // its first mode is the first mode of the mode-0 part of 1 = Σ (2k + 1) ∫ P_k
        if self == Self::Round { first / 1.5 } else { 0.5 * first }
    }

    /// The coefficient of mode m in a multiple of arcosh(1/s).
    pub(crate) fn tip_mode(self, m: usize, tip: f64) -> f64 {
        match self {
            Self::Plane => 2.0 * alternating(m) * tip / order(m),
            Self::Round => TIPS[m] * tip,
        }
    }

    /// c_j a/(2 μ₀P') of p = Σ c_j sin jφ with x = a cos φ, from y_m = ½ π j (−1)^m a c_j/(μ₀P'); in the axisymmetric case the coefficients of √(1 − s²)
    /// times Jacobi polynomials that are 1 at s = 0.
    pub(crate) fn coefficients(self, modes: &[f64]) -> Vec<f64> {
        let sign = |m: usize| if self == Self::Plane { alternating(m) } else { 1.0 };
        modes.iter().enumerate().map(|(m, y)| sign(m) * y / (order(m) * PI)).collect()
    }

    /// Multiplies by κ_m.
    pub(crate) fn scaled(self, modes: &[f64]) -> Vec<f64> {
        modes.iter().enumerate().map(|(m, y)| y * self.scale(m)).collect()
    }
}
