//! A half-plane graded by a power law, μ(d) = μ_top (1 + d/l)^m with m > −1.
#[cfg(feature = "read")]
use schemars::JsonSchema;
use serde::Deserialize;

use crate::{Carrying, Isotropic, Key, Layer, LayerError, Material, Plane, Poisson, Positive};

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
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PowerHalfPlane {
    /// Shear modulus at the face, in stress.
    shear_modulus: Positive,
    /// Poisson's ratio ν.
    poisson: Poisson,
    /// Length l over which the modulus rises first.
    length: Positive,
    /// Exponent m, dimensionless: the modulus at depth d is shear_modulus (1 + d/length)^m.
    exponent: Carrying,
}

impl PowerHalfPlane {
    /// A half-plane of shear modulus μ_top > 0 at its face (stress), Poisson's ratio −1 < ν ≤ 1/2, length l > 0 and
    /// exponent m > −1 (dimensionless).
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite.
    pub fn new(shear_modulus: f64, poisson: f64, length: f64, exponent: f64) -> Result<Self, LayerError> {
        Ok(Self {
            shear_modulus: LayerError::checked("shear_modulus", shear_modulus)?,
            poisson: LayerError::checked("poisson", poisson)?,
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
        Isotropic { shear_modulus: self.shear_modulus.get() * growth, poisson: self.poisson.get() }.material(plane)
    }

    fn key(&self) -> Option<Key> {
        Some(Key::of::<Self>().with([
            self.shear_modulus.get(),
            self.poisson.get(),
            self.length.get(),
            self.exponent.get(),
        ]))
    }
}
