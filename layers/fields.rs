//! The fields of any layer: its closed form, or the general body.
use crate::{FaceStates, Flexibility, Layer, LayerStates, Wave, graded};

/// What is asked of a layer.
impl dyn Layer {
    /// States at the faces as functions of the layer's amplitudes: the layer's closed form, or [`graded::face_states`].
    pub fn face_states(&self, wave: &Wave) -> FaceStates {
        self.closed_form().map_or_else(|| graded::face_states(self, wave), |closed| closed.face_states(wave))
    }

    /// States at the faces and at `depths` below the top face, in ascending order from 0 to the thickness, in amplitudes
    /// common to all of them; they need not be the amplitudes of [`face_states`](#method.face_states). The layer's closed form, or
    /// [`graded::states`].
    pub fn states(&self, wave: &Wave, depths: &[f64]) -> LayerStates {
        let closed = self.closed_form().and_then(|closed| closed.states(wave, depths));
        closed.unwrap_or_else(|| graded::states(self, wave, depths))
    }

    /// Flexibility of the layer alone with shear-free faces; `None` for a half-plane, see [`Flexibility`].
    pub fn flexibility(&self, wave: &Wave) -> Option<Flexibility> {
        let general = || graded::flexibility(self, wave);
        self.closed_form().map_or_else(general, |closed| closed.flexibility(wave))
    }
}
