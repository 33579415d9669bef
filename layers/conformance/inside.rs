//! The law of the fields inside.
use nalgebra::{Matrix4, Vector4};

use super::trial::{Trial, USUAL, size_over, work};
use super::{DIGITS, Violation};
use crate::graded::{BodyProfile, Tree};
use crate::{FaceStates, InnerStates, Layer, Plane, State, Wave};

/// Depths in parts of the thickness; of 1/λ for a half-plane.
const DEPTHS: [f64; 3] = [0.0, 0.35, 1.0];
/// Beyond thirty decay lengths from a face the general body takes fields for none, e^(−30).
const UNFELT: f64 = 1e-12;

/// [`crate::ClosedForm::states`], if given, are fields of the layer: between its faces and any depth they obey the state
/// equations, as the general body integrates them, and at the faces they are what is told of the faces.
///
/// # Errors
/// The first number that differs.
pub fn inside(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("inside", layer, plane) else { return Ok(()) };
    for wave in USUAL.map(|z| trial.wave(z)) {
        let unit = trial.thickness.unwrap_or(1.0 / wave.wavenumber);
        let depths = DEPTHS.map(|part| part * unit);
        let states = layer.states(&wave, &depths);
        trial.equal("number of depths", &wave, states.inside.len() as f64, DEPTHS.len() as f64, 0.0)?;
        let faces = at_faces(&states.faces);
        let material = |depth: f64| layer.material(depth, plane);
        for (depth, found) in depths.into_iter().zip(&states.inside) {
            // the whole layer once, from its top face down
            if depth < unit || faces.len() == 1 {
                let above = BodyProfile { thickness: Some(depth), material: &material, kinks: &[] };
                part(&trial, &wave, above, [&faces[0], found], &faces)?;
            }
            if let Some(bottom) = faces.get(1) {
                let material = |d: f64| material(depth + d);
                let below = BodyProfile { thickness: Some(unit - depth), material: &material, kinks: &[] };
                part(&trial, &wave, below, [found, bottom], &faces)?;
            }
        }
    }
    Ok(())
}

/// States at the top face and, if there is one, at the bottom face.
fn at_faces(faces: &FaceStates) -> Vec<InnerStates> {
    match faces {
        FaceStates::Finite { top, bottom, uniform: [at_top, at_bottom] } => {
            vec![InnerStates { columns: *top, uniform: *at_top }, InnerStates { columns: *bottom, uniform: *at_bottom }]
        }
        FaceStates::HalfPlane { top } => {
            let zero = Vector4::zeros();
            vec![InnerStates::thick(Matrix4::from_columns(&[top.column(0).into(), top.column(1).into(), zero, zero]))]
        }
    }
}

/// The fields of the amplitudes, and the one close to uniform pressure.
fn fields(states: &InnerStates) -> Vec<State> {
    let columns = states.columns.column_iter().map(|column| column.into_owned());
    // of a thick layer the last one is no field, exactly
    columns.chain([State::z() + states.uniform]).collect()
}

/// Between two depths the layer's fields do, by reciprocity, no net work with the fields of the general body. [`UNFELT`] of a
/// field's values at the layer's faces is granted.
fn part(
    trial: &Trial,
    wave: &Wave,
    between: BodyProfile,
    ends: [&InnerStates; 2],
    faces: &[InnerStates],
) -> Result<(), Violation> {
    if between.thickness <= Some(0.0) {
        let [found, expected] = ends.map(fields);
        for (x, y) in found.iter().zip(&expected) {
            for (range, quantity) in [(0, "a displacement at a face"), (2, "a stress at a face")] {
                let difference = (x - y).rows(range, 2).amax();
                trial.equal(quantity, wave, difference, 0.0, DIGITS * y.rows(range, 2).amax())?;
            }
        }
        return Ok(());
    }
    let FaceStates::Finite { top, bottom, .. } = between.face_states(wave, &Tree::default()) else { return Ok(()) };
    let [upper, lower] = ends.map(fields);
    let at_faces: Vec<Vec<State>> = faces.iter().map(fields).collect();
    for (k, (upper, lower)) in upper.iter().zip(&lower).enumerate() {
        let everywhere: Vec<State> = at_faces.iter().map(|face| face[k]).chain([*upper, *lower]).collect();
        for (other_upper, other_lower) in top.column_iter().zip(bottom.column_iter()) {
            let (other_upper, other_lower) = (other_upper.into_owned(), other_lower.into_owned());
            let others = [other_upper, other_lower];
            let size = size_over(&[*upper], &others[..1]).max(size_over(&[*lower], &others[1..]));
            let tolerance = DIGITS * size + UNFELT * size_over(&everywhere, &others);
            let [above, below] = [work(upper, &other_upper), work(lower, &other_lower)];
            trial.equal("work with fields of the general body", wave, above, below, tolerance)?;
        }
    }
    Ok(())
}
