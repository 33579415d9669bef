//! The law of keys: layers with equal keys are the same.
use super::Violation;
use super::trial::{Trial, USUAL};
use crate::{Layer, Plane};

/// Depths at which materials are compared, in thicknesses, or as lengths in a half-plane.
const DEPTHS: [f64; 5] = [0.0, 0.1, 0.5, 0.9, 1.0];

/// The key of a layer is always the same one, and so are its fields: see [`same_key`].
///
/// # Errors
/// As [`same_key`].
pub fn identity(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("identity", layer, plane) else { return Ok(()) };
    if layer.key() != layer.key() {
        return Err(trial.violation("a key asked for twice", &trial.wave(USUAL[0]), [f64::NAN; 3]));
    }
    same_key(layer, layer, plane)
}

/// If the [keys](Layer::key) of two layers are equal, so are thickness, material and states at the faces, to the last bit: one of
/// them is evaluated in place of the other. A layer whose key leaves out a parameter breaks this.
///
/// ```
/// use recede_layers::{Homogeneous, Plane, conformance::same_key};
/// let strip = |modulus| Homogeneous::new(1.0, modulus, 0.25);
/// assert_eq!(same_key(&strip(1.0)?, &strip(1.0)?, Plane::Strain), Ok(()));
/// assert_eq!(same_key(&strip(1.0)?, &strip(2.0)?, Plane::Strain), Ok(()), "other keys may be other layers");
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
///
/// # Errors
/// The first number that differs.
pub fn same_key(one: &dyn Layer, other: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("identity", one, plane) else { return Ok(()) };
    if one.key().is_none() || one.key() != other.key() {
        return Ok(());
    }
    let first = trial.wave(USUAL[0]);
    let infinite = |layer: &dyn Layer| layer.thickness().unwrap_or(f64::INFINITY);
    if infinite(one) != infinite(other) {
        let found = [infinite(other), infinite(one), 0.0];
        return Err(trial.violation("thickness of what has the same key", &first, found));
    }
    for part in DEPTHS {
        let depth = part * trial.thickness.unwrap_or(1.0);
        let [expected, found] = [one, other].map(|layer| layer.material(depth, plane));
        if expected != found {
            let moduli = [found.axial_stiffness, expected.axial_stiffness, 0.0];
            return Err(trial.violation("material of what has the same key", &first, moduli));
        }
    }
    for wave in USUAL.map(|z| trial.wave(z)) {
        if one.face_states(&wave) != other.face_states(&wave) {
            return Err(trial.violation("face states of what has the same key", &wave, [f64::NAN; 3]));
        }
    }
    Ok(())
}
