//! The fields next to a loaded face for short waves: the slowly converging part of the fields of a body.
//!
//! For short waves a body is a half-plane of the material at the face, whose modulus may vary. Per unit of p̂ the fields at the
//! depth d are e^(−t) times polynomials in t = λd, and the terms of the variation have a factor 1/λ more. Each term has a
//! closed form in x, see [`super::pressure`]; the remainder is small and integrated: eq. (24).
use nalgebra::{Matrix4, Matrix4x2, Vector4};
use num_complex::Complex64;
use recede_layers::Material;

use super::pressure::ContactPressure;

/// How many components a field has.
pub(super) const COMPONENTS: usize = 6;

/// σ_xx, σ_yy, σ_xy, the displacements u, v and the slope dv/dx at a point or, transformed, λμ₀U, λμ₀V and λμ₀V once more.
pub(super) type Components = [f64; COMPONENTS];

/// Terms of the polynomials in t: of the half-plane, and of the variation of its material.
const PLAIN: usize = 2;
const VARIED: usize = 4;
/// Residual below which the equations of the polynomials count as solved.
const SOLVED: f64 = 1e-9;
/// The slope of the material is a finite difference over this part of a length.
const STEP: f64 = 1e-3;
/// Roots closer than this, in parts of their size, are moved apart to this distance: the difference is part of the integrated remainder.
const APART: f64 = 1e-5;

/// One face, per unit of p̂ on it; the depth is measured from it into the body.
#[derive(Clone, Debug)]
pub(super) struct Surface {
    /// One for a double root, as of any isotropic material, two for different roots.
    terms: Vec<RootTerm>,
    /// μ₀, by which displacements are multiplied.
    modulus: f64,
    /// The length s below which the face is a half-plane's; infinite if it is one's altogether.
    pub(super) shift: f64,
    /// Terms with 1/λ are multiplied by 1 − e^(−λs), so that they stay finite for λ → 0. About an axis they do, since dλ is λdλ there.
    pub(super) is_round: bool,
    /// −1 for a face that is the bottom of its body: V and T change their signs.
    pub(super) up: f64,
    /// The difference of the fields next to the face and the closed form.
    pub(super) remainder: Remainder,
}

/// A remainder for short waves, size·λ^(−power) per unit of p̂.
#[derive(Clone, Copy, Debug)]
pub(super) struct Remainder {
    pub(super) size: f64,
    pub(super) power: f64,
}

/// e^(−st) times polynomials in t, s being a root of the characteristic equation of the material.
#[derive(Clone, Debug)]
struct RootTerm {
    /// s, with a positive real part; another one is its conjugate, or real as this one.
    root: Complex64,
    /// Coefficients of σ_xx, σ_yy, σ_xy, λμ₀U, λμ₀V, λμ₀V.
    plain: [[Complex64; COMPONENTS]; PLAIN],
    /// Coefficients for the variation of the material, with a factor 1/λ, if it is not part of the integrated remainder.
    varied: [[Complex64; COMPONENTS]; VARIED],
}

impl Surface {
    /// From the material as a function of the distance from the face, down to `depth`; `None` if no closed form is known.
    pub(super) fn new(material: &dyn Fn(f64) -> Material, depth: f64, modulus: f64) -> Option<Self> {
        let at_face = material(0.0);
        let unit = at_face.shear_compliance.recip();
        let state = state_matrix(&at_face, unit);
        let slope_over = |step: f64| {
            let weights = [-25.0, 48.0, -36.0, 16.0, -3.0];
            let shares = weights.iter().enumerate();
            shares.fold(Matrix4::zeros(), |slope, (k, weight)| {
                slope + (state_matrix(&material(k as f64 * step), unit) - state) * (weight / (12.0 * step))
            })
        };
        let grading =
            |slope: &Matrix4<f64>| (slope[(0, 3)] / state[(0, 3)]).abs().max((slope[(3, 0)] / state[(3, 0)]).abs());
        // once more with a smaller step where the material varies within a part of the depth
        let estimate = grading(&slope_over(STEP * depth));
        let slope = slope_over(STEP * depth.min(estimate.recip()));
        let terms = match polynomials(&state, PLAIN, &[], -1.0) {
            Some(plain) => vec![RootTerm::double(&state, &slope, &plain, modulus / unit)],
            None => RootTerm::simple(&at_face, modulus)?,
        };
        let shift = depth.min(grading(&slope).recip());
        // of a homogeneous material nothing remains
        let remainder = Remainder { size: 0.0, power: 2.0 };
        Some(Self { terms, modulus, shift, is_round: false, up: 1.0, remainder })
    }

    /// How far below a place terms with 1/λ are taken that are subtracted.
    fn subtracted(&self) -> f64 {
        if self.is_round { f64::INFINITY } else { self.shift }
    }

    /// The transformed components at a wavenumber and a depth, per unit of p̂: stresses, λμ₀U, λμ₀V.
    pub(super) fn transformed(&self, wavenumber: f64, depth: f64) -> Components {
        let regular = -(-wavenumber * self.subtracted()).exp_m1();
        let mut sum = Components::default();
        for term in &self.terms {
            let own = term.transformed(wavenumber * depth, wavenumber.recip(), regular);
            sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
        }
        self.turned(sum)
    }

    /// The components at a point, in closed form; displacements and the slope, which take as long as the stresses or longer, if they are
    /// wanted. v includes a constant that [`Self::transformed`] makes finite; if the shift is infinite, it cancels in what is counted from
    /// another point.
    pub(super) fn closed(&self, pressure: &ContactPressure, x: f64, depth: f64, displacements: bool) -> Components {
        let mut sum = Components::default();
        for term in &self.terms {
            let own = term.closed(pressure, [x, depth], self.subtracted(), displacements);
            sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
        }
        sum[3..].iter_mut().for_each(|displacement| *displacement /= self.modulus);
        self.turned(sum)
    }

    fn turned(&self, [along, across, shear, u, v, slope]: Components) -> Components {
        [along, across, self.up * shear, u, self.up * v, self.up * slope]
    }
}

impl RootTerm {
    /// The double root 1, from the polynomial of the half-plane and the slope of its state matrix; `softness` is the unit of displacements.
    fn double(state: &Matrix4<f64>, slope: &Matrix4<f64>, plain: &[Vector4<f64>], softness: f64) -> Self {
        let forcing: Vec<Vector4<f64>> =
            [Vector4::zeros()].into_iter().chain(plain.iter().map(|y| -slope * y)).collect();
        let varied = polynomials(state, VARIED, &forcing, 0.0).unwrap_or_else(|| vec![Vector4::zeros(); VARIED]);
        // σ_xx = E λU + c S, and the same with the slopes of E and c
        let along = |matrix: &Matrix4<f64>, y: &Vector4<f64>| matrix[(3, 0)] * y[0] + matrix[(3, 2)] * y[2];
        let components = |y: &Vector4<f64>, along: f64| {
            [along, y[2], y[3], softness * y[0], softness * y[1], softness * y[1]].map(Complex64::from)
        };
        let before = |k: usize| k.checked_sub(1).and_then(|k| plain.get(k)).map_or(0.0, |y| along(slope, y));
        Self {
            root: Complex64::ONE,
            plain: std::array::from_fn(|k| components(&plain[k], along(state, &plain[k]))),
            varied: std::array::from_fn(|k| components(&varied[k], along(state, &varied[k]) + before(k))),
        }
    }

    /// Two different roots, as of orthotropic material, with displacements in units of 1/`modulus`; `None` if some field would not decay.
    fn simple(material: &Material, modulus: f64) -> Option<Vec<Self>> {
        let [mut first, mut second] = material.squared_roots().map(Complex64::sqrt);
        if first.re <= 0.0 || second.re <= 0.0 {
            return None;
        }
        let size = first.norm();
        if (first - second).norm() < APART * size {
            let mean = 0.5 * (first + second).re;
            (first, second) = ((mean * (1.0 + 0.5 * APART)).into(), (mean * (1.0 - 0.5 * APART)).into());
        }
        // S = −1 and T = 0 on the face
        let share = (first - second).inv();
        let term = |(s, amplitude): (Complex64, Complex64)| {
            let along = (-s * s - material.coupling) / material.axial_stiffness * modulus;
            let across = s * (along + material.shear_compliance * modulus);
            let components = [-s * s, 1.0.into(), -s, along, across, across].map(|component| amplitude * component);
            let none = [Complex64::ZERO; COMPONENTS];
            Self { root: s, plain: [components, none], varied: [none; VARIED] }
        };
        Some([(first, second * share), (second, -first * share)].map(term).to_vec())
    }

    /// The transformed components at t = λd; `over` is 1/λ, and what is infinite for λ → 0 is multiplied by `regular`.
    fn transformed(&self, t: f64, over: f64, regular: f64) -> Components {
        let decay = (-self.root * t).exp();
        if decay == Complex64::ZERO {
            return Components::default();
        }
        let polynomial = |terms: &[[Complex64; COMPONENTS]], i: usize, first: f64| {
            let [constant, higher @ ..] = terms else { return Complex64::ZERO };
            higher.iter().rev().fold(Complex64::ZERO, |sum, term| sum * t + term[i]) * t + constant[i] * first
        };
        std::array::from_fn(|i| {
            let sum = match i {
                0..3 => polynomial(&self.plain, i, 1.0) + over * polynomial(&self.varied, i, regular),
                _ => polynomial(&self.plain, i, regular),
            };
            (decay * sum).re
        })
    }

    /// The stresses at a place and, if they are wanted, μ₀ times displacements and the slope, minus those at the depth `shift` farther down, if
    /// that is finite.
    fn closed(&self, pressure: &ContactPressure, [x, depth]: [f64; 2], shift: f64, displacements: bool) -> Components {
        let Self { root, plain: p, varied: v } = self;
        // e^(−sλd) with a complex s moves waves along x
        let (along, down) = (x - root.im * depth, root.re * depth);
        // stresses take the integral where the material varies, and the stress about an axis the displacement from it
        let varies = v[0][..3].iter().any(|value| *value != Complex64::ZERO);
        let wanted = displacements || varies || pressure.is_round();
        let [mut integral, g0, g1, g2] = pressure.potentials(along, down, wanted);
        let mut change = g0;
        if wanted && shift.is_finite() {
            let [deeper_integral, deeper, ..] = pressure.potentials(along, down + shift, true);
            integral -= deeper_integral;
            change -= deeper;
        }
        // at the ends of the contact g1 and g2 are infinite
        let at_depth = |power: i32, g: Complex64| if depth > 0.0 { depth.powi(power) * g } else { Complex64::ZERO };
        let [d1, d1_first, d3] = [at_depth(1, g0), at_depth(1, g1), at_depth(3, g2)];
        std::array::from_fn(|i| {
            let sum = match i {
                0..3 => {
                    p[0][i] * g0
                        + (p[1][i] + v[2][i] * depth) * d1_first
                        + v[0][i] * integral
                        + v[1][i] * d1
                        + v[3][i] * d3
                }
                3 | 4 => p[0][i] * integral + p[1][i] * d1,
                // the slope is a derivative of the displacement
                _ => -(p[0][i] * change + p[1][i] * d1_first),
            };
            // the parts with cos λx, or with sin λx
            if matches!(i, 2 | 3 | 5) { sum.im } else { sum.re }
        })
    }
}

/// The matrix A of the state equations for (λμU, λμV, S, T) in λy, with displacements in units of `modulus`.
#[rustfmt::skip]
fn state_matrix(material: &Material, modulus: f64) -> Matrix4<f64> {
    let (m, d) = (material.shear_compliance * modulus, material.normal_compliance * modulus);
    let (c, e) = (material.coupling, material.axial_stiffness / modulus);
    Matrix4::new(
        0.0, 1.0, 0.0,  m,
        -c,  0.0, d,    0.0,
        0.0, 0.0, 0.0, -1.0,
        e,   0.0, c,    0.0,
    )
}

/// The polynomial Σ y_k t^k that solves Y' = (1 − A) Y + Σ f_k t^k, A being the `state` matrix, with S = `load` and T = 0 at t = 0; `None` if there is none of this degree.
fn polynomials(state: &Matrix4<f64>, terms: usize, forcing: &[Vector4<f64>], load: f64) -> Option<Vec<Vector4<f64>>> {
    let matrix = Matrix4::identity() - state;
    // y_(k+1) = ((1 − A) y_k + f_k)/(k + 1), as a part for each unknown component U, V of y_0 and a part that is known
    let force = |k: usize| forcing.get(k).copied().unwrap_or_else(Vector4::zeros);
    let mut known = vec![Vector4::new(0.0, 0.0, load, 0.0)];
    let mut parts = vec![Matrix4x2::identity()];
    for k in 0..terms {
        let share = ((k + 1) as f64).recip();
        known.push((matrix * known[k] + force(k)) * share);
        parts.push(matrix * parts[k] * share);
    }
    // the polynomial ends there: four equations for two unknowns
    let (right_hand_side, part) = (-known.pop()?, parts.pop()?);
    let unknown = part.svd(true, true).solve(&right_hand_side, SOLVED).ok()?;
    let found: Vec<Vector4<f64>> = known.iter().zip(&parts).map(|(known, part)| known + part * unknown).collect();
    let largest = |vectors: &[Vector4<f64>]| vectors.iter().map(Vector4::amax).fold(0.0, f64::max);
    let missed = terms as f64 * (part * unknown - right_hand_side).amax();
    // not "missed > ...", which a NaN would pass
    let solved = missed <= SOLVED * largest(forcing).max(load.abs()).max(largest(&found));
    solved.then_some(found)
}

#[cfg(test)]
mod tests {
    use recede_layers::{Isotropic, Plane};

    use super::*;

    #[test]
    fn two_roots_that_come_close_make_a_double_one() {
        let isotropic = Isotropic { shear_modulus: 3.0, poisson: 0.3 }.material(Plane::Strain);
        for (stretch, tolerance) in [(1e-2, 2e-2), (1e-9, 1e-8), (-1e-9, 1e-8), (0.0, 1e-8)] {
            let material = Material { axial_stiffness: isotropic.axial_stiffness * (1.0 + stretch), ..isotropic };
            let simple = RootTerm::simple(&material, 2.0).expect("decays");
            let double = Surface::new(&|_| isotropic, 1.0, 2.0).expect("isotropic");
            for t in [0.0, 0.4, 3.0] {
                // waves so short that the displacements have no remainder
                let [first, second] = [0, 1].map(|k| simple[k].transformed(t, 1.0, 1.0));
                let found = first.into_iter().zip(second).map(|(first, second)| first + second);
                for (found, expected) in found.zip(double.transformed(100.0, 0.01 * t)) {
                    assert!((found - expected).abs() < tolerance, "{stretch} {t}: {found} {expected}");
                }
            }
        }
    }
}
