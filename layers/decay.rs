//! Solutions in a homogeneous, isotropic body that decay with the distance from a face: a half-plane's, and a thick layer's.
use nalgebra::Vector4;

use crate::{Isotropic, State, Wave};

/// Factors that bring the local components (λμU, λμV, S, T) to the modulus of `wave`.
pub(crate) fn scale(material: &Isotropic, wave: &Wave) -> Vector4<f64> {
    let displacement = wave.modulus / material.shear_modulus;
    Vector4::new(displacement, displacement, 1.0, 1.0)
}

/// Eigenvector of the root m = ±1 (per λ) and its derivative with respect to m, in local components:
/// S = 1, T = −m, u = −(m² + c)/E, v = m (1 + u).
fn root(material: &Isotropic, wave: &Wave, m: f64) -> (State, State) {
    let q = 0.5 * Isotropic { shear_modulus: 1.0, ..*material }.material(wave.plane).axial_stiffness;
    let scale = scale(material, wave);
    let vector = Vector4::new(-0.5, 0.5 * m, 1.0, -m);
    let derivative = Vector4::new(-m / q, 0.5 - 1.0 / q, 0.0, -1.0);
    (vector.component_mul(&scale), derivative.component_mul(&scale))
}

/// The two solutions that decay downwards, at distance `depth` (times λ) below where they are 1.
pub(crate) fn decaying_downwards(material: &Isotropic, wave: &Wave, depth: f64) -> [State; 2] {
    let (vector, derivative) = root(material, wave, 1.0);
    decayed(vector, derivative, -depth, depth)
}

/// The two solutions that decay upwards, at distance `height` (times λ) above where they are 1.
pub(crate) fn decaying_upwards(material: &Isotropic, wave: &Wave, height: f64) -> [State; 2] {
    let (vector, derivative) = root(material, wave, -1.0);
    decayed(vector, derivative, height, height)
}

/// e^(−distance) x and its derivative with respect to the root, e^(−distance) (ζ x + x').
fn decayed(vector: State, derivative: State, zeta: f64, distance: f64) -> [State; 2] {
    let decay = (-distance).exp();
    // ζ e^(−|ζ|) is formed first: ζ alone may be as large as 1e308
    [vector * decay, vector * (zeta * decay) + derivative * decay]
}
