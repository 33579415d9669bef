//! Thin layers: amplitudes = the state at one depth, from which transfer matrices are multiplied outwards.
use nalgebra::Matrix4;

use super::slices::{Slice, inverse};
use crate::{FaceStates, State};

/// A modulus that varies by less than this factor is no reason to leave mid-depth.
const MILD: f64 = 3.0;

/// The transfer matrices, less identity, from the boundary `start` up to the top and down to the bottom.
fn outwards(slices: &[Slice], start: usize) -> [Matrix4<f64>; 2] {
    // (1 + A)(1 + B) − 1
    let after = |first: Matrix4<f64>, then: Matrix4<f64>| first + then + then * first;
    let up = slices[..start].iter().rev().fold(Matrix4::zeros(), |sum, slice| after(sum, slice.transfer));
    let down = slices[start..].iter().fold(Matrix4::zeros(), |sum, slice| after(sum, inverse(&slice.transfer)));
    [up, down]
}

/// Amplitudes = the state at mid-depth, or where the layer is softest: from there to stiffer places the terms of a
/// transfer matrix do not cancel.
pub(super) fn face_states(slices: &[Slice]) -> FaceStates {
    let [up, down] = outwards(slices, extreme(slices, f64::max));
    FaceStates::Finite { top: Matrix4::identity() + up, bottom: Matrix4::identity() + down, uniform: uniform(slices) }
}

/// The field that starts from S = 1 at mid-depth, or where the layer is stiffest: from there to softer places stresses
/// do not grow.
pub(super) fn uniform(slices: &[Slice]) -> [State; 2] {
    outwards(slices, extreme(slices, f64::min)).map(|transfer| transfer.column(2).into_owned())
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
