//! Why the layers' fields are not known.

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
