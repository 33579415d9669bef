//! An exponentially graded half-plane, μ(d) = μ_top e^(βd) with β ≥ 0.

#[cfg(feature = "read")]
use schemars::JsonSchema;
use serde::Deserialize;

use crate::{
    ElasticConstants, Isotropic, Key, Layer, LayerError, Material, Notation, Plane, Poisson, Positive, Stiffening,
};

/// So deep a material is rigid, and its modulus still a finite number.
const RIGID: f64 = 300.0;

/// Isotropic half-plane of constant Poisson's ratio whose shear modulus is μ_top e^(βd) at depth d below its face.
///
/// Only β ≥ 0 is a base: a half-plane whose modulus falls like an exponential is, for long waves, a plate that rests on
/// nothing, and carries no force. It is left to the general body: the closed form of an exponential layer loses its digits
/// where waves are much longer than 1/β.
///
/// ```
/// use recede_layers::GradedHalfPlane;
/// let ground = GradedHalfPlane::new(1.0, 0.25, 0.5)?;
/// assert!(GradedHalfPlane::new(1.0, 0.25, -0.5).is_err());
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(try_from = "GradedHalfPlaneFields")]
pub struct GradedHalfPlane {
    /// At the face.
    constants: ElasticConstants,
    beta: Stiffening,
}

/// The fields as written in a scene, before they are checked together.
#[derive(Deserialize)]
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(deny_unknown_fields, rename = "GradedHalfPlane")]
struct GradedHalfPlaneFields {
    /// Shear modulus μ at the face, in stress; or in its place `young`.
    #[serde(default)]
    shear_modulus: Option<Positive>,
    /// Young's modulus E at the face, in stress; or in its place `shear_modulus`.
    #[serde(default)]
    young: Option<Positive>,
    /// Poisson's ratio ν, dimensionless.
    poisson: Poisson,
    /// Grading exponent β, in 1/length: the modulus at depth d is that at the face times exp(beta d).
    beta: Stiffening,
}

#[cfg(feature = "read")]
described!(GradedHalfPlane by GradedHalfPlaneFields);

impl TryFrom<GradedHalfPlaneFields> for GradedHalfPlane {
    type Error = LayerError;

    fn try_from(fields: GradedHalfPlaneFields) -> Result<Self, LayerError> {
        let GradedHalfPlaneFields { shear_modulus, young, poisson, beta } = fields;
        Ok(Self { constants: ElasticConstants::read(shear_modulus, young, poisson)?, beta })
    }
}

impl GradedHalfPlane {
    /// A half-plane of shear modulus μ_top > 0 at its face (stress), Poisson's ratio −1 < ν ≤ 1/2 and grading exponent
    /// β ≥ 0 (1/length).
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite.
    pub fn new(shear_modulus: f64, poisson: f64, beta: f64) -> Result<Self, LayerError> {
        Ok(Self { constants: ElasticConstants::new(shear_modulus, poisson)?, beta: LayerError::checked("beta", beta)? })
    }
}

impl Layer for GradedHalfPlane {
    fn thickness(&self) -> Option<f64> {
        None
    }

    fn material(&self, depth: f64, plane: Plane) -> Material {
        let growth = (self.beta.get() * depth).min(RIGID).exp();
        let Isotropic { shear_modulus, poisson } = self.constants.isotropic();
        Isotropic { shear_modulus: shear_modulus * growth, poisson }.material(plane)
    }

    fn key(&self) -> Option<Key> {
        let Isotropic { shear_modulus, poisson } = self.constants.isotropic();
        Some(Key::of::<Self>().with([shear_modulus, poisson, self.beta.get()]))
    }

    fn notation(&self) -> Notation {
        self.constants.noted(Notation::of::<Self>()).with("beta", &self.beta)
    }
}
