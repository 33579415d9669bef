//! An exponentially graded layer, μ(d) = μ_top e^(βd): closed forms for thick layers, entry-wise accurate series for
//! thin ones, continuous at β = 0.
mod thick;
mod thin;

use std::any::Any;
use std::sync::Arc;

use nalgebra::Matrix4;
#[cfg(feature = "read")]
use schemars::JsonSchema;
use serde::Deserialize;

use crate::{
    ClosedForm, ElasticConstants, FaceStates, Finite, Flexibility, Isotropic, Key, Layer, LayerError, LayerStates,
    Material, Notation, Plane, Poisson, Positive, Thickness, Wave,
};

/// Up to this λh the amplitudes are the state at one depth; beyond, solutions that decay from either face.
const THIN: f64 = 1.0;
/// Up to this |βh| a thin layer is expanded about mid-depth, beyond from its softer face.
const MILD: f64 = 1.0;
/// Steeper layers are refused: the modulus would vary by more than e^±100.
const STEEPEST: f64 = 100.0;
/// Moduli that differ by no more than this, relative, and by as much for each unit of βh, are equal but for rounding.
const EQUAL: f64 = 4.0 * f64::EPSILON;

/// Isotropic layer of constant Poisson's ratio whose shear modulus is μ_top e^(βd) at depth d below its top face.
///
/// ```
/// use recede_layers::{Exponential, Layer, Plane};
/// let graded = Exponential::new(1.0, 1.0, 0.25, -1.0)?;
/// let bottom = graded.material(1.0, Plane::Strain);
/// assert!((1.0 / bottom.shear_compliance - (-1.0f64).exp()).abs() < 1e-15);
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(try_from = "ExponentialFields")]
pub struct Exponential {
    thickness: Thickness,
    /// At the top face.
    constants: ElasticConstants,
    beta: Finite,
}

/// The fields as written in a scene, before they are checked together.
#[derive(Deserialize)]
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(deny_unknown_fields, rename = "Exponential")]
struct ExponentialFields {
    /// Thickness h, in length.
    thickness: Thickness,
    /// Shear modulus μ at the top face, in stress; or in its place `young`.
    #[serde(default)]
    shear_modulus: Option<Positive>,
    /// Young's modulus E at the top face, in stress; or in its place `shear_modulus`.
    #[serde(default)]
    young: Option<Positive>,
    /// Poisson's ratio ν, dimensionless.
    poisson: Poisson,
    /// Grading exponent β, in 1/length: the modulus at depth d is that at the top face times exp(beta d).
    beta: Finite,
}

#[cfg(feature = "read")]
described!(Exponential by ExponentialFields);

impl TryFrom<ExponentialFields> for Exponential {
    type Error = LayerError;

    fn try_from(fields: ExponentialFields) -> Result<Self, LayerError> {
        let ExponentialFields { thickness, shear_modulus, young, poisson, beta } = fields;
        Self::checked(thickness, ElasticConstants::read(shear_modulus, young, poisson)?, beta)
    }
}

impl Exponential {
    fn checked(thickness: Thickness, constants: ElasticConstants, beta: Finite) -> Result<Self, LayerError> {
        let found = beta.get() * thickness.get();
        if found.abs() <= STEEPEST {
            Ok(Self { thickness, constants, beta })
        } else {
            Err(LayerError::TooSteep { found, limit: STEEPEST })
        }
    }

    /// A layer of thickness h ≥ 0 (length; 0 means "not there"), shear modulus μ_top > 0 at its top face (stress),
    /// Poisson's ratio −1 < ν ≤ 1/2 and grading exponent β (1/length, positive: stiffer with depth), |βh| ≤ 100.
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite.
    pub fn new(thickness: f64, shear_modulus: f64, poisson: f64, beta: f64) -> Result<Self, LayerError> {
        let constants = ElasticConstants::new(shear_modulus, poisson)?;
        Self::checked(LayerError::checked("thickness", thickness)?, constants, LayerError::checked("beta", beta)?)
    }

    fn at(&self, depth: f64) -> Isotropic {
        let Isotropic { shear_modulus, poisson } = self.constants.isotropic();
        Isotropic { shear_modulus: shear_modulus * (self.beta.get() * depth).exp(), poisson }
    }

    /// βh.
    fn steepness(&self) -> f64 {
        self.beta.get() * self.thickness.get()
    }

    fn local(&self, wave: &Wave) -> Local {
        let unit = Isotropic { shear_modulus: 1.0, ..self.constants.isotropic() }.material(wave.plane);
        Local { c: unit.coupling, d: unit.normal_compliance, e: unit.axial_stiffness }
    }

    /// μ₀/μ at a depth: brings local displacements λμU to the modulus of `wave`.
    fn displacement_scale(&self, wave: &Wave, depth: f64) -> f64 {
        wave.modulus / self.at(depth).shear_modulus
    }
}

/// Coefficients of the state equations for μ = 1.
#[derive(Clone, Copy, Debug)]
struct Local {
    c: f64,
    d: f64,
    e: f64,
}

impl Local {
    /// The state matrix A of the local components (λμU, λμV, S, T) in ζ = λy, without the grading.
    #[rustfmt::skip]
    fn matrix(&self) -> Matrix4<f64> {
        Matrix4::new(
            0.0,     1.0,  0.0,     1.0,
            -self.c, 0.0,  self.d,  0.0,
            0.0,     0.0,  0.0,    -1.0,
            self.e,  0.0,  self.c,  0.0,
        )
    }
}

impl Layer for Exponential {
    fn thickness(&self) -> Option<f64> {
        Some(self.thickness.get())
    }

    fn material(&self, depth: f64, plane: Plane) -> Material {
        self.at(depth).material(plane)
    }

    fn closed_form(&self) -> Option<&dyn ClosedForm> {
        Some(self)
    }

    fn key(&self) -> Option<Key> {
        let Isotropic { shear_modulus, poisson } = self.constants.isotropic();
        Some(Key::of::<Self>().with([self.thickness.get(), shear_modulus, poisson, self.beta.get()]))
    }

    fn continues(&self, below: &dyn Layer) -> Option<Arc<dyn Layer>> {
        let below: &dyn Any = below;
        let other = below.downcast_ref::<Self>()?;
        let (bottom, top) = (self.at(self.thickness.get()), other.constants.isotropic());
        let difference = (top.shear_modulus - bottom.shear_modulus).abs();
        let equal = difference <= EQUAL * (1.0 + self.steepness().abs()) * bottom.shear_modulus;
        let thickness = Thickness::try_from(self.thickness.get() + other.thickness.get()).ok()?;
        let whole = || Self::checked(thickness, self.constants, self.beta).ok();
        let one = equal && (bottom.poisson, self.beta) == (top.poisson, other.beta);
        one.then(whole).flatten().map(|whole| Arc::new(whole) as _)
    }

    fn notation(&self) -> Notation {
        self.constants.noted(Notation::of::<Self>().with("thickness", &self.thickness)).with("beta", &self.beta)
    }
}

impl ClosedForm for Exponential {
    fn face_states(&self, wave: &Wave) -> FaceStates {
        if wave.wavenumber * self.thickness.get() > THIN {
            self.thick(wave)
        } else if self.steepness().abs() <= MILD {
            self.mild(wave).face_states()
        } else {
            self.steep(wave).face_states(self.beta.get() > 0.0)
        }
    }

    fn states(&self, wave: &Wave, depths: &[f64]) -> Option<LayerStates> {
        if wave.wavenumber * self.thickness.get() > THIN {
            Some(LayerStates { faces: self.thick(wave), inside: self.thick_inside(wave, depths) })
        } else if self.steepness().abs() <= MILD {
            Some(LayerStates { faces: self.mild(wave).face_states(), inside: self.mild_inside(wave, depths) })
        } else {
            None
        }
    }

    fn flexibility(&self, wave: &Wave) -> Option<Flexibility> {
        if wave.wavenumber * self.thickness.get() > THIN {
            Flexibility::of_face_states(&self.thick(wave))
        } else if self.steepness().abs() <= MILD {
            self.mild(wave).flexibility()
        } else {
            self.steep(wave).flexibility(self.beta.get() > 0.0)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_modulus_that_varies_too_much_is_refused() {
        assert!(Exponential::new(2.0, 1.0, 0.25, 50.0).is_ok());
        let error = Exponential::new(2.0, 1.0, 0.25, -50.1).expect_err("too steep");
        assert_eq!(error, LayerError::TooSteep { found: -100.2, limit: STEEPEST });
    }
}
