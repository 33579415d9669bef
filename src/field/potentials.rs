//! The potentials of which closed forms in x consist.
use num_complex::Complex64;

/// How many components a field has.
pub(super) const COMPONENTS: usize = 6;

/// σ_xx, σ_yy, σ_xy, the displacements u, v and the slope dv/dx at a point or, transformed, λμ₀U, λμ₀V and λμ₀V once more.
pub(super) type Components = [f64; COMPONENTS];

/// A place at which closed forms are wanted.
#[derive(Clone, Copy, Debug)]
pub(super) struct At {
    pub(super) x: f64,
    /// Distance from the face.
    pub(super) depth: f64,
    /// Whether displacements and the slope are wanted, too: they take as long as the stresses or longer.
    pub(super) displacements: bool,
}

/// G_n = (1/π) ∫ p̂ λⁿ e^(−λd + iλx) dλ at one point, n = 0, 1, 2: real parts belong to cos λx, imaginary ones to sin λx.
#[derive(Clone, Copy, Debug)]
pub(super) struct Potentials(pub(super) [Complex64; 3]);

/// The potentials at one point, and G_(−1), their integral over the depth.
pub(super) struct Closed {
    pub(super) potentials: Potentials,
    pub(super) integral: Complex64,
}
