//! Closed forms for a thick layer: solutions that decay from either face, by a pair of roots.
use nalgebra::{Matrix4, Vector4};

use super::{Exponential, Local};
use crate::{FaceStates, InnerStates, State, Wave};

/// A pair of roots ±(p ± iω) of the symmetrised state matrix, per λ: p² − ω² = 1 + b²/4, 2pω = bδ with b = β/λ and
/// δ² = c = (3 − κ)/(κ + 1). For κ > 3 the pair is real, ω² < 0. Nothing is singular where roots coincide (b → 0, κ → 3).
struct Pair {
    p: f64,
    omega_squared: f64,
    b: f64,
    local: Local,
    /// p − |b|/2 and p + |b|/2.
    shifted: [f64; 2],
}

impl Pair {
    /// The paper's (2.7), written without complex numbers and without cancellation.
    fn new(local: Local, b: f64) -> Self {
        let a = 1.0 + 0.25 * b * b;
        let root = (a * a + b * b * local.c).max(0.0).sqrt();
        let p_squared = 0.5 * (a + root);
        let p = p_squared.sqrt();
        let omega_squared = 0.25 * b * b * local.c / p_squared;
        let above = 0.5 * (1.0 + (1.0 + b * b * (0.5 + local.c)) / (root + 0.25 * b * b));
        let sum = p + 0.5 * b.abs();
        Self { p, omega_squared, b, local, shifted: [above / sum, sum] }
    }

    /// The two solutions of the roots side·(p ± iω) (side = ±1) at ζ = λy, where side·ζ ≤ 0, without the factor √μ:
    /// [X, S-part] as symmetrised local components, times `stress` for S, T and `displacement` for U, V.
    fn solutions(&self, side: f64, zeta: f64, displacement: f64, stress: f64) -> [State; 2] {
        let Local { c, e, .. } = self.local;
        let w2 = self.omega_squared;
        let [less, more] = self.shifted;
        // exponent of the displacements m = σ + b/2 and of the stresses n = σ − b/2 at σ = side·p
        let same = side * self.b > 0.0;
        let (m, n) = if same { (side * more, side * less) } else { (side * less, side * more) };
        // eigenvector S = 1, T = −n, u = −(n² + c)/e, v = m u + n as a function of σ: its value over the pair, x_r,
        // and its divided difference, x_d, x(σ ± iω) = x_r ± iω x_d. In u_r stands c − ω² = c (p² − b²/4)/p².
        let u = -(n * n + c * less * more / (self.p * self.p)) / e;
        let u_difference = -2.0 * n / e;
        let value = Vector4::new(u, m * u - w2 * u_difference + n, 1.0, -n);
        let difference = Vector4::new(u_difference, u + m * u_difference + 1.0, 0.0, -1.0);
        let (cosine, sine) = self.decay(side * zeta);
        let sine = side * sine;
        let scale = Vector4::new(displacement, displacement, stress, stress);
        [
            (value * cosine - difference * (w2 * sine)).component_mul(&scale),
            (value * sine + difference * cosine).component_mul(&scale),
        ]
    }

    /// e^(pt) cos ωt and e^(pt) sin(ωt)/ω for t ≤ 0, hyperbolic if ω² < 0.
    fn decay(&self, t: f64) -> (f64, f64) {
        let omega = self.omega_squared.abs().sqrt();
        let angle = omega * t;
        if self.omega_squared >= 0.0 {
            let decay = (self.p * t).exp();
            let sinc = if angle.abs() < 1e-4 { 1.0 - angle * angle / 6.0 } else { angle.sin() / angle };
            (decay * angle.cos(), decay * t * sinc)
        } else if angle.abs() < 0.5 {
            let decay = (self.p * t).exp();
            let square = angle * angle;
            // sinh(x)/x for |x| < 1/2
            let sinhc = 1.0
                + square / 6.0
                    * (1.0 + square / 20.0 * (1.0 + square / 42.0 * (1.0 + square / 72.0 * (1.0 + square / 110.0))));
            (decay * angle.cosh(), decay * t * sinhc)
        } else {
            let (slow, fast) = (((self.p - omega) * t).exp(), ((self.p + omega) * t).exp());
            (0.5 * (slow + fast), 0.5 * (fast - slow) / omega)
        }
    }
}

impl Exponential {
    /// Amplitudes = two solutions that decay from the top face and two that decay from the bottom face.
    pub(super) fn thick(&self, wave: &Wave) -> FaceStates {
        let h = self.thickness.get();
        let z = wave.wavenumber * h;
        let pair = Pair::new(self.local(wave), self.beta.get() / wave.wavenumber);
        let [top, bottom] = [0.0, h].map(|d| self.displacement_scale(wave, d));
        // √(μ_bottom/μ_top)
        let rise = (0.5 * self.steepness()).exp();
        let [a, b] = pair.solutions(1.0, 0.0, top, 1.0);
        let [c, d] = pair.solutions(-1.0, z, bottom * rise, rise.recip());
        let top_states = Matrix4::from_columns(&[a, b, c, d]);
        let [a, b] = pair.solutions(1.0, -z, top / rise, rise);
        let [c, d] = pair.solutions(-1.0, 0.0, bottom, 1.0);
        let bottom_states = Matrix4::from_columns(&[a, b, c, d]);
        FaceStates::thick(top_states, bottom_states)
    }

    /// The same inside.
    pub(super) fn thick_inside(&self, wave: &Wave, depths: &[f64]) -> Vec<InnerStates> {
        let h = self.thickness.get();
        let pair = Pair::new(self.local(wave), self.beta.get() / wave.wavenumber);
        let [top, bottom] = [0.0, h].map(|d| self.displacement_scale(wave, d));
        let inside = depths.iter().map(|depth| {
            let (below, above) = (*depth, (h - depth).max(0.0));
            // √μ relative to either face
            let [from_top, from_bottom] = [below, -above].map(|d| (0.5 * self.beta.get() * d).exp());
            let [a, b] = pair.solutions(1.0, -wave.wavenumber * below, top / from_top, from_top);
            let [c, d] = pair.solutions(-1.0, wave.wavenumber * above, bottom / from_bottom, from_bottom);
            InnerStates::thick(Matrix4::from_columns(&[a, b, c, d]))
        });
        inside.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_those_of_the_state_matrix() {
        // s = p ± iω solves (s² − 1 − b²/4)² = −b² c, also where the pair is real (c < 0)
        for c in [-0.8, 0.0, 1.0 / 3.0, 1.0] {
            for b in [-3.0, 0.0, 1e-6, 0.5, 20.0] {
                let pair = Pair::new(Local { c, d: 0.0, e: 1.0 }, b);
                let [sum, product] = [pair.p * pair.p - pair.omega_squared, 2.0 * pair.p];
                assert!((sum / (1.0 + 0.25 * b * b) - 1.0).abs() < 1e-14, "c = {c}, b = {b}");
                let square = product * product * pair.omega_squared;
                assert!((square - b * b * c).abs() < 1e-13 * (1.0 + b * b), "c = {c}, b = {b}");
            }
        }
    }
}
