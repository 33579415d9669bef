//! Springs on rigid ground, the simplest foundation.

use nalgebra::Matrix4x2;
#[cfg(feature = "read")]
use schemars::JsonSchema;
use serde::Deserialize;

use crate::{Key, LayerError, Notation, Positive, State, Support, Wave};

/// Winkler's foundation: springs side by side, none of which feels its neighbours, under the lowest layer of a stack.
///
/// They push and pull with σ_yy = k v, where v is the displacement of the layer's bottom face. Along the face they either
/// resist nothing, σ_xy = 0, or, with a shear stiffness, σ_xy = k_t u.
///
/// A layer has to be bonded to them: a loose one, or a punch, would press on them with p = −k v place by place,
/// which is not the pressure on an elastic body.
///
/// ```
/// use recede_layers::{Plane, Winkler, conformance};
/// let springs = Winkler::new(0.1)?;
/// assert_eq!(conformance::support(&springs, Plane::Strain), Ok(()));
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Winkler {
    /// Stiffness k, in stress/length.
    stiffness: Positive,
    /// Stiffness k_t along the face, in stress/length; without it, the layer slides freely.
    #[serde(default)]
    shear_stiffness: Option<Positive>,
}

impl Winkler {
    /// Springs of stiffness k > 0 (stress/length), on which the layer slides freely.
    ///
    /// # Errors
    /// [`LayerError`] if the stiffness is not positive and finite.
    pub fn new(stiffness: f64) -> Result<Self, LayerError> {
        Ok(Self { stiffness: LayerError::checked("stiffness", stiffness)?, shear_stiffness: None })
    }

    /// The same with a stiffness k_t > 0 (stress/length) along the face.
    ///
    /// # Errors
    /// [`LayerError`] if the stiffness is not positive and finite.
    pub fn sticking(self, shear_stiffness: f64) -> Result<Self, LayerError> {
        let shear_stiffness = Some(LayerError::checked("shear_stiffness", shear_stiffness)?);
        Ok(Self { shear_stiffness, ..self })
    }
}

impl Support for Winkler {
    /// States: of the motion along the face, and of that across it, each with the stress that belongs to it.
    fn face_states(&self, wave: &Wave) -> Matrix4x2<f64> {
        // λμ₀ and k may be of any size: only their ratio counts
        let pair = |stiffness: f64| {
            let displacement = wave.wavenumber * wave.modulus;
            let largest = displacement.max(stiffness);
            (displacement / largest, stiffness / largest)
        };
        let (u, t) = pair(self.shear_stiffness.map_or(0.0, Positive::get));
        let (v, s) = pair(self.stiffness.get());
        Matrix4x2::from_columns(&[State::new(u, 0.0, 0.0, t), State::new(0.0, v, s, 0.0)])
    }

    fn notation(&self) -> Notation {
        let notation = Notation::of::<Self>().with("stiffness", &self.stiffness);
        match &self.shear_stiffness {
            Some(stiffness) => notation.with("shear_stiffness", stiffness),
            None => notation,
        }
    }

    fn key(&self) -> Option<Key> {
        let shear_stiffness = self.shear_stiffness.map_or(0.0, Positive::get);
        Some(Key::of::<Self>().with([self.stiffness.get(), shear_stiffness]))
    }
}
