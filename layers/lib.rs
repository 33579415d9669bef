//! Transformed elastic layers: what a layer of a stack is, and the layers that ship with `recede`.
//!
//! # Conventions
//!
//! Plane problem, x along the layers, y **upwards**; `depth` is measured **downwards** from the top face of a
//! layer. For a wavenumber λ > 0 the fields of a symmetric scene are
//!
//! ```text
//! u = U sin λx    v = V cos λx    σ_yy = S cos λx    σ_xy = T sin λx
//! ```
//!
//! and the real amplitudes (U, V, S, T) obey the state equations (see [`Material`])
//!
//! ```text
//! U' =  λ V + T/c66
//! V' = −c λ U + S/c22            c = c12/c22
//! S' = −λ T                      ' = d/dy
//! T' =  E λ² U + c λ S           E = c11 − c12²/c22
//! ```
//!
//! Displacements are exchanged as **λ μ₀ U, λ μ₀ V** ([`Wave::modulus`] is μ₀), so that all four components of a
//! [`State`] are stresses and do not depend on the units of length.
#![deny(missing_docs)]

pub mod conformance;
mod error;
mod exponential;
mod flexibility;
pub mod graded;
mod half_plane;
mod homogeneous;
mod layer;
mod linear;
mod material;
mod quantity;
mod registry;
mod stable;
mod state;

pub use error::LayerError;
pub use exponential::Exponential;
pub use flexibility::Flexibility;
pub use half_plane::HalfPlane;
pub use homogeneous::Homogeneous;
pub use layer::{Layer, Notation};
pub use linear::solve_equilibrated;
pub use material::{Isotropic, Material, Plane};
pub use quantity::{Finite, OutOfRange, Poisson, Positive, Thickness};
pub use registry::{Entry, ReadError, ReadLayer, Registry, read_ron};
pub use state::{FaceStates, InnerStates, LayerStates, State, Wave};

/// Registers the layer types that ship with `recede`: the one list that feeds the RON reader, its error
/// messages, and the tests of the laws.
fn register_shipped(registry: &mut Registry) {
    registry.register::<Homogeneous>("Homogeneous", "one material through the thickness");
    registry.register::<Exponential>("Exponential", "shear modulus varies as exp(beta * depth)");
    registry.register::<HalfPlane>("HalfPlane", "homogeneous, fills everything below; only as the base");
}
