//! The laws of long and of short waves: the layer as a beam, its faces as half-planes.
use super::trial::Trial;
use super::{DIGITS, Violation};
use crate::graded::surface_flexibility;
use crate::{Layer, Material, Plane};

/// A free body under a long wave is moved as one: C_tt, −C_tb and −C_bb become the same and grow like λ⁻⁴, while
/// the response to equal loads, which are in equilibrium, grows at most like λ⁻².
///
/// # Errors
/// The first number that is not in proportion.
pub fn free_body(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("free_body", layer, plane) else { return Ok(()) };
    let Some(beam) = trial.beam() else { return Ok(()) };
    let [wave, longer] = [beam.wave(1.0), beam.wave(0.5)];
    let [c, long] = [trial.flexibility(&wave)?, trial.flexibility(&longer)?];
    let tolerance = DIGITS * c.top.abs();
    trial.equal("C_tb", &wave, -c.coupling, c.top, tolerance)?;
    trial.equal("C_bb", &wave, -c.bottom, c.top, tolerance)?;
    trial.equal("λμ₀C_tt against its value at half the wavenumber", &wave, 8.0 * c.top, long.top, DIGITS * long.top)?;
    for (quantity, x, y) in [
        ("λμ₀(C_tt + C_tb) against its value at half the wavenumber", c.equal_top, long.equal_top),
        ("λμ₀(C_bt + C_bb) against its value at half the wavenumber", c.equal_bottom, long.equal_bottom),
    ] {
        // λ⁻¹, or a smaller power where it is absent; what rounding leaves of the larger response is no response
        let largest = 2.0 * x.abs() * (1.0 + DIGITS) + beam.equal_loads_resolution();
        trial.equal(quantity, &wave, y, 0.0, largest)?;
    }
    Ok(())
}

/// Beam theory: λ⁴C → 1/D with the bending stiffness D about the neutral axis; equal loads p bend a beam by the moment
/// ∫ c (y − y₀) p dy of their transverse strain.
///
/// # Errors
/// The first number that differs from the number of the beam.
pub fn long_wave(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("long_wave", layer, plane) else { return Ok(()) };
    let Some(beam) = trial.beam() else { return Ok(()) };
    let wave = beam.wave(1.0);
    let c = trial.flexibility(&wave)?;
    let bending = wave.modulus / (beam.stiffness * wave.wavenumber.powi(3));
    trial.equal("C_tt", &wave, c.top, bending, DIGITS * bending)?;
    trial.equal("C_bb", &wave, c.bottom, -bending, DIGITS * bending)?;
    let equal = wave.modulus * beam.moment / (beam.stiffness * wave.wavenumber);
    let tolerance = DIGITS * equal.abs() + beam.equal_loads_resolution();
    trial.equal("C_tt + C_tb", &wave, c.equal_top, equal, tolerance)?;
    trial.equal("C_bt + C_bb", &wave, c.equal_bottom, equal, tolerance)
}

/// A short wave sees a half-plane of the material at the face: λC_tt → (κ + 1)/(4μ) for an isotropic one. Granted is
/// the variation of the material over the depth that the wave feels.
///
/// # Errors
/// The first face that differs from that half-plane.
pub fn short_wave(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("short_wave", layer, plane) else { return Ok(()) };
    let wave = trial.wave(1e8);
    let felt = 30.0 / wave.wavenumber;
    let face = |depth: f64, inside: f64| {
        let [at, near] = [layer.material(depth, plane), layer.material(inside, plane)];
        let coefficients = |m: &Material| [m.shear_compliance, m.axial_stiffness, 1.0 + m.coupling];
        let ratio = coefficients(&at).into_iter().zip(coefficients(&near)).map(|(a, b)| (a / b).ln().abs());
        let expected = surface_flexibility(&at, wave.modulus)[(1, 0)];
        (expected, expected * (DIGITS + 4.0 * ratio.fold(0.0, f64::max)))
    };
    let (top, tolerance) = face(0.0, felt);
    let Some(thickness) = trial.thickness else {
        let found = trial.surface(&wave, &layer.face_states(&wave))?[(1, 0)];
        return trial.equal("V under S", &wave, found, top, tolerance);
    };
    let c = trial.flexibility(&wave)?;
    trial.equal("C_tt", &wave, c.top, top, tolerance)?;
    let (bottom, tolerance) = face(thickness, thickness - felt);
    trial.equal("C_bb", &wave, c.bottom, -bottom, tolerance)
}
