//! The fields of a half-plane whose characteristic equation has two different roots, as for orthotropic material.
//!
//! Its fields are sums of two terms e^(−sλd), each with a closed form in x: see [`super::pressure`].
use num_complex::Complex64;
use recede_layers::Material;

use super::potentials::{At, COMPONENTS, Components, Potentials};
use super::pressure::Pressure;

/// Roots closer than this, in parts of their size, are moved apart to this distance: the difference is part of the integrated remainder.
const APART: f64 = 1e-5;

/// The fields of a half-plane per unit of p̂ on its face, as sums over the two roots.
#[derive(Clone, Debug)]
pub(super) struct Roots([Term; 2]);

#[derive(Clone, Copy, Debug)]
struct Term {
    /// s, with a positive real part; the other one is its conjugate, or real as this one.
    root: Complex64,
    /// σ_xx, σ_yy, σ_xy, λμ₀U, λμ₀V, λμ₀V.
    components: [Complex64; COMPONENTS],
}

impl Roots {
    /// Displacements are in units of 1/`modulus`; `None` if some field would not decay.
    pub(super) fn new(material: &Material, modulus: f64) -> Option<Self> {
        let [mut first, mut second] = material.squared_roots().map(Complex64::sqrt);
        if first.re <= 0.0 || second.re <= 0.0 {
            return None;
        }
        let size = first.norm();
        if (first - second).norm() < APART * size {
            let mean = 0.5 * (first + second).re;
            (first, second) = ((mean * (1.0 + 0.5 * APART)).into(), (mean * (1.0 - 0.5 * APART)).into());
        }
        // S = −1 and T = 0 on the face
        let share = (first - second).inv();
        Some(Self([(first, second * share), (second, -first * share)].map(|(s, amplitude)| {
            let along = (-s * s - material.coupling) / material.axial_stiffness * modulus;
            let across = s * (along + material.shear_compliance * modulus);
            let components = [-s * s, 1.0.into(), -s, along, across, across].map(|component| amplitude * component);
            Term { root: s, components }
        })))
    }

    /// The transformed components at t = λd; displacements are multiplied by `regular`.
    pub(super) fn transformed(&self, t: f64, regular: f64) -> Components {
        let mut sum = Components::default();
        for Term { root, components } in &self.0 {
            let decay = (-root * t).exp();
            for (i, (sum, component)) in sum.iter_mut().zip(components).enumerate() {
                let factor = if i < 3 { 1.0 } else { regular };
                *sum += factor * (component * decay).re;
            }
        }
        sum
    }

    /// The components at a point, with displacements minus those at the depth `shift` farther down, if that is finite.
    pub(super) fn closed(&self, pressure: &Pressure, at: &At, shift: f64, modulus: f64) -> Components {
        let At { x, depth, displacements } = *at;
        let mut sum = Components::default();
        for Term { root, components } in &self.0 {
            // e^(−sλd) with a complex s moves waves along x
            let (x, depth) = (x - root.im * depth, root.re * depth);
            let Potentials([stress, ..]) = pressure.potentials(x, depth);
            let (mut integral, mut slope) = (Complex64::ZERO, stress);
            if displacements {
                integral = pressure.integral(x, depth);
                if shift.is_finite() {
                    integral -= pressure.integral(x, depth + shift);
                    slope -= pressure.potentials(x, depth + shift).0[0];
                }
            }
            // cos λx, or sin λx; the slope is a derivative of the displacement
            let turned = -Complex64::I;
            let waves = [stress, stress, turned * stress, turned * integral, integral, -turned * slope];
            for (i, (sum, (component, wave))) in sum.iter_mut().zip(components.iter().zip(waves)).enumerate() {
                let factor = if i < 3 { 1.0 } else { modulus.recip() };
                *sum += factor * (component * wave).re;
            }
        }
        sum
    }
}
