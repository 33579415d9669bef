//! A homogeneous half-plane: everything below its top face.
use nalgebra::{Matrix4, Matrix4x2, Vector4};
#[cfg(feature = "read")]
use schemars::JsonSchema;
use serde::Deserialize;

use crate::{
    ClosedForm, FaceStates, InnerStates, Isotropic, Key, Layer, LayerError, LayerStates, Material, Plane, Poisson,
    Positive, Wave, decay::decaying_downwards,
};

/// Homogeneous, isotropic half-plane, the usual base of a stack.
///
/// ```
/// use recede_layers::HalfPlane;
/// let ground = HalfPlane::new(1.0, 0.25)?;
/// assert!(HalfPlane::new(-1.0, 0.25).is_err());
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct HalfPlane {
    /// Shear modulus μ, in stress.
    shear_modulus: Positive,
    /// Poisson's ratio ν.
    poisson: Poisson,
}

impl HalfPlane {
    /// A half-plane of shear modulus μ > 0 (stress) and Poisson's ratio −1 < ν ≤ 1/2.
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite.
    pub fn new(shear_modulus: f64, poisson: f64) -> Result<Self, LayerError> {
        Ok(Self {
            shear_modulus: LayerError::checked("shear_modulus", shear_modulus)?,
            poisson: LayerError::checked("poisson", poisson)?,
        })
    }

    pub(crate) fn isotropic(&self) -> Isotropic {
        Isotropic { shear_modulus: self.shear_modulus.get(), poisson: self.poisson.get() }
    }
}

impl Layer for HalfPlane {
    fn thickness(&self) -> Option<f64> {
        None
    }

    fn material(&self, _depth: f64, plane: Plane) -> Material {
        self.isotropic().material(plane)
    }

    fn closed_form(&self) -> Option<&dyn ClosedForm> {
        Some(self)
    }

    fn key(&self) -> Option<Key> {
        Some(Key::of::<Self>().with([self.shear_modulus.get(), self.poisson.get()]))
    }
}

impl ClosedForm for HalfPlane {
    fn face_states(&self, wave: &Wave) -> FaceStates {
        let [first, second] = decaying_downwards(&self.isotropic(), wave, 0.0);
        FaceStates::HalfPlane { top: Matrix4x2::from_columns(&[first, second]) }
    }

    fn states(&self, wave: &Wave, depths: &[f64]) -> Option<LayerStates> {
        let inside = depths.iter().map(|depth| {
            let [a, b] = decaying_downwards(&self.isotropic(), wave, wave.wavenumber * depth);
            InnerStates::thick(Matrix4::from_columns(&[a, b, Vector4::zeros(), Vector4::zeros()]))
        });
        Some(LayerStates { inside: inside.collect(), faces: self.face_states(wave) })
    }
}
