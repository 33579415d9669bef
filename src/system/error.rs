//! Why the layers' fields are not known, or no conditions can be given.

use super::Face;

/// The layers' fields cannot be computed at a wavenumber.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("the fields of the layers cannot be computed at wavenumber {wavenumber:e}")]
pub struct Unresolved {
    /// The wavenumber in question, in 1/length.
    pub wavenumber: f64,
}

impl Unresolved {
    /// What to do about it.
    pub fn hint(&self) -> String {
        "a material may vary too fast with the depth next to a contact, like a power of it that is no whole number: \
         `recede::layers::conformance::examine` examines a layer of one's own"
            .to_owned()
    }
}

/// Conditions at a face or between two bodies are more or fewer than determine their amplitudes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there are {found} conditions at the {face} face of layer {layer}; needed are {needed}")]
pub struct WrongCount {
    /// Number of the layer, as in the scene.
    pub layer: usize,
    /// Face of the layer.
    pub face: Face,
    /// Number of conditions found.
    pub found: usize,
    /// Number of conditions needed: four between two bodies, two at a face that only one of them has.
    pub needed: usize,
}
