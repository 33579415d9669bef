//! What tells layers apart: the type and its parameters.
use std::any::TypeId;
use std::sync::atomic::{AtomicU64, Ordering};

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

/// Tells an object, with its clones, from all others that are ever made by the process: for parameters that cannot be compared, such as
/// functions. An address would not do, since another object may come to lie there.
///
/// ```
/// use recede_layers::Identity;
/// assert_ne!(Identity::unique(), Identity::unique());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Identity(u64);

impl Identity {
    /// An identity that no other object has.
    pub fn unique() -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        Self(NEXT.fetch_add(1, Ordering::Relaxed))
    }
}

impl Key {
    /// The key of a type of layers, without parameters yet.
    pub fn of<L: 'static>() -> Self {
        // room for most layers' parameters
        Self { layer: TypeId::of::<L>(), parameters: Vec::with_capacity(64) }
    }

    /// The same with some numbers, which are equal if their bits are.
    #[must_use]
    pub fn with<const N: usize>(mut self, numbers: [f64; N]) -> Self {
        self.parameters.extend(numbers.iter().flat_map(|number| number.to_bits().to_le_bytes()));
        self
    }

    /// The same with a list of numbers, of any length.
    #[must_use]
    pub fn with_list(mut self, numbers: &[f64]) -> Self {
        self.parameters.extend((numbers.len() as u64).to_le_bytes());
        self.parameters.extend(numbers.iter().flat_map(|number| number.to_bits().to_le_bytes()));
        self
    }

    /// The same with a parameter that is equal to its clones only.
    #[must_use]
    pub fn with_identity(mut self, identity: Identity) -> Self {
        self.parameters.extend(identity.0.to_le_bytes());
        self
    }
}
