//! The punch as the contact equations see it: tests of its slope, per unit of P'.
use crate::error::{Error, NoSolution};
use crate::scene::Punch;

use super::galerkin::Slopes;

/// A contact that covers this part of the punch's half-width counts as having reached the edge, where the slope of a
/// circle is infinite.
const NEARLY: f64 = 0.999;

/// A punch pressed with a force, in the units of the kernel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Indentation<'a> {
    punch: &'a Punch,
    /// Length L in the units of the scene.
    length: f64,
    /// P' = P/(μ₀L).
    pub(super) force: f64,
}

impl<'a> Indentation<'a> {
    pub(super) fn new(punch: &'a Punch, length: f64, force: f64) -> Self {
        Self { punch, length, force }
    }

    /// Half-length at which the punch ends, in units of L.
    pub(super) fn max_half_length(&self) -> Option<f64> {
        self.punch.max_half_length().map(|limit| limit / self.length)
    }

    /// The error to report if a contact has grown to `half_length` and that is the edge of the punch.
    pub(super) fn too_small(&self, half_length: f64) -> Option<Error> {
        let limit = self.max_half_length()?;
        (half_length > NEARLY * limit).then(|| {
            let reason = "the contact would reach the edge of the circle";
            NoSolution::PunchTooSmall { radius: self.punch.radius(), reason: reason.to_owned() }.into()
        })
    }

    /// Height above the tip at x (both in units of L), per unit of P'.
    pub(super) fn profile(&self, x: f64) -> f64 {
        self.punch.profile(x * self.length) / (self.length * self.force)
    }

    /// Slope at x (in units of L), per unit of P'.
    pub(super) fn slope(&self, x: f64) -> f64 {
        self.punch.slope(x * self.length) / self.force
    }

    /// ∫ f'(as) s/√(1 − s²) ds / P'.
    pub(super) fn first_row(&self, half_length: f64) -> f64 {
        self.slopes(half_length, 1).value[0]
    }

    /// (−1)^m ∫ f'(as) T_k(s)/√(1 − s²) ds / P' for k = 2m + 1 and `rows` values of m, with derivatives with respect to
    /// ln a, by Gauss-Chebyshev quadrature.
    pub(super) fn slopes(&self, half_length: f64, rows: usize) -> Slopes {
        // f'(as) is analytic up to where the punch ends: Chebyshev coefficients fall like ρ^(−k)
        let digits = self.max_half_length().map_or(0.0, |limit| {
            let ratio = (limit / half_length).max(1.0 + 1e-9);
            20.0 / (ratio + (ratio * ratio - 1.0).sqrt()).ln()
        });
        let mut slopes = Slopes { value: vec![0.0; rows], slope: vec![0.0; rows], half_length };
        let felt = rows.min(2 + (0.5 * digits.min(20_000.0)) as usize);
        let points = felt + 4 + digits.min(20_000.0) as usize;
        for q in 0..points {
            // the other half of the 2·points nodes is the mirror image
            let theta = std::f64::consts::PI * (q as f64 + 0.5) / (2 * points) as f64;
            let s = theta.cos();
            let x = half_length * s * self.length;
            let weight = std::f64::consts::PI / (points as f64 * self.force);
            let (value, slope) = (weight * self.punch.slope(x), weight * x * self.punch.curvature(x));
            // −cos(3θ), cos(5θ), ... from cos θ
            let turn = 2.0 * (2.0 * theta).cos();
            let (mut before, mut test) = (-s, s);
            for (row, derivative) in slopes.value.iter_mut().zip(&mut slopes.slope).take(felt) {
                *row += value * test;
                *derivative += slope * test;
                (before, test) = (test, -turn * test - before);
            }
        }
        slopes
    }
}
