//! The block system at one wavenumber: blocks filled from the layers' face states, and eliminated layer by layer, at a cost
//! linear in the number of layers.
//!
//! The connected components of the matrix are *chains*: free laminates, and the base with all that is joined to it. In a
//! chain each layer's four amplitudes follow from two conditions at the face next to its neighbour and the two displacements
//! (or stresses) of its far face. No exponential grows: every amplitude belongs to a state that decays from a face.
mod base;
mod cut_off;
mod free;
mod half;
mod inside;
mod junction;
mod repeats;
#[cfg(test)]
mod tests;

pub use base::BaseChain;
pub(crate) use cut_off::slowest_decay;
pub use free::FreeChain;
pub(crate) use inside::FaceLoad;
