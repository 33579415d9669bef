//! The layer as a beam, by quadrature of its material.
use super::DIGITS;
use super::trial::Trial;
use crate::Wave;
use crate::graded::BodyProfile;

impl Trial<'_> {
    /// The layer as a beam; `None` for a half-plane.
    pub fn beam(&self) -> Option<Beam> {
        let h = self.thickness?;
        let material = |depth| self.layer.material(depth, self.plane);
        let profile = BodyProfile { thickness: self.thickness, material: &material, kinks: &[] };
        let [stretching, first, compliance] = profile.integrate(|m, depth| {
            [m.axial_stiffness, m.axial_stiffness * depth, m.shear_compliance + m.normal_compliance]
        });
        let neutral = first / stretching;
        let [stiffness, moment] =
            profile.integrate(|m, d| [m.axial_stiffness * (d - neutral).powi(2), m.coupling * (d - neutral)]);
        // the next terms are of relative order λ² h² and, for shear and compression, λ² D ∫(1/c66 + 1/c22)/h²
        let next = h * h + stiffness * compliance / (h * h);
        let wavenumber = (0.01 * DIGITS / next).sqrt();
        Some(Beam {
            stiffness,
            moment,
            thickness: h,
            unit: Wave { wavenumber, modulus: self.modulus, plane: self.plane },
        })
    }
}

/// What beam theory needs to know of a layer.
pub(super) struct Beam {
    /// D = ∫ E (y − y₀)² dy.
    pub stiffness: f64,
    /// −∫ c (y − y₀) dy.
    pub moment: f64,
    thickness: f64,
    /// A wave long enough for beam theory.
    unit: Wave,
}

impl Beam {
    pub fn wave(&self, factor: f64) -> Wave {
        Wave { wavenumber: factor * self.unit.wavenumber, ..self.unit }
    }

    /// To which the response to equal loads is known, the wave being of finite length and numbers rounded.
    pub fn equal_loads_resolution(&self) -> f64 {
        DIGITS * self.unit.modulus * self.thickness.powi(2) / (self.stiffness * self.unit.wavenumber)
    }
}
