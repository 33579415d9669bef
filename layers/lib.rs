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
//!
//! # Features
//!
//! `read`, on unless default features are switched off, reads layers from RON ([`tree`]) by name ([`Registry`]) and describes
//! their fields ([`description`]). Without it the crate has the trait, the materials and the layers only; these derive
//! `serde::Deserialize` all the same.
#![deny(missing_docs)]

// first, for its macro
#[cfg(feature = "read")]
#[macro_use]
pub mod description;

pub mod conformance;
mod decay;
mod error;
mod exponential;
mod fields;
mod flexibility;
pub mod graded;
mod graded_half_plane;
mod graded_layer;
mod half_plane;
mod homogeneous;
mod key;
mod layer;
mod linear;
mod loaded;
mod material;
mod name;
mod notation;
mod orthotropic;
mod power_half_plane;
mod profile;
mod quantity;
#[cfg(feature = "read")]
mod registry;
mod stable;
mod state;
mod support;
#[cfg(feature = "read")]
pub mod tree;
mod winkler;

pub use error::{LayerError, TableError};
pub use exponential::Exponential;
pub use flexibility::Flexibility;
pub use graded_half_plane::GradedHalfPlane;
pub use graded_layer::Graded;
pub use half_plane::HalfPlane;
pub use homogeneous::Homogeneous;
pub use key::{Identity, Key};
pub use layer::{ClosedForm, Layer};
pub use linear::solve_equilibrated;
pub use loaded::Loaded;
pub use material::{ElasticConstants, Isotropic, Material, Plane};
pub use name::{Name, NamedSupport, layer_label};
pub use notation::{Notation, Parameter};
pub use orthotropic::{EngineeringConstants, Orthotropic, OrthotropicHalfPlane, PoissonRatios, Young};
pub use power_half_plane::PowerHalfPlane;
pub use profile::{Profile, Table};
pub use quantity::{
    Carrying, Compressive, Exponent, Finite, HalfAngle, OutOfRange, Poisson, Positive, Pressing, Stiffening, Thickness,
};
#[cfg(feature = "read")]
pub use registry::{Body, Entry, ReadBody, Registry};
pub use state::{FaceStates, InnerStates, LayerStates, State, Wave};
pub use support::Support;
pub use winkler::Winkler;

/// Registers the layer types that ship with `recede`: the one list that feeds the RON reader, its error
/// messages, and the tests of the laws.
#[cfg(feature = "read")]
fn register_shipped(registry: &mut Registry) {
    registry.register_described::<Homogeneous>("Homogeneous", "One isotropic material through the thickness.");
    registry.register_described::<Exponential>("Exponential", "Shear modulus varies as exp(beta d) with the depth d.");
    registry.register_described::<Graded>("Graded", "Shear modulus and Poisson's ratio vary in any way.");
    registry.register_described::<Orthotropic>("Orthotropic", "One orthotropic material through the thickness.");
    registry.register_described::<HalfPlane>("HalfPlane", "One isotropic material, down to any depth.");
    registry.register_described::<GradedHalfPlane>("GradedHalfPlane", "Shear modulus grows as exp(beta d).");
    registry.register_described::<PowerHalfPlane>("PowerHalfPlane", "Shear modulus grows as (1 + d/length)^exponent.");
    registry.register_described::<OrthotropicHalfPlane>("OrthotropicHalfPlane", "One orthotropic material.");
    registry
        .register_support::<Winkler>("Winkler", "Springs on rigid ground; the layer above is to be bonded to them.");
}
