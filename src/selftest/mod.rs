//! Random legal scenes, solved and checked: a test of the solver on scenes that nobody thought of.
//!
//! [`scenes`] is a [`proptest`] strategy, [`scene`] generates one of its scenes by number, [`scene_of_any_kind`] one with punches,
//! loads, layers, interfaces and bases of all kinds. [`CheckedScene`] solves a scene and checks the
//! answer. The command `recede selftest` does that for many.
//!
//! ```
//! use recede::Options;
//! use recede::selftest::{Outcome, Ranges, CheckedScene, scene};
//! let scenario = scene(&Ranges::default(), 1, 17); // seed 1, number 17: always the same
//! let check = CheckedScene::run(&scenario.scene()?, &Options::default(), false);
//! if let Outcome::Unsolved(reason) = &check.outcome {
//!     println!("{reason}:\n{}", scenario.scene()?.to_ron());
//! }
//! assert!(!check.outcome.is_wrong());
//! # Ok::<(), recede::Error>(())
//! ```
mod check;
mod commands;
mod examples;
mod kinds;
mod load;
mod scenario;
mod strategy;
mod verify;

pub use check::{CheckedScene, Outcome};
pub use examples::{EXAMPLES, variant};
pub use kinds::{about_axis, scene_of_any_kind, scene_with_punches};
pub use scenario::{Ply, Scenario, ScenarioUnits};
pub use strategy::{Ranges, scene, scenes};
pub use verify::{Comparison, ROUNDING, compare};
