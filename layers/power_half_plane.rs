//! A half-plane graded by a power law, μ(d) = μ_top (1 + d/l)^m with m > −1.

#[cfg(feature = "read")]
use schemars::JsonSchema;
use serde::Deserialize;

use crate::{
    Carrying, ElasticConstants, Isotropic, Key, Layer, LayerError, Material, Notation, Plane, Poisson, Positive,
};

/// Isotropic half-plane of constant Poisson's ratio whose shear modulus is μ_top (1 + d/l)^m at depth d below its face,
/// m > −1: like soil, which stiffens under its own weight, or like ground that was compacted from above and softens.
///
/// With m ≤ −1 strains would not fall with the distance, and nothing would carry the force.
///
/// ```
/// use recede_layers::PowerHalfPlane;
/// let soil = PowerHalfPlane::new(1.0, 0.3, 2.0, 0.5)?;
/// assert!(PowerHalfPlane::new(1.0, 0.3, 2.0, -1.0).is_err());
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(try_from = "PowerHalfPlaneFields")]
pub struct PowerHalfPlane {
    /// At the face.
    constants: ElasticConstants,
    length: Positive,
    exponent: Carrying,
}

/// The fields as written in a scene, before they are checked together.
#[derive(Deserialize)]
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(deny_unknown_fields, rename = "PowerHalfPlane")]
struct PowerHalfPlaneFields {
    /// Shear modulus μ at the face, in stress; or in its place `young`.
    #[serde(default)]
    shear_modulus: Option<Positive>,
    /// Young's modulus E at the face, in stress; or in its place `shear_modulus`.
    #[serde(default)]
    young: Option<Positive>,
    /// Poisson's ratio ν, dimensionless.
    poisson: Poisson,
    /// Length l over which the modulus rises first, in length.
    length: Positive,
    /// Exponent m, dimensionless: the modulus at depth d is that at the face times (1 + d/length)^m.
    exponent: Carrying,
}

#[cfg(feature = "read")]
described!(PowerHalfPlane by PowerHalfPlaneFields);

impl TryFrom<PowerHalfPlaneFields> for PowerHalfPlane {
    type Error = LayerError;

    fn try_from(fields: PowerHalfPlaneFields) -> Result<Self, LayerError> {
        let PowerHalfPlaneFields { shear_modulus, young, poisson, length, exponent } = fields;
        Ok(Self { constants: ElasticConstants::read(shear_modulus, young, poisson)?, length, exponent })
    }
}

impl PowerHalfPlane {
    /// A half-plane of shear modulus μ_top > 0 at its face (stress), Poisson's ratio −1 < ν ≤ 1/2, length l > 0 and
    /// exponent m > −1 (dimensionless).
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite.
    pub fn new(shear_modulus: f64, poisson: f64, length: f64, exponent: f64) -> Result<Self, LayerError> {
        Ok(Self {
            constants: ElasticConstants::new(shear_modulus, poisson)?,
            length: LayerError::checked("length", length)?,
            exponent: LayerError::checked("exponent", exponent)?,
        })
    }
}

impl Layer for PowerHalfPlane {
    fn thickness(&self) -> Option<f64> {
        None
    }

    fn material(&self, depth: f64, plane: Plane) -> Material {
        let growth = (self.exponent.get() * (depth / self.length.get()).ln_1p()).exp();
        let Isotropic { shear_modulus, poisson } = self.constants.isotropic();
        Isotropic { shear_modulus: shear_modulus * growth, poisson }.material(plane)
    }

    fn key(&self) -> Option<Key> {
        let Isotropic { shear_modulus, poisson } = self.constants.isotropic();
        Some(Key::of::<Self>().with([shear_modulus, poisson, self.length.get(), self.exponent.get()]))
    }

    fn notation(&self) -> Notation {
        self.constants.noted(Notation::of::<Self>()).with("length", &self.length).with("exponent", &self.exponent)
    }
}
