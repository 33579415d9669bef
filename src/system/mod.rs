//! The block system of a stack: which conditions its interfaces impose on which layers' amplitudes.
//!
//! A layer of finite thickness has four amplitudes, a half-plane two. Every interface contributes conditions, each of
//! them a row that involves a face quantity of one or two neighbouring layers:
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
//! Any legal stack gives as many conditions as amplitudes.
mod across;
mod block;
mod error;
mod evaluate;
mod inside;
mod latex;
mod repeats;
mod text;

pub use block::{Block, BlockSystem, Column, Condition, Face, Place, Pressure, Quantity, Row, Side};
pub use error::Unresolved;
pub use evaluate::{BaseChain, FreeChain};
pub(crate) use evaluate::{Taken, slowest_decay};
pub(crate) use inside::Load;
