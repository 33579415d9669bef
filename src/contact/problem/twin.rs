//! What differs between a plane problem and its axisymmetric twin: orders of Bessel functions, weights of integrals, and units.
//!
//! Modes of the pressure have the transforms (2P'/ζ) Σ y_m ψ_m, with ψ_m = J_j(ζa)/a in the plane. In the axisymmetric case
//! P' = F/(2πμ₀L²), transforms are ∫ p J₀(ζr) r dr, and ψ_m = (3/2) κ_m j_j(ζa)/a with spherical Bessel functions, j = 2m + 1; the gap is tested
//! with Legendre polynomials after an Abel transform. So all equations are the same with Bessel functions of orders larger by s = 1/2,
//! f_n = z^(−s) J_(n+s), of which f_n' = (f_(n−1) − f_(n+1))/2 − s f_n/z and f_(n−1) + f_(n+1) = 2 (n + s) f_n/z.
//!
//! Modes are scaled by κ_m so that the pressure at the middle is the sum of y_m/j in both.
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};
use std::ops::Deref;
use std::sync::LazyLock;

use crate::contact::problem::modes::{alternating, order};
use crate::geometry::Geometry;
use crate::numeric::bessel::{self, Kind};
use crate::solution::jacobi_weights;

/// Modes of which factors are tabulated: as many as pressures under punches that are not smooth have on a half-plane.
const SCALED: usize = 12_288;

/// A plane problem, or its axisymmetric twin: the numbers in which they differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Twin {
    Plane,
    Round,
}

pub(crate) struct Numbers {
    /// s, by which orders of Bessel functions are larger.
    pub(crate) shift: f64,
    /// Which Bessel functions these are.
    pub(crate) bessel: Kind,
    /// 1 + s: Bessel functions are multiplied by it, so that the first mode has the resultant P.
    pub(crate) norm: f64,
    /// 1 + 2s: the power of a length by which a pressure becomes a force.
    pub(crate) lengths: i32,
    /// A force over μ₀P' and this power of L.
    force: f64,
    /// g∞ ∫ ψ_m² over all wavenumbers times (j + s) a^(2s + 2)/(g∞ κ_m²).
    diagonal: f64,
    /// What the row of a punch is multiplied by, over κ_m.
    load: f64,
    /// What a compliance of all waves is multiplied by where a force makes a contact.
    compliance: f64,
    /// The pressure at the middle per unit of Σ y_m/(πj), over P', under a contact of half-length 1.
    unit: f64,
    /// The amplitude of arcosh(1/s) next to a tip at which the slope jumps by 1, on a half-plane with g∞ = 1.
    pub(crate) under_jump: f64,
    /// The mean of √(1 − s²) over a contact, by which a mean pressure is told from a force.
    pub(crate) mean: f64,
}

static PLANE: Numbers = Numbers {
    shift: 0.0,
    bessel: Kind::Integer,
    norm: 1.0,
    lengths: 1,
    force: 1.0,
    diagonal: 0.5,
    load: 0.5,
    compliance: 1.0,
    unit: 2.0,
    under_jump: 1.0 / PI,
    mean: 0.25 * PI,
};

static ROUND: Numbers = Numbers {
    shift: 0.5,
    bessel: Kind::Spherical,
    norm: 1.5,
    lengths: 2,
    force: 2.0 * PI,
    diagonal: 0.5625 * PI,
    load: 0.375,
    compliance: PI,
    unit: 3.0 * PI,
    under_jump: 0.5,
    mean: 2.0 / 3.0,
};

impl Deref for Twin {
    type Target = Numbers;

    fn deref(&self) -> &Numbers {
        if *self == Self::Round { &ROUND } else { &PLANE }
    }
}

/// (2j + 1) w_m (−1)^m ∫ P_j from 0 to 1: the coefficients of arcosh(1/s) as a sum of √(1 − s²) times Jacobi polynomials.
static TIPS: LazyLock<Vec<f64>> = LazyLock::new(|| {
    let mut integral = 0.5;
    let tip = |m: usize| {
        let tip = (2.0 * order(m) + 1.0) * integral / (order(m) * SCALES[m]);
        integral *= order(m) / (order(m) + 3.0);
        tip
    };
    (0..SCALED).map(tip).collect()
});

/// κ_m = 1/(j w_m).
static SCALES: LazyLock<Vec<f64>> =
    LazyLock::new(|| jacobi_weights().take(SCALED).enumerate().map(|(m, w)| 1.0 / (order(m) * w)).collect());

impl Twin {
    pub(crate) fn of(geometry: Geometry) -> Self {
        if geometry.is_axisymmetric() { Self::Round } else { Self::Plane }
    }

    /// In which words a punch is written.
    pub(crate) fn geometry(self) -> Geometry {
        if self == Self::Round { Geometry::Axisymmetric } else { Geometry::PlaneStrain }
    }

    /// The factors κ_m by which modes are scaled; none in the plane.
    pub(crate) fn scales(self) -> Option<&'static [f64]> {
        (self == Self::Round).then(|| &SCALES[..])
    }

    /// κ_m.
    pub(crate) fn scale(self, m: usize) -> f64 {
        self.scales().map_or(1.0, |scales| scales[m])
    }

    /// A number times a length, or its square.
    fn times(self, number: f64, length: f64) -> f64 {
        (0..self.lengths).fold(number, |product, _| product * length)
    }

    /// P' of a force in the unit of the scene, with μ₀ and L.
    pub(crate) fn force(self, force: f64, modulus: f64, length: f64) -> f64 {
        force / self.times(self.force * modulus, length)
    }

    /// The force of P'.
    pub(crate) fn total_force(self, force: f64, modulus: f64, length: f64) -> f64 {
        self.times(self.force * force * modulus, length)
    }

    /// What dζ/ζ of the plane problem is multiplied by.
    pub(crate) fn measure(self, zeta: f64) -> f64 {
        zeta.powi(self.lengths - 1)
    }

    /// ∫ ψ_m² over all wavenumbers of the mode of number m, which has this order.
    pub(crate) fn product(self, order: usize, m: usize, half_length: f64) -> f64 {
        let product = self.diagonal * self.scale(m).powi(2);
        product / ((order as f64 + self.shift) * half_length.powi(self.lengths + 1))
    }

    /// What the row of the slope of a punch with mode m is multiplied by.
    pub(crate) fn load(self, m: usize) -> f64 {
        self.load * self.scale(m)
    }

    /// Mode m that a punch of row 1 makes of a half-plane with g∞ = 1, over (j + s)/κ_m: the ratio of load and diagonal.
    pub(crate) fn alone(self, half_length: f64) -> f64 {
        self.times(self.load / self.diagonal, half_length)
    }

    /// The force at which a compliance of all waves makes a contact of half-length a under a profile with this first row.
    pub(crate) fn force_under(self, first_row: f64, half_length: f64, compliance: f64) -> f64 {
        self.times(first_row, half_length) / (self.compliance * compliance)
    }

    /// What of the slope of c |x|^n is tested over that slope: all, or its transform A'.
    pub(crate) fn of_power(self, exponent: f64) -> f64 {
        if self == Self::Round { exponent * wallis(exponent - 1.0) } else { 1.0 }
    }

    /// ∫ cos^n θ sin^(2s) θ dθ from 0 to π/2.
    pub(crate) fn moment(self, n: f64) -> f64 {
        if self == Self::Round { 1.0 / (n + 1.0) } else { wallis(n) }
    }

    /// The factors (u, v, w) with which tests follow from each other, C' = (u t + v) C − w C'', in steps of two with alternating signs and
    /// t = cos 2θ from k = 2m + 1 on, or one by one, in the plane, with t = cos θ.
    pub(crate) fn steps(self, m: usize, step: usize) -> [f64; 3] {
        if self == Self::Plane {
            return [if step == 2 { -2.0 } else { 2.0 }, 0.0, 1.0];
        }
        // twice (k + 1) P_(k+1) = (2k + 1) s P_k − k P_(k−1)
        let k = order(m);
        let square = (k + 0.5) * (2.0 * k + 3.0) / ((k + 1.0) * (k + 2.0));
        let last = (2.0 * k + 3.0) * k / ((k + 1.0) * (k + 2.0) * (2.0 * k - 1.0));
        [-square, last * k + (k + 1.0) / (k + 2.0) - square, last * (k - 1.0)]
    }

    /// The pressure at the middle per unit of Σ y_m/(πj), over P'.
    pub(crate) fn unit(self, half_length: f64) -> f64 {
        self.unit / half_length.powi(self.lengths)
    }

    /// The coefficient of mode m in a multiple of arcosh(1/s).
    pub(crate) fn tip_mode(self, m: usize, tip: f64) -> f64 {
        match self {
            Self::Plane => 2.0 * alternating(m) * tip / order(m),
            Self::Round => TIPS[m] * tip,
        }
    }

    /// 2 J_1(z)/z − 1 from J_1(z), or its twin: the transform of the first mode less its resultant.
    pub(crate) fn jinc_minus_one(self, z: f64, first: f64) -> f64 {
        if self == Self::Round { bessel::spherical_jinc_minus_one(z) } else { bessel::jinc_minus_one_from(z, first) }
    }
}

/// ∫ cos^n θ dθ from 0 to π/2.
fn wallis(n: f64) -> f64 {
    FRAC_PI_2.sqrt() * FRAC_1_SQRT_2 * libm::tgamma(0.5 * n + 0.5) / libm::tgamma(0.5 * n + 1.0)
}
