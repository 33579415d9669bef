//! States inside a layer: slices end at the depths asked for, and states are kept where slices meet.
use nalgebra::{Matrix2, Matrix4, Matrix4x2};

use super::clamped::{Clamped, beside, step, upside_down};
use super::slices::inverse;
use super::surface::surface_flexibility;
use super::{FELT, Profile, THIN, thin};
use crate::{FaceStates, InnerStates, LayerStates, State, Wave};

impl Profile<'_> {
    /// States at the faces and at ascending depths, in common amplitudes.
    pub(super) fn states(&self, wave: &Wave, depths: &[f64]) -> LayerStates {
        let Some(thickness) = self.thickness else {
            let (top, inside) = self.surface(wave, depths);
            let zero = Matrix4x2::zeros();
            let inside = inside.iter().map(|states| InnerStates::thick(beside(states, &zero))).collect();
            return LayerStates { faces: FaceStates::HalfPlane { top }, inside };
        };
        let mirrored = |depth: f64| (self.material)((thickness - depth).max(0.0));
        let mirrored = Profile { thickness: self.thickness, material: &mirrored };
        let mut slices = self.slices(wave, FELT, depths);
        if slices.depth < thickness {
            let heights: Vec<f64> = depths.iter().rev().map(|depth| (thickness - depth).max(0.0)).collect();
            if slices.depth + mirrored.slices(wave, FELT, &heights).depth <= thickness {
                // the faces do not feel each other; each is the surface of a half-plane
                let (top, from_top) = self.surface(wave, depths);
                let (bottom, from_bottom) = mirrored.surface(wave, &heights);
                let zero = Matrix4x2::zeros();
                let pairs = from_top.iter().zip(from_bottom.iter().rev());
                let inside = pairs.map(|(down, up)| InnerStates::thick(beside(down, &upside_down(*up)))).collect();
                let faces = FaceStates::thick(beside(&top, &zero), beside(&zero, &upside_down(bottom)));
                return LayerStates { faces, inside };
            }
            slices = self.slices(wave, f64::INFINITY, depths);
        }
        let at: Vec<usize> = depths.iter().map(|depth| slices.above(*depth)).collect();
        let thick = Clamped::new(slices.list.iter().map(|slice| &slice.transfer));
        let length = slices.list.iter().map(|slice| slice.length).sum::<f64>();
        if length <= THIN && !thick.is_independent() {
            return thin::states(&slices.list, &at);
        }
        let uniform =
            if length > THIN { vec![-State::z(); slices.list.len() + 1] } else { thin::uniform(&slices.list) };
        let columns = clamped_inside(slices.list.iter().map(|slice| slice.transfer).collect());
        let inside = at.iter().map(|i| InnerStates { columns: columns[*i], uniform: uniform[*i] }).collect();
        let ends = [0, slices.list.len()];
        LayerStates { faces: thick.face_states(ends.map(|i| uniform[i])), inside }
    }

    /// Two columns (λμ₀U, λμ₀V, S, T) at the top face of a layer whose bottom is not felt, for S = 1 and for T = 1, and
    /// at depths.
    pub(super) fn surface(&self, wave: &Wave, depths: &[f64]) -> (Matrix4x2<f64>, Vec<Matrix4x2<f64>>) {
        let slices = self.slices(wave, FELT, depths);
        let end = slices.depth.min(self.thickness.unwrap_or(f64::INFINITY));
        let far = surface_flexibility(&(self.material)(end), wave.modulus);
        let states = inwards(far, slices.list.iter().rev().map(|slice| slice.transfer));
        let at = |depth: f64| if depth > slices.depth { Matrix4x2::zeros() } else { states[slices.above(depth)] };
        (states[0], depths.iter().map(|depth| at(*depth)).collect())
    }
}

/// The states, from a face inwards, at all boundaries of slices up to the far face, for S = 1 and T = 1 on the face. The
/// transfer matrices, less identity, lead towards the face, beginning at the far one, where stresses and displacements
/// are related by a flexibility.
fn inwards(far: Matrix2<f64>, transfers: impl Iterator<Item = Matrix4<f64>>) -> Vec<Matrix4x2<f64>> {
    let (mut flexibilities, mut returns) = (vec![far], Vec::new());
    let mut flexibility = far;
    for transfer in transfers {
        let (next, back) = step(&flexibility, &transfer);
        flexibility = next;
        flexibilities.push(next);
        returns.push(back);
    }
    let mut stress = Matrix2::identity();
    let mut states = Vec::with_capacity(flexibilities.len());
    while let Some(flexibility) = flexibilities.pop() {
        let displacement = flexibility * stress;
        states.push(Matrix4x2::from_fn(|i, j| if i < 2 { displacement[(i, j)] } else { stress[(i - 2, j)] }));
        stress = returns.pop().unwrap_or(Matrix2::identity()) * stress;
    }
    states
}

/// The columns of a layer clamped at one or the other face, at all boundaries of its slices from the top down.
fn clamped_inside(transfers: Vec<Matrix4<f64>>) -> Vec<Matrix4<f64>> {
    let down = inwards(Matrix2::zeros(), transfers.iter().rev().copied());
    let up = inwards(Matrix2::zeros(), transfers.iter().map(inverse));
    down.iter().zip(up.iter().rev()).map(|(down, up)| beside(down, up)).collect()
}
