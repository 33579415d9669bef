//! Fields inside the chains at one wavenumber: back substitution of the eliminated amplitudes, layer by layer.
use std::ops::Range;

use nalgebra::{Matrix2, Vector2, Vector3, Vector4};
use recede_layers::{FaceStates, InnerStates, LayerStates, State, Wave, solve_equilibrated};

use super::base::BaseChain;
use super::cut_off::cut_off;
use super::free::{FreeChain, faces};
use super::half::{PutBack, displacement, stacked, stress, uniform};
use super::repeats::JoinedLayers;

/// Amplitudes S of loads on the shear-free faces of a chain.
///
/// Nearly equal loads on both faces of a thin laminate are to be given as `equal` and the small difference: the responses to either load
/// alone would cancel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FaceLoad {
    /// On the top face alone.
    pub top: f64,
    /// On the bottom face alone; of no meaning for a base.
    pub bottom: f64,
    /// On both faces.
    pub equal: f64,
}

impl FreeChain {
    /// The states (λμ₀U, λμ₀V, S, T) at `depths` below the top faces of the layers, which ascend for each of them; `None` if a
    /// layer's states are not finite or do not determine its fields.
    pub fn states(&self, wave: &Wave, depths: &[Vec<f64>], load: &FaceLoad) -> Option<Vec<Vec<State>>> {
        let count = self.layers.len();
        let Some([above, below]) = self.decayed(wave) else {
            return self.states_of(0..count, self.meeting, wave, depths, load);
        };
        let from_top = FaceLoad { top: load.top + load.equal, ..FaceLoad::default() };
        let from_bottom = FaceLoad { bottom: load.bottom + load.equal, ..FaceLoad::default() };
        let mut states = self.states_of(0..above, 0, wave, depths, &from_top)?;
        states.extend(depths[above..below].iter().map(|depths| vec![State::zeros(); depths.len()]));
        states.extend(self.states_of(below..count, count, wave, depths, &from_bottom)?);
        Some(states)
    }

    /// Some of the layers, eliminated from both faces to the interface above layer `meeting` and put back.
    fn states_of(
        &self,
        range: Range<usize>,
        meeting: usize,
        wave: &Wave,
        depths: &[Vec<f64>],
        load: &FaceLoad,
    ) -> Option<Vec<Vec<State>>> {
        let states: Vec<LayerStates> = range.clone().map(|i| self.layers[i].states(wave, &depths[i])).collect();
        if let [single] = &states[..] {
            return Some(vec![single_layer(single, load)?]);
        }
        let of = |i: usize| &states[i - range.start];
        let body = |i: usize| JoinedLayers { layers: i..i + 1, states: of(i).faces };
        let (mut down, mut up) = ((range.start..meeting).map(body), (meeting..range.end).rev().map(body));
        let mut eliminated: [Vec<(usize, PutBack)>; 2] = Default::default();
        let keep = |side: usize, layer, put_back| eliminated[side].push((layer, put_back));
        let (_, displacements) = self.eliminate(&range, meeting, wave, [&mut down, &mut up], keep)?;
        let loads = Vector3::new(load.top, load.bottom, load.equal);
        let mut found = vec![Vec::new(); range.len()];
        for (side, eliminated) in eliminated.iter().enumerate() {
            let on_face = if side == 0 { load.top } else { load.bottom };
            let mut w: Vector2<f64> = displacements[side] * loads;
            for (i, PutBack { amplitudes, before }) in eliminated.iter().rev() {
                let by = Vector4::new(w[0], w[1], on_face, load.equal);
                let amplitudes = amplitudes * by;
                let [(near, uniform), _] = faces(&of(*i).faces, side)?;
                w = match before {
                    Some(before) => before * by,
                    None => displacement(near) * amplitudes + uniform.fixed_rows::<2>(0) * load.equal,
                };
                found[i - range.start] = combine(&of(*i).inside, &amplitudes, load.equal)?;
            }
        }
        Some(found)
    }
}

/// One layer alone: its amplitudes from the stresses on both faces.
fn single_layer(states: &LayerStates, load: &FaceLoad) -> Option<Vec<State>> {
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
    /// foundation, which counts as one of them, under a load S on the top face; `None` as for a laminate.
    pub fn states(&self, wave: &Wave, depths: &[Vec<f64>], load: f64) -> Option<Vec<Vec<State>>> {
        let cut_off = cut_off(&self.layers, &self.junctions, 0..self.layers.len(), wave);
        let mut found: Vec<Vec<State>> = depths.iter().map(|depths| vec![State::zeros(); depths.len()]).collect();
        let mut ground = None;
        let mut below = self.below(cut_off, wave, |column| {
            let depths = depths.get(self.layers.len()).map_or(&[][..], Vec::as_slice);
            let states = column.states(wave, depths);
            let FaceStates::HalfPlane { top } = states.faces else { return None };
            // in terms of the stresses on its face
            let amplitudes = solve_equilibrated(top.fixed_rows::<2>(2).into_owned(), Matrix2::identity())?;
            ground = Some((states.inside, amplitudes));
            Some(top * amplitudes)
        })?;
        let mut eliminated = Vec::with_capacity(cut_off);
        for i in (0..cut_off).rev() {
            let states = self.layers[i].states(wave, &depths[i]);
            let (with_layer, amplitudes, at_bottom) = self.with_layer(&below, i + 1, &states.faces, wave)?;
            below = with_layer;
            eliminated.push((states.inside, amplitudes, at_bottom));
        }
        let mut at_top = uniform() * load;
        for (i, (inside, amplitudes, at_bottom)) in eliminated.iter().rev().enumerate() {
            found[i] = combine(inside, &(amplitudes * at_top), 0.0)?;
            at_top = at_bottom * at_top;
        }
        if let (Some((inside, amplitudes)), Some(last)) = (ground, found.last_mut()) {
            let two: Vector2<f64> = amplitudes * at_top;
            *last = combine(&inside, &Vector4::new(two[0], two[1], 0.0, 0.0), 0.0)?;
        }
        Some(found)
    }
}
