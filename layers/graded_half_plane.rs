//! An exponentially graded half-plane, μ(d) = μ_top e^(βd) with β ≥ 0.
#[cfg(feature = "read")]
use schemars::JsonSchema;
use serde::Deserialize;

use crate::{Isotropic, Key, Layer, LayerError, Material, Plane, Poisson, Positive, Stiffening};

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
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct GradedHalfPlane {
    /// Shear modulus at the face, in stress.
    shear_modulus: Positive,
    /// Poisson's ratio ν.
    poisson: Poisson,
    /// Grading exponent β, in 1/length: the modulus at depth d is shear_modulus exp(beta d).
    beta: Stiffening,
}

impl GradedHalfPlane {
    /// A half-plane of shear modulus μ_top > 0 at its face (stress), Poisson's ratio −1 < ν ≤ 1/2 and grading exponent
    /// β ≥ 0 (1/length).
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite.
    pub fn new(shear_modulus: f64, poisson: f64, beta: f64) -> Result<Self, LayerError> {
        Ok(Self {
            shear_modulus: LayerError::checked("shear_modulus", shear_modulus)?,
            poisson: LayerError::checked("poisson", poisson)?,
            beta: LayerError::checked("beta", beta)?,
        })
    }
}

impl Layer for GradedHalfPlane {
    fn thickness(&self) -> Option<f64> {
        None
    }

    fn material(&self, depth: f64, plane: Plane) -> Material {
        let growth = (self.beta.get() * depth).min(RIGID).exp();
        Isotropic { shear_modulus: self.shear_modulus.get() * growth, poisson: self.poisson.get() }.material(plane)
    }

    fn key(&self) -> Option<Key> {
        Some(Key::of::<Self>().with([self.shear_modulus.get(), self.poisson.get(), self.beta.get()]))
    }
}
