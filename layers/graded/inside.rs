//! States at the faces, and inside a layer: slices end at the depths asked for, and states are kept where slices meet.
use nalgebra::{Matrix2, Matrix4, Matrix4x2};

use super::clamped::{Clamped, beside, step, upside_down};
use super::slices::{Slices, inverse};
use super::surface::surface_flexibility;
use super::tree::{From, Tree};
use super::{BodyProfile, FELT, THIN, thin};
use crate::{FaceStates, InnerStates, LayerStates, State, Wave};

impl BodyProfile<'_> {
    /// States at the faces and at ascending depths, which are among the kinks, in common amplitudes.
    pub(super) fn states(&self, wave: &Wave, tree: &Tree, depths: &[f64]) -> LayerStates {
        if let Some(layer) = self.homogeneous(wave, tree).filter(|layer| !layer.is_thin()) {
            return layer.states(depths.iter().map(|depth| wave.wavenumber * depth));
        }
        self.in_units_of_tree(wave.wavenumber, tree, depths).with_displacements_times(wave.modulus / tree.modulus(self))
    }

    fn in_units_of_tree(&self, wavenumber: f64, tree: &Tree, depths: &[f64]) -> LayerStates {
        let mut slices = self.slices(tree, wavenumber, From::Top, FELT);
        let zero = Matrix4x2::zeros();
        let Some(thickness) = self.thickness else {
            let states = self.surface(&slices, From::Top, tree);
            let inside = depths.iter().map(|depth| {
                let down = if *depth > slices.depth { zero } else { states[slices.above(*depth)] };
                InnerStates::thick(beside(&down, &zero))
            });
            return LayerStates { inside: inside.collect(), faces: FaceStates::HalfPlane { top: states[0] } };
        };
        if slices.depth < thickness {
            let below = self.slices(tree, wavenumber, From::Bottom, FELT);
            if slices.depth + below.depth <= thickness {
                // the faces do not feel each other; each is the surface of a half-plane
                let down = self.surface(&slices, From::Top, tree);
                let up = self.surface(&below, From::Bottom, tree);
                let inside = depths.iter().map(|depth| {
                    let down = if *depth > slices.depth { zero } else { down[slices.above(*depth)] };
                    let up = if *depth < thickness - below.depth { zero } else { up[below.below(*depth)] };
                    InnerStates::thick(beside(&down, &up))
                });
                let faces = FaceStates::thick(beside(&down[0], &zero), beside(&zero, &up[0]));
                return LayerStates { inside: inside.collect(), faces };
            }
            slices = self.slices(tree, wavenumber, From::Top, f64::INFINITY);
        }
        let places: Vec<usize> = depths.iter().map(|depth| slices.above(*depth)).collect();
        let thick = Clamped::new(slices.list.iter().map(|slice| &slice.transfer));
        let length = slices.list.iter().map(|slice| slice.length).sum::<f64>();
        if length <= THIN && !thick.is_independent() {
            return thin::states(&slices.list, &places);
        }
        let uniform =
            if length > THIN { vec![-State::z(); slices.list.len() + 1] } else { thin::uniform(&slices.list) };
        let inside = if places.is_empty() {
            Vec::new()
        } else {
            let columns = clamped_inside(slices.list.iter().map(|slice| slice.transfer).collect());
            places.iter().map(|i| InnerStates { columns: columns[*i], uniform: uniform[*i] }).collect()
        };
        let ends = [0, slices.list.len()];
        LayerStates { faces: thick.face_states(ends.map(|i| uniform[i])), inside }
    }

    /// Two columns (λμ₀U, λμ₀V, S, T) at a face from which nothing is felt beyond the slices, for S = 1 and for T = 1 on it,
    /// and at all ends of slices from there on.
    fn surface(&self, slices: &Slices, from: From, tree: &Tree) -> Vec<Matrix4x2<f64>> {
        let end = match from {
            From::Top => slices.depth,
            From::Bottom => self.thickness.unwrap_or(0.0) - slices.depth,
        };
        let far = surface_flexibility(&(self.material)(end), tree.modulus(self));
        let transfers = slices.list.iter().rev().map(|slice| &slice.transfer);
        match from {
            From::Top => inwards(far, transfers.copied()),
            From::Bottom => inwards(upside_down(far), transfers.map(inverse)),
        }
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
