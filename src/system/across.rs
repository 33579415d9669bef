//! Across the joints of a chain: displacements jump as the stresses there allow, stresses do not.
//!
//! With κ = k/(λμ₀) a joint of stiffness k obeys α·jump = β·stress, α = κ/(1 + κ) and β = 1/(1 + κ), for displacements
//! times λμ₀. So bonded (κ = ∞) and sliding (κ = 0) are no special cases, and stiff or soft springs lose no digits.
use nalgebra::{Matrix2, Matrix2x4, Matrix4x2, Vector2};
use recede_layers::{Wave, solve_equilibrated};

use super::evaluate::Half;
use crate::stack::Joint;

/// Rows of u and v among the displacements, of σ_yy and σ_xy among the stresses.
const DISPLACEMENT: [usize; 2] = [0, 1];
const STRESS: [usize; 2] = [1, 0];

/// α and β of the displacements u and v.
fn shares(joint: &Joint, wave: &Wave) -> [(f64, f64); 2] {
    [joint.tangential, joint.normal].map(|stiffness| {
        let kappa = stiffness / (wave.wavenumber * wave.modulus);
        if kappa > 1.0 {
            (1.0 / (1.0 + kappa.recip()), kappa.recip() / (1.0 + kappa.recip()))
        } else {
            (kappa / (1.0 + kappa), 1.0 / (1.0 + kappa))
        }
    })
}

impl Half {
    /// The half seen from the other side of a joint, and how much the displacements differ there: columns for the
    /// displacements on the other side, for the load and for equal loads. `above` tells whether the half lies above.
    pub(super) fn across(self, joint: &Joint, wave: &Wave, above: bool) -> Option<(Self, Matrix2x4<f64>)> {
        if *joint == Joint::BONDED {
            return Some((self, Matrix2x4::zeros()));
        }
        let sign = if above { 1.0 } else { -1.0 };
        let shares = shares(joint, wave);
        // (±α − βK) jump = β (K w + loads), row by row
        let mut rows = Matrix2::zeros();
        let mut loads = Matrix2x4::zeros();
        for (row, (alpha, beta)) in shares.iter().enumerate() {
            let stress = STRESS[row];
            rows.set_row(row, &(self.stiffness.row(stress) * -*beta));
            rows[(row, DISPLACEMENT[row])] += sign * alpha;
            loads.fixed_view_mut::<1, 2>(row, 0).copy_from(&(self.stiffness.row(stress) * *beta));
            loads[(row, 2)] = beta * self.by_load[stress];
            loads[(row, 3)] = beta * (self.by_equal[stress] + uniform(stress));
        }
        let jump: Matrix2x4<f64> = solve_equilibrated(rows, loads)?;
        let (by_jump, face) = (self.stiffness * jump, self.face * jump);
        let mut half = Self {
            stiffness: self.stiffness + by_jump.fixed_columns::<2>(0),
            by_load: self.by_load + by_jump.column(2),
            by_equal: self.by_equal + by_jump.column(3),
            face: self.face + face.fixed_columns::<2>(0),
            face_by_load: self.face_by_load + face[2],
            face_by_equal: self.face_by_equal + face[3],
        };
        // where the joint is soft its stress follows from the jump, without cancellation
        for (row, (alpha, beta)) in shares.iter().enumerate().filter(|(_, (alpha, beta))| alpha < beta) {
            let (stress, kappa) = (STRESS[row], sign * alpha / beta);
            half.stiffness.set_row(stress, &(jump.fixed_view::<1, 2>(row, 0) * kappa));
            half.by_load[stress] = kappa * jump[(row, 2)];
            half.by_equal[stress] = kappa * jump[(row, 3)] - uniform(stress);
        }
        Some((half, jump))
    }
}

/// The load itself, over which the stresses under equal loads are counted: σ_yy only.
fn uniform(stress: usize) -> f64 {
    if stress == 0 { 1.0 } else { 0.0 }
}

/// Displacements on the near side of a joint from those on the far side.
pub(super) fn jumped(jump: &Matrix2x4<f64>, w: Vector2<f64>, load: f64, equal: f64) -> Vector2<f64> {
    w + jump * nalgebra::Vector4::new(w[0], w[1], load, equal)
}

/// The states that a base allows above a joint, from those below it.
pub(super) fn allowed_above(mut allowed: Matrix4x2<f64>, joint: &Joint, wave: &Wave) -> Matrix4x2<f64> {
    if *joint == Joint::BONDED {
        return allowed;
    }
    for (row, (alpha, beta)) in shares(joint, wave).into_iter().enumerate() {
        let stress = 2 + STRESS[row];
        // one column has the stress, the other has none
        if allowed[(stress, 0)].abs() < allowed[(stress, 1)].abs() {
            allowed.swap_columns(0, 1);
        }
        let with = allowed[(stress, 0)];
        if with == 0.0 {
            continue;
        }
        let without = allowed.column(1) - allowed.column(0) * (allowed[(stress, 1)] / with);
        allowed.set_column(1, &without);
        allowed[(stress, 1)] = 0.0;
        let mut jumped = allowed.column(0) * alpha;
        jumped[DISPLACEMENT[row]] += beta * with;
        allowed.set_column(0, &jumped);
    }
    allowed
}
