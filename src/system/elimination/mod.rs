//! The block system at one wavenumber: blocks filled from the layers' face states, and eliminated layer by layer, at a cost
//! linear in the number of layers.
//!
//! The connected components of the matrix are *chains*: free laminates, and the base with all that is joined to it. In a
//! chain each layer's four amplitudes follow from two conditions handed on by its neighbour and the two displacements
//! (or stresses) of its far face. Nothing grows: every layer offers its states in amplitudes that decay from a face.
mod base;
mod free;
mod half;
mod inside;
mod junction;
mod reach;
mod repeats;
#[cfg(test)]
mod tests;

pub use base::BaseChain;
pub use free::FreeChain;
pub(crate) use inside::Load;
pub(crate) use reach::{Taken, slowest_decay};
