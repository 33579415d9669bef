//! Deflections outside an axisymmetric contact.
use crate::contact::problem::accuracy::PLACES;
use crate::contact::problem::round::steps;
use crate::contact::problem::twin::Twin;
use crate::numeric::bessel;
use crate::numeric::quadrature::{LARGEST, rule};

/// Gauss points added to those that resolve the highest mode.
const SPARE: usize = 16;

/// ∫ s(ζ) (J₀(ζa) − J₀(ζx))/ζ for x = a + step, a + 2 step, ... with each of two steps.
pub(super) fn round_deflections(zeta: &[f64], slopes: &[f64], a: f64, steps: [f64; 2]) -> [[f64; PLACES]; 2] {
    let count = zeta.len().min(slopes.len());
    let sum = |x: f64| {
        let arguments: Vec<f64> = zeta[..count].iter().map(|zeta| zeta * x).collect();
        let mut zeroth = vec![0.0; count];
        bessel::table(1, &arguments, &mut zeroth);
        zeroth.iter().zip(zeta).zip(slopes).map(|((j, zeta), slope)| slope * j / zeta).sum::<f64>()
    };
    let here = sum(a);
    steps.map(|step| std::array::from_fn(|k| here - sum(a + step * (k + 1) as f64)))
}

/// The same for the short-wave limit of the kernel, times a: (3/2) Σ y_m κ_m ∫ j_j(z) (J₀(z) − J₀(zx/a)) dz/z. With
/// j_j = (−1)^m ∫ P_j(t) sin zt dt the integral is (−1)^m ∫ P_j(t) (asin t − asin(ta/x)) dt over 0 < t < 1.
pub(super) struct RoundDeflection {
    /// asin t, t, and the sum of the modes there, weight included.
    nodes: Vec<[f64; 3]>,
}

impl RoundDeflection {
    pub(super) fn new(modes: &[f64]) -> Self {
        let points = rule((modes.len() + SPARE).min(LARGEST));
        let scaled = Twin::Round.scaled(modes);
        let steps: Vec<[f64; 4]> = (0..modes.len()).map(steps).collect();
        let parts = (2 * modes.len() + SPARE).div_ceil(LARGEST);
        let width = std::f64::consts::FRAC_PI_2 / parts as f64;
        let of_part = |part: usize| points.on(width * part as f64, width * (part + 1) as f64);
        let node = |(theta, weight): (f64, f64)| {
            let (t, cos) = theta.sin_cos();
            let (mut even, mut odd, mut series) = (1.0, t, 0.0);
            for (y, [up, down, next, back]) in scaled.iter().zip(&steps) {
                series += y * odd;
                even = up * t * odd + down * even;
                odd = next * t * even + back * odd;
            }
            [theta, t, 1.5 * weight * cos * series]
        };
        Self { nodes: (0..parts).flat_map(of_part).map(node).collect() }
    }

    /// At x = a · ratio.
    pub(super) fn at(&self, ratio: f64) -> f64 {
        self.nodes.iter().map(|[theta, t, share]| share * (theta - (t / ratio).asin())).sum()
    }
}
