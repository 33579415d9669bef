//! A homogeneous half-plane: everything below its top face.

use nalgebra::{Matrix4, Matrix4x2, Vector4};
#[cfg(feature = "read")]
use schemars::JsonSchema;
use serde::Deserialize;

use crate::{
    ClosedForm, ElasticConstants, FaceStates, InnerStates, Isotropic, Key, Layer, LayerError, LayerStates, Material,
    Notation, Plane, Poisson, Positive, Wave, decay::decaying_downwards,
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
#[serde(try_from = "HalfPlaneFields")]
pub struct HalfPlane {
    constants: ElasticConstants,
}

/// The fields as written in a scene, before they are checked together.
#[derive(Deserialize)]
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(deny_unknown_fields, rename = "HalfPlane")]
struct HalfPlaneFields {
    /// Shear modulus μ, in stress; or in its place `young`.
    #[serde(default)]
    shear_modulus: Option<Positive>,
    /// Young's modulus E, in stress; or in its place `shear_modulus`.
    #[serde(default)]
    young: Option<Positive>,
    /// Poisson's ratio ν, dimensionless.
    poisson: Poisson,
}

#[cfg(feature = "read")]
described!(HalfPlane by HalfPlaneFields);

impl TryFrom<HalfPlaneFields> for HalfPlane {
    type Error = LayerError;

    fn try_from(fields: HalfPlaneFields) -> Result<Self, LayerError> {
        let HalfPlaneFields { shear_modulus, young, poisson } = fields;
        Ok(Self { constants: ElasticConstants::read(shear_modulus, young, poisson)? })
    }
}

impl HalfPlane {
    /// A half-plane of shear modulus μ > 0 (stress) and Poisson's ratio −1 < ν ≤ 1/2.
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite.
    pub fn new(shear_modulus: f64, poisson: f64) -> Result<Self, LayerError> {
        Ok(Self { constants: ElasticConstants::new(shear_modulus, poisson)? })
    }

    pub(crate) fn isotropic(&self) -> Isotropic {
        self.constants.isotropic()
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
        let Isotropic { shear_modulus, poisson } = self.isotropic();
        Some(Key::of::<Self>().with([shear_modulus, poisson]))
    }

    fn notation(&self) -> Notation {
        self.constants.noted(Notation::of::<Self>())
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
