//! Fields inside the chains at one wavenumber: what was eliminated, put back layer by layer.
use std::sync::Arc;

use nalgebra::{Matrix2, Matrix4, Matrix4x2, Vector2, Vector4};
use recede_layers::{FaceStates, InnerStates, Layer, LayerStates, State, Wave, solve_equilibrated};

use super::across::{allowed_above, jumped};
use super::evaluate::{BaseChain, FreeChain, Half, displacement, felt, reciprocal, stacked, stress, with_unit_stress};
use crate::stack::{Foundation, Joint};

/// Amplitudes S of loads on the shear-free faces of a chain.
///
/// Nearly equal loads on both faces of a thin laminate are to be given as `equal` and the small rest: the answer to
/// that keeps its digits, and the answers to either load alone would cancel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Load {
    /// On the top face alone.
    pub top: f64,
    /// On the bottom face alone; of no meaning for a base.
    pub bottom: f64,
    /// On both faces.
    pub equal: f64,
}

/// Depths in ascending order for each layer of a chain; the foundation counts as one.
pub type Depths = [Vec<f64>];

impl FreeChain {
    /// The states (λμ₀U, λμ₀V, S, T) at `depths` below the top faces of the layers, in the order of the depths; `None`
    /// if a layer's states are not finite or do not determine its fields.
    pub fn states(&self, wave: &Wave, depths: &Depths, load: &Load) -> Option<Vec<Vec<State>>> {
        let layers = &self.layers[..];
        let above = felt(layers.iter(), wave);
        let below = felt(layers.iter().rev(), wave);
        if above + below <= layers.len() && above < layers.len() {
            // the faces do not feel each other, and what lies between them feels neither
            let split = layers.len() - below;
            let from_top = Load { top: load.top + load.equal, ..Load::default() };
            let from_bottom = Load { bottom: load.bottom + load.equal, ..Load::default() };
            let lower = &self.joints[split.min(self.joints.len())..];
            let mut states = free(&layers[..above], &self.joints, 0, wave, &depths[..above], &from_top)?;
            states.extend(depths[above..split].iter().map(|depths| vec![State::zeros(); depths.len()]));
            states.extend(free(&layers[split..], lower, below, wave, &depths[split..], &from_bottom)?);
            return Some(states);
        }
        free(layers, &self.joints, self.meeting, wave, depths, load)
    }
}

/// All layers of a free chain, eliminated from both faces to the interface above layer `meeting`.
fn free(
    layers: &[Arc<dyn Layer>],
    joints: &[Joint],
    meeting: usize,
    wave: &Wave,
    depths: &Depths,
    load: &Load,
) -> Option<Vec<Vec<State>>> {
    let states: Vec<LayerStates> =
        layers.iter().zip(depths).map(|(layer, depths)| layer.states(wave, depths)).collect();
    if let [single] = &states[..] {
        return Some(vec![single_layer(single, load)?]);
    }
    let mut eliminated = vec![Matrix4::zeros(); layers.len()];
    let mut jumps = vec![None; layers.len()];
    let mut halves = [Half::free(), Half::free()];
    let order: [Vec<usize>; 2] = [(0..meeting).collect(), (meeting..layers.len()).rev().collect()];
    for (side, order) in order.iter().enumerate() {
        for i in order {
            let FaceStates::Finite { top, bottom, uniform: [at_top, at_bottom] } = &states[*i].faces else {
                return None;
            };
            let (near, far) =
                if side == 0 { ((top, at_top), (bottom, at_bottom)) } else { ((bottom, at_bottom), (top, at_top)) };
            let (mut half, amplitudes) = halves[side].eliminate(near, far)?;
            eliminated[*i] = amplitudes;
            // the joint at which the halves meet belongs to the upper one
            let joint = if side == 0 { Some(*i) } else { i.checked_sub(1).filter(|above| *above >= meeting) };
            if let Some(joint) = joint.and_then(|joint| joints.get(joint)) {
                let (across, jump) = half.across(joint, wave, side == 0)?;
                (half, jumps[*i]) = (across, Some(jump));
            }
            halves[side] = half;
        }
    }
    let [above, below] = &halves;
    let rest = below.by_load * load.bottom - above.by_load * load.top + (below.by_equal - above.by_equal) * load.equal;
    let meet: Vector2<f64> = solve_equilibrated(above.stiffness - below.stiffness, rest)?;
    let mut found = vec![Vec::new(); layers.len()];
    for (side, order) in order.iter().enumerate() {
        let own = if side == 0 { load.top } else { load.bottom };
        let mut w = meet;
        for i in order.iter().rev() {
            if let Some(jump) = &jumps[*i] {
                w = jumped(jump, w, own, load.equal);
            }
            let amplitudes = eliminated[*i] * Vector4::new(w[0], w[1], own, load.equal);
            let FaceStates::Finite { top, bottom, uniform } = &states[*i].faces else { return None };
            let near = if side == 0 { top } else { bottom };
            w = displacement(near) * amplitudes + uniform[side].fixed_rows::<2>(0) * load.equal;
            found[*i] = combine(&states[*i].inside, &amplitudes, load.equal)?;
        }
    }
    Some(found)
}

/// One layer alone: its amplitudes from the stresses on both faces.
fn single_layer(states: &LayerStates, load: &Load) -> Option<Vec<State>> {
    let FaceStates::Finite { top, bottom, uniform: [at_top, at_bottom] } = &states.faces else { return None };
    let rows = stacked(&stress(top), &stress(bottom));
    #[rustfmt::skip]
    let loads = Vector4::new(
        load.top - load.equal * at_top[2],
        -load.equal * at_top[3],
        load.bottom - load.equal * at_bottom[2],
        -load.equal * at_bottom[3],
    );
    combine(&states.inside, &solve_equilibrated(rows, loads)?, load.equal)
}

/// The field of some amplitudes, and that close to uniform pressure.
fn combine(inside: &[InnerStates], amplitudes: &Vector4<f64>, equal: f64) -> Option<Vec<State>> {
    let states = inside.iter().map(|states| states.columns * amplitudes + (State::z() + states.uniform) * equal);
    let states: Vec<State> = states.collect();
    states.iter().all(|state| state.iter().all(|x| x.is_finite())).then_some(states)
}

impl BaseChain {
    /// The states (λμ₀U, λμ₀V, S, T) at `depths` below the top faces of the layers and, if it is elastic, of the
    /// foundation, under a load S on the top face; `None` as for a laminate.
    pub fn states(&self, wave: &Wave, depths: &Depths, load: f64) -> Option<Vec<Vec<State>>> {
        let felt = felt(self.layers.iter(), wave);
        let mut found: Vec<Vec<State>> = depths.iter().map(|depths| vec![State::zeros(); depths.len()]).collect();
        let (mut allowed, mut ground) = (with_unit_stress(&Matrix2::zeros()), None);
        if let (Foundation::HalfPlane(placed), true) = (&self.foundation, felt == self.layers.len()) {
            let depths = depths.last().map_or(&[][..], Vec::as_slice);
            let states = placed.layer.states(wave, depths);
            let FaceStates::HalfPlane { top } = states.faces else { return None };
            allowed = top;
            if placed.layer.has_material() {
                let stress: Matrix2<f64> = top.fixed_rows::<2>(2).into_owned();
                ground = Some((states.inside, solve_equilibrated(stress, Matrix2::identity())?));
            }
        }
        let mut eliminated = Vec::with_capacity(felt);
        for ((layer, joint), depths) in self.layers[..felt].iter().zip(&self.joints).zip(depths).rev() {
            allowed = allowed_above(allowed, joint, wave);
            let states = layer.states(wave, depths);
            let FaceStates::Finite { top, bottom, .. } = &states.faces else { return None };
            let condition = reciprocal(&allowed) * bottom;
            let amplitudes: Matrix4x2<f64> = solve_equilibrated(
                stacked(&condition, &stress(top)),
                Matrix4x2::from_fn(|i, j| if i == j + 2 { 1.0 } else { 0.0 }),
            )?;
            allowed = with_unit_stress(&(displacement(top) * amplitudes));
            let handed_on = stress(bottom) * amplitudes;
            eliminated.push((states.inside, amplitudes, handed_on));
        }
        let mut at_top = Vector2::new(load, 0.0);
        for (i, (inside, amplitudes, handed_on)) in eliminated.iter().rev().enumerate() {
            found[i] = combine(inside, &(amplitudes * at_top), 0.0)?;
            at_top = handed_on * at_top;
        }
        if let (Some((inside, amplitudes)), Some(last)) = (ground, found.last_mut()) {
            let two: Vector2<f64> = amplitudes * at_top;
            *last = combine(&inside, &Vector4::new(two[0], two[1], 0.0, 0.0), 0.0)?;
        }
        Some(found)
    }
}
