//! Numerical analysis without mechanics: Bessel functions, quadrature, interpolation.

pub mod bessel;
pub(crate) mod buffer;
pub mod chebyshev;
mod largest;
pub mod quadrature;
pub(crate) mod trigonometry;
pub(crate) mod vector;

pub use largest::largest;

/// Σ a_i b_i.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
