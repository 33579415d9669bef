//! Random legal scenes, and what becomes of them: a solver is trusted for the scenes that nobody thought of.
//!
//! [`scenes`] is a [`proptest`] strategy, [`scene`] picks one of its scenes by number, [`scene_of_any_kind`] one with punches,
//! loads, layers, interfaces and bases of all kinds, [`Trial`] solves it and judges the
//! answer. The command `recede stress` does that for many.
//!
//! ```
//! use recede::Options;
//! use recede::stress::{Outcome, Ranges, Trial, scene};
//! let scenario = scene(&Ranges::default(), 1, 17); // seed 1, number 17: always the same
//! let trial = Trial::run(&scenario.scene()?, &Options::default(), false);
//! if let Outcome::Unsolved(reason) = &trial.outcome {
//!     println!("{reason}:\n{}", scenario.scene()?.to_ron());
//! }
//! assert!(!trial.outcome.is_wrong());
//! # Ok::<(), recede::Error>(())
//! ```
mod commands;
mod examples;
mod kinds;
mod load;
mod scenario;
mod strategy;
mod trial;
mod verify;

pub use examples::{EXAMPLES, variant};
pub use kinds::{scene_of_any_kind, scene_of_any_kind_in_units};
pub use scenario::{Ply, Scenario};
pub use strategy::{Ranges, scene, scenes};
pub use trial::{Outcome, Trial};
pub use verify::{Comparison, ROUNDING, compare};
