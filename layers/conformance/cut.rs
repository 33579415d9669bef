//! The law of layers that are one body cut in two.
use super::bonded::{bonded, bonded_to_half_plane};
use super::trial::{Trial, USUAL};
use super::{DIGITS, Violation};
use crate::{FaceStates, Layer, Plane};

/// Depths in each part at which materials are compared, in thicknesses.
const DEPTHS: [f64; 4] = [0.0, 0.3, 0.8, 1.0];

/// If a layer tells of itself, bonded below itself, that both are one layer, they are: see [`one_body`].
///
/// # Errors
/// As [`one_body`].
pub fn continues(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    one_body(layer, layer, plane)
}

/// If [`Layer::continues`] tells that two layers are one body, the whole has the thickness of both, their materials at any
/// depth, and the response of both bonded to each other. A body that ends nowhere below continues in nothing.
///
/// ```
/// use recede_layers::{Exponential, HalfPlane, Homogeneous, Plane, conformance::one_body};
/// let strip = Homogeneous::new(1.0, 80.0, 0.25)?;
/// assert_eq!(one_body(&strip, &HalfPlane::new(80.0, 0.25)?, Plane::Strain), Ok(()));
/// let [upper, lower] = [1.0, f64::exp(0.5)].map(|modulus| Exponential::new(0.5, modulus, 0.25, 1.0));
/// assert_eq!(one_body(&upper?, &lower?, Plane::Strain), Ok(()));
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
///
/// # Errors
/// The first number that differs.
pub fn one_body(above: &dyn Layer, below: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(upper) = Trial::new("continues", above, plane) else { return Ok(()) };
    let Some(whole) = above.continues(below) else { return Ok(()) };
    let Some(trial) = Trial::new("continues", &*whole, plane) else { return Ok(()) };
    let infinite = |thickness: Option<f64>| thickness.unwrap_or(f64::INFINITY);
    let first = trial.wave(USUAL[0]);
    let Some(thickness) = upper.thickness else {
        return Err(trial.violation("thickness of what continues (less than)", &first, [f64::INFINITY; 3]));
    };
    let (found, expected) = (infinite(trial.thickness), thickness + infinite(below.thickness()));
    if found != expected {
        trial.equal("thickness", &first, found, expected, DIGITS * thickness)?;
    }
    let lower = below.thickness().unwrap_or(thickness);
    for part in DEPTHS {
        for (layer, from, depth) in [(above, 0.0, part * thickness), (below, thickness, part * lower)] {
            let [found, expected] =
                [whole.material(from + depth, plane), layer.material(depth, plane)].map(|material| {
                    [material.shear_compliance, material.normal_compliance, material.coupling, material.axial_stiffness]
                });
            for (found, expected) in found.into_iter().zip(expected) {
                trial.equal("material", &first, found, expected, DIGITS * expected.abs())?;
            }
        }
    }
    for wave in USUAL.map(|z| trial.wave(z)) {
        let (above, below) = (above.face_states(&wave), below.face_states(&wave));
        if let FaceStates::HalfPlane { .. } = below {
            let expected = trial.solved(&wave, bonded_to_half_plane(&above, &below))?;
            trial.same_surface(&wave, &trial.surface(&wave, &whole.face_states(&wave))?, &expected)?;
        } else {
            let (found, expected) = (trial.flexibility(&wave)?, trial.solved(&wave, bonded(&above, &below))?);
            let tolerance = DIGITS * (expected.top * expected.bottom).abs().sqrt();
            trial.equal("C_tb", &wave, found.coupling, expected.coupling, tolerance)?;
            trial.same_but_coupling(&wave, &found, &expected)?;
        }
    }
    Ok(())
}
