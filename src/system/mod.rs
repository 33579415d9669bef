//! The block system of a stack: which conditions its interfaces impose on which layers' amplitudes, and what follows from
//! them at one wavenumber.
//!
//! A layer of finite thickness has four amplitudes, a half-plane two. Every interface contributes conditions, each of
//! them a row that involves face quantities of one or two neighbouring layers:
//!
//! | interface            | conditions                                        |
//! |----------------------|---------------------------------------------------|
//! | loaded top face      | S = −p, T = 0                                     |
//! | bonded               | U, V, S, T continuous                             |
//! | sliding              | V, S continuous, T = 0 above and below            |
//! | springs              | S, T continuous, S = k_n [V], T = k_t [U]         |
//! | receding             | S = −p and T = 0, above and below                 |
//! | bonded to rigid      | U = V = 0                                         |
//! | receding on rigid    | S = −p, T = 0 above                               |
//!
//! Any legal stack gives as many conditions as amplitudes. They are written in `symbols/conditions.rs` and nowhere else: what
//! is printed and what is eliminated are the same rows.
mod closed;
mod elimination;
mod error;
mod print;
mod symbols;

pub(crate) use closed::ClosedContacts;
pub use elimination::{BaseChain, FreeChain};
pub(crate) use elimination::{FaceLoad, slowest_decay};
pub use error::{Unresolved, WrongCount};
pub use symbols::components::Component;
pub use symbols::conditions::{Relation, Term};
pub use symbols::matrix::{Block, BlockSystem, Blocks, Column, Row};
pub use symbols::names::{Face, InterfaceSide, Place, Quantity, RightHandSide};
