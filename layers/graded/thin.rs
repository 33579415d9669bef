//! Thin layers: amplitudes = the state at one depth, from which transfer matrices are multiplied outwards.
use nalgebra::Matrix4;

use super::slices::{Slice, inverse};
use crate::{FaceStates, InnerStates, LayerStates, State};

/// A modulus that varies by less than this factor is no reason to leave mid-depth.
const MILD: f64 = 3.0;

/// The transfer matrices, less identity, from the boundary `start` to all boundaries, from the top down.
fn outwards(slices: &[Slice], start: usize) -> Vec<Matrix4<f64>> {
    // (1 + A)(1 + B) − 1
    let after = |first: &Matrix4<f64>, then: &Matrix4<f64>| first + then + then * first;
    let mut all = vec![Matrix4::zeros(); slices.len() + 1];
    for i in (0..start).rev() {
        all[i] = after(&all[i + 1], &slices[i].transfer);
    }
    for i in start..slices.len() {
        all[i + 1] = after(&all[i], &inverse(&slices[i].transfer));
    }
    all
}

/// Amplitudes = the state at mid-depth, or where the layer is softest: from there to stiffer places the terms of a
/// transfer matrix do not cancel. States at the faces and at some of the boundaries.
pub(super) fn states(slices: &[Slice], at: &[usize]) -> LayerStates {
    let transfers = outwards(slices, extreme(slices, f64::max));
    let uniform = uniform(slices);
    let columns = |i: usize| Matrix4::identity() + transfers[i];
    let last = slices.len();
    LayerStates {
        faces: FaceStates::Finite { top: columns(0), bottom: columns(last), uniform: [uniform[0], uniform[last]] },
        inside: at.iter().map(|i| InnerStates { columns: columns(*i), uniform: uniform[*i] }).collect(),
    }
}

/// The field that starts from S = 1 at mid-depth, or where the layer is stiffest: from there to softer places stresses
/// do not grow. At all boundaries.
pub(super) fn uniform(slices: &[Slice]) -> Vec<State> {
    outwards(slices, extreme(slices, f64::min)).iter().map(|transfer| transfer.column(2).into_owned()).collect()
}

/// The boundary between slices where the compliance is extreme; the middle one if it is about the same everywhere.
fn extreme(slices: &[Slice], more: fn(f64, f64) -> f64) -> usize {
    let compliance = |i: usize| {
        let slice = |i: usize| slices.get(i).map(|slice| slice.softness);
        let (above, below) = (i.checked_sub(1).and_then(slice), slice(i));
        0.5 * (above.or(below).unwrap_or(0.0) + below.or(above).unwrap_or(0.0))
    };
    let among = |pick: fn(f64, f64) -> f64| (0..=slices.len()).map(compliance).reduce(pick).unwrap_or(0.0);
    let mild = among(f64::max) <= MILD * among(f64::min);
    let wanted = among(more);
    let thickness: f64 = slices.iter().map(|slice| slice.thickness).sum();
    let (mut chosen, mut off_centre, mut depth) = (0, f64::INFINITY, 0.0);
    for i in 0..=slices.len() {
        let distance = (depth - 0.5 * thickness).abs();
        // equal places are told apart by their distance from the middle
        if (mild || compliance(i) == wanted) && distance < off_centre {
            (chosen, off_centre) = (i, distance);
        }
        depth += slices.get(i).map_or(0.0, |slice| slice.thickness);
    }
    chosen
}
