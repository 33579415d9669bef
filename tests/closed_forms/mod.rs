//! Closed forms and published constants of contact mechanics, with which the solver is compared. It shares no code with them.
//!
//! All quantities are in any consistent units. The problem is plane; forces are per unit of length out of the plane.
//! A pressure is positive where it pushes.
//!
//! | module | content |
//! |---|---|
//! | [`hertz`] | rigid parabola and rigid cylinder on a half-plane |
//! | [`line_load`] | a strip pressed on its base by a line load: how far the contact recedes |
//! | [`mcewen`] | stresses in a half-plane under the pressure of Hertz |
//! | [`punches`] | powers, wedge, flat punches with round and with sharp corners on a half-plane |
//! | [`strip`] | flexibility of a free strip |
//!
//! The theory follows Johnson 1985; the publications are listed in `docs/references.md`.

pub mod hertz;
pub mod line_load;
pub mod mcewen;
pub mod punches;
pub mod strip;

/// An isotropic elastic material in the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elastic {
    /// μ, a stress.
    pub shear_modulus: f64,
    /// Kolosov's constant κ, from 1 (incompressible) to 3.
    pub kappa: f64,
}

impl Elastic {
    /// κ = 3 - 4ν: no strain out of the plane.
    pub fn plane_strain(shear_modulus: f64, poisson: f64) -> Self {
        Self { shear_modulus, kappa: 3.0 - 4.0 * poisson }
    }

    /// κ = (3 - ν)/(1 + ν): no stress out of the plane.
    pub fn plane_stress(shear_modulus: f64, poisson: f64) -> Self {
        Self { shear_modulus, kappa: (3.0 - poisson) / (1.0 + poisson) }
    }

    /// E* = 8μ/(κ + 1), in plane strain 2μ/(1 - ν) = E/(1 - ν²): the only constant that frictionless contact depends on.
    pub fn plane_modulus(&self) -> f64 {
        8.0 * self.shear_modulus / (self.kappa + 1.0)
    }

    /// (κ + 1)/(4μ) = 2/E*: λ times the deflection of a half-plane under the pressure cos(λx).
    pub fn flexibility(&self) -> f64 {
        (self.kappa + 1.0) / (4.0 * self.shear_modulus)
    }
}

#[test]
fn the_plane_modulus_in_plane_strain() {
    let steel = Elastic::plane_strain(80.0e9, 0.3);
    assert!((steel.plane_modulus() / (2.0 * 80.0e9 / (1.0 - 0.3)) - 1.0).abs() < 1e-15);
}
