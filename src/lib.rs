//! Receding and advancing contact of layered elastic stacks.
//!
//! Plane frictionless unilateral contact: a stack of elastic layers, homogeneous, functionally graded or orthotropic, on a
//! half-plane or a rigid base. Neighbours are bonded, or rest on each other and may separate: there the contact *recedes*
//! under load to an unknown half-length. A punch presses on top over another unknown half-length. `recede` computes
//! the half-lengths and the pressures, with error estimates.
//!
//! ```
//! use recede::{Exponential, HalfPlane, Homogeneous, Model, Plane, Punch, Stack};
//!
//! // a strip, bonded to a graded layer, which rests on a half-plane
//! let stack = Stack::builder(Plane::Strain)
//!     .layer(Homogeneous::new(1.0, 1.0, 0.25)?)
//!     .bonded()
//!     .layer(Exponential::new(1.0, 1.0, 0.25, -1.0)?)
//!     .receding()
//!     .layer(HalfPlane::new(1.0, 0.25)?)
//!     .build()?;
//! let model = Model::new(stack)?; // serves any punch and load
//! let solution = model.press(&Punch::cylinder(500.0)?, 0.002)?;
//! for contact in solution.contacts() {
//!     for interval in contact.intervals() {
//!         println!("{}: {} to {} ± {:e}", contact.interface, interval.left, interval.right, interval.right_error);
//!     }
//! }
//! let receding = &solution.contacts()[1];
//! assert!((receding.reach() - 2.448_610_297_658).abs() < 1e-9);
//! assert!(receding.pressure(1.0) < receding.central_pressure);
//! assert!((receding.resultant - 0.002).abs() < 1e-15);
//! # Ok::<(), recede::Error>(())
//! ```
//!
//! The same from a text file is [`Scene::read`] and [`solve`].
//!
//! # The way through
//!
//! | step | meaning |
//! |---|---|
//! | [`Scene`] | a text in RON: punch, force, layers and interfaces from the top down |
//! | [`Stack`] | its checked structure: free laminates and the base below them |
//! | [`BlockSystem`] | the boundary conditions as a symbolic block matrix |
//! | [`FreeChain`], [`BaseChain`] | its connected components in numbers: flexibilities at a wavenumber, eliminated layer by layer |
//! | [`Model`] | kernels: flexibilities at all wavenumbers, ready for any punch and force |
//! | [`Solution`] | half-lengths, pressures, error estimates |
//! | [`Field`] | stresses and displacements inside the stack |
//! | [`report`] | tables, JSON and CSV |
//!
//! Layer types are in a crate of their own, [`layers`], with the laws they obey; others are added through a
//! [`Registry`].
//!
//! # Features
//!
//! All are on unless `default-features = false` is set: `cli`, the command, with `plot`, pictures; `parallel`, sweeps in
//! several threads; `selftest`, random scenes; and `files`, scenes and sweeps from files. Without any of them the library does not use
//! threads, a clock or files.
//!
//! # Conventions
//!
//! Any consistent units. x along the layers, depths downwards; pressures are positive in compression, forces are per unit
//! length out of plane.
#![deny(missing_docs)]

mod approach;
mod axis;
mod collocation;
mod contact;
mod errors;
mod field;
#[cfg(feature = "files")]
pub mod files;
mod geometry;
mod kernel;
mod model;
#[doc(hidden)]
pub mod numeric;
mod options;
#[cfg(feature = "plot")]
pub mod plot;
mod profile;
pub mod report;
mod scene;
#[cfg(feature = "selftest")]
pub mod selftest;
mod solution;
mod stack;
mod sweep;
mod system;
mod validity;
mod weights;

pub use approach::{Approach, ApproachError, Stiffness};
pub use axis::{Axis, AxisError};
pub use collocation::Collocated;
pub use contact::{ContactError, NoSolution};
pub use errors::Error;
pub use field::{
    BondExtremes, Extreme, Extremes, FaceProfile, FaceSide, Field, FieldError, FieldPoint, FieldQuantity, Grid,
    LayerExtremes, MaxShear, Point, SpacePoint,
};
pub use geometry::{Coordinates, Geometry, Words};
pub use model::{Model, solve};
pub use options::{Options, OptionsError};
pub use profile::{ContactProfile, FaceProfiles, profile_places};
/// The crate of the layers: for user-defined layer types, and the laws that they have to obey.
pub use recede_layers as layers;
pub use recede_layers::{
    ClosedForm, EngineeringConstants, Exponential, FaceStates, Flexibility, Graded, GradedHalfPlane, HalfPlane,
    Homogeneous, Isotropic, Key, Layer, LayerError, Loaded, Material, Notation, Orthotropic, OrthotropicHalfPlane,
    Plane, PowerHalfPlane, Profile, Registry, Support, Wave, Winkler,
};
pub use scene::{
    Covered, ElasticCylinder, Force, HeightsError, Item, ListError, Load, Loads, MAX_BYTES, MAX_ITEMS, PlacedLoad,
    Pressed, Punch, Punches, Scene, SceneError, Spring, Tilt, Top, Units, ValueError, Vocabulary, Wedge, scene_schema,
    visible,
};
pub use solution::{
    Carried, ClosedInterface, Contact, Controlled, Interface, Interval, Ledger, LedgerEntry, Opening, Peak, Separation,
    Solution, Stats, Warning, WarningCode,
};
pub use stack::{
    Base, Foundation, Joint, Laminate, MAX_CONTRAST, MAX_LAYERS, MAX_RECEDING, Placed, Stack, StackBuilder, StackError,
    StackProblem,
};
#[cfg(feature = "parallel")]
pub use sweep::ParallelRows;
pub use sweep::{Part, PartError, Probe, Row as SweepRow, Sweep, SweepPoint};
pub use system::{BaseChain, FreeChain, Unresolved, WrongCount};
pub use system::{
    Block, BlockSystem, Blocks, Column, Component, Face, InterfaceSide, Place, Quantity, Relation, RightHandSide, Row,
    Term,
};
