//! The trait `Support`: what a stack may rest on without being an elastic body.
use std::fmt::Debug;

use nalgebra::Matrix4x2;

use crate::{Key, Notation, Wave};

/// A support below the lowest layer of a stack, such as springs: known only by the displacements and stresses that it allows
/// together at its face. It has no thickness, no material and no fields inside.
///
/// # Laws
///
/// [`conformance::support`](crate::conformance::support): states are finite; two of them do no net work on each other, as
/// Betti's theorem has it; and none gives work back.
///
/// # Example: springs that feel their neighbours
///
/// Pasternak's foundation, springs below a membrane under tension, σ_yy = (k + N λ²) v:
///
/// ```
/// use nalgebra::{Matrix4x2, Vector4};
/// use recede_layers::{Plane, Support, Wave, conformance};
///
/// #[derive(Debug)]
/// struct Pasternak {
///     stiffness: f64,
///     tension: f64,
/// }
///
/// impl Support for Pasternak {
///     fn face_states(&self, wave: &Wave) -> Matrix4x2<f64> {
///         let stiffness = self.stiffness + self.tension * wave.wavenumber.powi(2);
///         let displacement = wave.wavenumber * wave.modulus;
///         let largest = displacement.max(stiffness);
///         let pressed = Vector4::new(0.0, displacement, stiffness, 0.0) / largest;
///         Matrix4x2::from_columns(&[Vector4::x(), pressed])
///     }
/// }
///
/// let membrane = Pasternak { stiffness: 0.3, tension: 2.0 };
/// assert_eq!(conformance::support(&membrane, Plane::Strain), Ok(()));
/// ```
pub trait Support: Debug + Send + Sync {
    /// Two states (λμ₀U, λμ₀V, S, T) of which all those are made that the support allows at its face, of a size that neither
    /// overflows nor vanishes.
    fn face_states(&self, wave: &Wave) -> Matrix4x2<f64>;

    /// How the support is written in drawings, messages and scene files; provided: the name of the type.
    fn notation(&self) -> Notation {
        Notation::of::<Self>()
    }

    /// The name of the support in reports and pictures; provided: none. See [`NamedSupport`](crate::NamedSupport).
    fn name(&self) -> Option<&str> {
        None
    }

    /// What tells this support from others, as [`Layer::key`](crate::Layer::key); provided: `None`, it is the same as no other.
    fn key(&self) -> Option<Key> {
        None
    }
}
