//! The trait `Layer` and nothing else.
use std::any::Any;
use std::fmt::Debug;

use crate::{FaceStates, Flexibility, Material, Plane, Wave};

/// How a layer is written in the printed block matrix: symbols only, no numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notation {
    /// Name of the layer type, e.g. `Homogeneous`.
    pub kind: &'static str,
    /// The parameters with their values, as in the scene file, e.g. `thickness: 1, shear_modulus: 1, poisson: 0.25`.
    pub parameters: String,
}

/// An elastic layer, known to the solver only by its transformed fields.
pub trait Layer: Debug + Send + Sync + Any {
    /// Thickness h ≥ 0, in length; `None` for a layer that fills everything below its top face.
    fn thickness(&self) -> Option<f64>;

    /// The material at `depth` below the top face, 0 ≤ depth ≤ thickness.
    fn material(&self, depth: f64, plane: Plane) -> Material;

    /// States at the faces as functions of the layer's amplitudes.
    fn face_states(&self, wave: &Wave) -> FaceStates {
        crate::graded::face_states(self, wave)
    }

    /// Flexibility of the layer alone with shear-free faces; `None` for a half-plane, see [`Flexibility`].
    fn flexibility(&self, wave: &Wave) -> Option<Flexibility> {
        Flexibility::of_face_states(&self.face_states(wave))
    }

    /// How the layer is written in the printed block matrix.
    fn notation(&self) -> Notation;
}
