//! The fields next to a loaded face for short waves: the slowly converging part of the fields of a body.
//!
//! For short waves a body is a half-plane of the material at the face, whose modulus may vary. Per unit of p̂ the fields at the
//! depth d are e^(−t) times polynomials in t = λd, and the terms of the variation have a factor 1/λ more. Each term has a
//! closed form in x, see [`super::pressure`]; the remainder is small and integrated: eq. (24).
use nalgebra::{Matrix4, Matrix4x2, Vector4};
use num_complex::Complex64;
use recede_layers::Material;

use super::potentials::{At, Closed, Components, Potentials};
use super::pressure::Pressure;
use super::roots::Roots;

/// Terms of the polynomials in t: of the half-plane, and of the variation of its material.
const PLAIN: usize = 2;
const VARIED: usize = 4;
/// Residual below which the equations of the polynomials count as solved.
const SOLVED: f64 = 1e-9;
/// The slope of the material is a finite difference over this part of a length.
const STEP: f64 = 1e-3;

/// One face, per unit of p̂ on it; the depth is measured from it into the body.
#[derive(Clone, Debug)]
pub(super) struct Surface {
    fields: Fields,
    /// μ₀, by which displacements are multiplied.
    modulus: f64,
    /// The length s below which the face is a half-plane's; infinite if it is one's altogether.
    pub(super) shift: f64,
    /// Terms with 1/λ are multiplied by 1 − e^(−λs), so that they stay finite for λ → 0. About an axis they do, since dλ is λdλ there.
    is_round: bool,
    /// −1 for a face that is the bottom of its body: V and T change their signs.
    up: f64,
}

#[derive(Clone, Debug)]
enum Fields {
    /// Both roots are 1, as for any isotropic material.
    Double(Polynomials),
    /// The roots differ; the variation of the material is part of the integrated remainder.
    Simple(Roots),
}

/// e^(−t) times polynomials in t.
#[derive(Clone, Debug)]
struct Polynomials {
    plain: [Components; PLAIN],
    varied: [Components; VARIED],
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
        let decay = Matrix4::identity() - state;
        let shift = depth.min(grading(&slope).recip());
        let Some(plain) = polynomials(&decay, PLAIN, &[], Some(-1.0)) else {
            let fields = Fields::Simple(Roots::new(&at_face, modulus)?);
            return Some(Self { fields, modulus, shift, is_round: false, up: 1.0 });
        };
        let forcing: Vec<Vector4<f64>> =
            [Vector4::zeros()].into_iter().chain(plain.iter().map(|y| -slope * y)).collect();
        let varied = polynomials(&decay, VARIED, &forcing, None).unwrap_or_else(|| vec![Vector4::zeros(); VARIED]);
        // σ_xx = E λU + c S, and the same with the slopes of E and c
        let along = |matrix: &Matrix4<f64>, y: &Vector4<f64>| matrix[(3, 0)] * y[0] + matrix[(3, 2)] * y[2];
        let softness = modulus / unit;
        let components =
            |y: &Vector4<f64>, along: f64| [along, y[2], y[3], softness * y[0], softness * y[1], softness * y[1]];
        let plain_states: Vec<Components> = plain.iter().map(|y| components(y, along(&state, y))).collect();
        let varied_states: Vec<Components> = (0..VARIED)
            .map(|k| {
                let before = k.checked_sub(1).and_then(|k| plain.get(k)).map_or(0.0, |y| along(&slope, y));
                components(&varied[k], along(&state, &varied[k]) + before)
            })
            .collect();
        let (plain, varied) = (plain_states.try_into().ok()?, varied_states.try_into().ok()?);
        Some(Self { fields: Fields::Double(Polynomials { plain, varied }), modulus, shift, is_round: false, up: 1.0 })
    }

    /// The same, under a pressure like this one.
    pub(super) fn under(self, pressure: &Pressure) -> Self {
        Self { is_round: pressure.is_round(), ..self }
    }

    /// How far below a place terms with 1/λ are taken that are subtracted.
    fn subtracted(&self) -> f64 {
        if self.is_round { f64::INFINITY } else { self.shift }
    }

    /// The transformed components at a wavenumber and a depth, per unit of p̂: stresses, λμ₀U, λμ₀V.
    pub(super) fn transformed(&self, wavenumber: f64, depth: f64) -> Components {
        let t = wavenumber * depth;
        let regular = -(-wavenumber * self.subtracted()).exp_m1();
        self.turned(match &self.fields {
            Fields::Double(polynomials) => polynomials.transformed(t, wavenumber.recip(), regular),
            Fields::Simple(roots) => roots.transformed(t, regular),
        })
    }

    /// The components at a point, in closed form. v includes a constant that [`Self::transformed`] makes finite; if the shift is
    /// infinite, it cancels in what is counted from another point.
    pub(super) fn closed(&self, pressure: &Pressure, at: &At) -> Components {
        self.turned(match &self.fields {
            Fields::Double(polynomials) => polynomials.closed(pressure, at, self.subtracted(), self.modulus),
            Fields::Simple(roots) => roots.closed(pressure, at, self.subtracted(), self.modulus),
        })
    }

    /// The same for the bottom face of a body.
    pub(super) fn upside_down(self) -> Self {
        Self { up: -self.up, ..self }
    }

    fn turned(&self, [along, across, shear, u, v, slope]: Components) -> Components {
        [along, across, self.up * shear, u, self.up * v, self.up * slope]
    }
}

impl Polynomials {
    fn transformed(&self, t: f64, over: f64, regular: f64) -> Components {
        let decay = (-t).exp();
        std::array::from_fn(|i| {
            let [p0, p1] = [self.plain[0][i], self.plain[1][i]];
            let v: [f64; VARIED] = std::array::from_fn(|k| self.varied[k][i]);
            let sum = if i < 3 {
                p0 + p1 * t + over * (v[0] * regular + t * (v[1] + t * (v[2] + t * v[3])))
            } else {
                p0 * regular + p1 * t
            };
            if decay > 0.0 { decay * sum } else { 0.0 }
        })
    }

    fn closed(&self, pressure: &Pressure, at: &At, shift: f64, modulus: f64) -> Components {
        let At { x, depth, displacements } = *at;
        // stresses take the integral where the material varies, and that about an axis the displacement from it
        let varies = self.varied[0][..3].iter().any(|value| *value != 0.0);
        let wanted = displacements || varies || pressure.is_round();
        let Closed { potentials: Potentials([g0, g1, g2]), mut integral } = pressure.closed(x, depth, wanted);
        let mut change = g0;
        if wanted && shift.is_finite() {
            integral -= pressure.integral(x, depth + shift);
            if displacements {
                change -= pressure.potentials(x, depth + shift).0[0];
            }
        }
        std::array::from_fn(|i| {
            let pick = |z: Complex64| if i == 2 || i == 3 || i == 5 { z.im } else { z.re };
            // at the ends of the contact g1 and g2 are infinite
            let at_depth = |power: i32, g| if depth > 0.0 { depth.powi(power) * pick(g) } else { 0.0 };
            let (p, v) = (&self.plain, &self.varied);
            if i < 3 {
                p[0][i] * pick(g0)
                    + (p[1][i] + v[2][i] * depth) * at_depth(1, g1)
                    + v[0][i] * pick(integral)
                    + v[1][i] * at_depth(1, g0)
                    + v[3][i] * at_depth(3, g2)
            } else if i == 5 {
                -(p[0][i] * pick(change) + p[1][i] * at_depth(1, g1)) / modulus
            } else {
                (p[0][i] * pick(integral) + p[1][i] * at_depth(1, g0)) / modulus
            }
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

/// The polynomial Σ y_k t^k that solves Y' = N Y + Σ f_k t^k with S = `load` (or 0) and T = 0 at t = 0; `None` if there is
/// none of this degree.
fn polynomials(
    matrix: &Matrix4<f64>,
    terms: usize,
    forcing: &[Vector4<f64>],
    load: Option<f64>,
) -> Option<Vec<Vector4<f64>>> {
    // y_(k+1) = (N y_k + f_k)/(k + 1), as a part for each unknown component U, V of y_0 and a part that is known
    let force = |k: usize| forcing.get(k).copied().unwrap_or_else(Vector4::zeros);
    let mut known = vec![Vector4::new(0.0, 0.0, load.unwrap_or(0.0), 0.0)];
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
    let solved = missed <= SOLVED * largest(forcing).max(load.map_or(0.0, f64::abs)).max(largest(&found));
    solved.then_some(found)
}

#[cfg(test)]
mod tests {
    use recede_layers::{Isotropic, Plane};

    use super::*;

    #[test]
    fn a_homogeneous_half_plane_is_that_of_mcewen() {
        for poisson in [-0.5, 0.0, 0.25, 0.5] {
            let material = |_: f64| Isotropic { shear_modulus: 3.0, poisson }.material(Plane::Strain);
            let surface = Surface::new(&material, 1.0, 2.0).expect("isotropic");
            let [xx, yy, xy, ..] = surface.transformed(0.8, 1.5);
            let t = 0.8 * 1.5;
            let decay = f64::exp(-t);
            for (found, expected) in [(xx, -(1.0 - t) * decay), (yy, -(1.0 + t) * decay), (xy, t * decay)] {
                assert!((found - expected).abs() < 1e-13, "{poisson}: {found} {expected}");
            }
        }
    }

    #[test]
    fn two_roots_that_come_close_make_a_double_one() {
        let isotropic = Isotropic { shear_modulus: 3.0, poisson: 0.3 }.material(Plane::Strain);
        for (stretch, tolerance) in [(1e-2, 2e-2), (1e-9, 1e-8), (-1e-9, 1e-8), (0.0, 1e-8)] {
            let material = Material { axial_stiffness: isotropic.axial_stiffness * (1.0 + stretch), ..isotropic };
            let simple = Roots::new(&material, 2.0).expect("decays");
            let double = Surface::new(&|_| isotropic, 1.0, 2.0).expect("isotropic");
            for t in [0.0, 0.4, 3.0] {
                // waves so short that the displacements have no remainder
                let (found, expected) = (simple.transformed(t, 1.0), double.transformed(100.0, 0.01 * t));
                for (found, expected) in found.iter().zip(expected) {
                    assert!((found - expected).abs() < tolerance, "{stretch} {t}: {found} {expected}");
                }
            }
        }
    }
}
