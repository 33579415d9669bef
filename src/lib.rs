//! Receding and advancing contact of layered elastic stacks.
#![deny(missing_docs)]

mod contact;
mod error;
pub mod exact;
mod kernel;
mod model;
#[doc(hidden)]
pub mod numeric;
mod options;
pub mod report;
mod scene;
mod solution;
mod stack;
mod system;

pub use error::{Error, NoSolution};
pub use model::{Model, solve};
pub use options::Options;
pub use recede_layers::{
    Exponential, FaceStates, Flexibility, HalfPlane, Homogeneous, Layer, LayerError, Plane, Registry, Wave,
};
pub use scene::{Item, MAX_BYTES, MAX_ITEMS, Punch, Scene, SceneError, Units};
pub use solution::{Contact, Interface, Solution};
pub use stack::{Base, Foundation, Laminate, Placed, Stack, StackBuilder, StackError, StackProblem};
pub use system::{BaseChain, FreeChain};
pub use system::{Block, BlockSystem, Column, Condition, Face, Place, Pressure, Quantity, Row, Side};
