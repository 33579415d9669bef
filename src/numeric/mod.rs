//! Numerical analysis without mechanics: Bessel functions, quadrature, interpolation.

pub mod bessel;
pub(crate) mod buffer;
pub mod chebyshev;
mod largest;
pub mod quadrature;
pub(crate) mod trigonometry;
pub(crate) mod vector;

pub use largest::largest;
