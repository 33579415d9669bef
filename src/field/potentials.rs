//! The potentials of which closed forms in x consist.
use num_complex::Complex64;

/// σ_xx, σ_yy, σ_xy and the displacements u, v at a point or, transformed, λμ₀U and λμ₀V.
pub(super) type Components = [f64; 5];

/// G_n = (1/π) ∫ p̂ λⁿ e^(−λd + iλx) dλ at one point, n = 0, 1, 2: real parts belong to cos λx, imaginary ones to sin λx.
#[derive(Clone, Copy, Debug)]
pub(super) struct Potentials(pub(super) [Complex64; 3]);
