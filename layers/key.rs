//! What tells layers apart: the type and its parameters.
use std::any::TypeId;
use std::fmt::{Debug, Write};

/// The type of a layer and all of its parameters: layers with equal keys are the same, wherever they lie.
///
/// ```
/// use recede_layers::{Homogeneous, Layer};
/// let strip = |modulus| Homogeneous::new(1.0, modulus, 0.25);
/// assert_eq!(strip(1.0)?.key(), strip(1.0)?.key());
/// assert_ne!(strip(1.0)?.key(), strip(2.0)?.key());
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Key {
    layer: TypeId,
    parameters: Vec<u8>,
}

impl Key {
    /// The key of a type of layers, without parameters yet.
    pub fn of<L: 'static>() -> Self {
        // room for most layers' parameters
        Self { layer: TypeId::of::<L>(), parameters: Vec::with_capacity(64) }
    }

    /// The same with some numbers, which are equal if their bits are.
    pub fn with<const N: usize>(mut self, numbers: [f64; N]) -> Self {
        self.parameters.extend(numbers.iter().flat_map(|number| number.to_bits().to_le_bytes()));
        self
    }

    /// The same with a value of which [`Debug`] tells everything, as it does where it is derived.
    pub fn with_debug(mut self, value: &impl Debug) -> Self {
        let mut text = String::new();
        // writing to a string does not fail
        let _ = write!(text, "{value:?}");
        self.parameters.extend((text.len() as u64).to_le_bytes());
        self.parameters.extend(text.into_bytes());
        self
    }
}
