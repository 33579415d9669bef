//! Series for a thin layer, accurate entry by entry: about mid-depth where the grading is mild, from the softer face
//! where it is steep.
use nalgebra::{Matrix2, Matrix4, Matrix4x3, Vector2, Vector4};

use super::Exponential;
use crate::graded::{Clamped, inverse};
use crate::linear::solve_equilibrated;
use crate::{FaceStates, Flexibility, InnerStates, State, Wave};

/// A thin, mildly graded layer: in components symmetrised by √μ its state matrix is constant, and the even and odd
/// parts of the state about mid-depth are kept apart. For β = 0 they decouple exactly into stretching and bending.
pub(super) struct Mild {
    /// cosh − 1 of (state matrix × half thickness).
    even: Matrix4<f64>,
    /// sinh of the same.
    odd: Matrix4<f64>,
    /// Even and odd part of the field that starts from S = 1 at mid-depth, less uniform pressure.
    uniform: [State; 2],
    /// βh/4: √μ at the faces is e^∓ of it, relative to mid-depth.
    quarter: f64,
    /// μ₀/μ at mid-depth.
    displacement: f64,
}

impl Exponential {
    pub(super) fn mild(&self, wave: &Wave) -> Mild {
        let half = 0.5 * self.thickness.get();
        let quarter = 0.25 * self.steepness();
        let step = self.mild_step(wave);
        let (even, odd) = hyperbolic(&step);
        Mild {
            even,
            odd,
            uniform: deviation_from_growth(&step, 2),
            quarter,
            displacement: self.displacement_scale(wave, half),
        }
    }

    /// The state matrix of the symmetrised components times half the thickness.
    fn mild_step(&self, wave: &Wave) -> Matrix4<f64> {
        let quarter = 0.25 * self.steepness();
        let grading = Vector4::new(-quarter, -quarter, quarter, quarter);
        self.local(wave).matrix() * (0.5 * wave.wavenumber * self.thickness.get()) + Matrix4::from_diagonal(&grading)
    }

    /// States inside a thin, mildly graded layer: mid-depth is left by a part of the half thickness, upwards or
    /// downwards.
    pub(super) fn mild_inside(&self, wave: &Wave, depths: &[f64]) -> Vec<InnerStates> {
        let half = 0.5 * self.thickness.get();
        let (step, middle) = (self.mild_step(wave), self.displacement_scale(wave, half));
        let inside = depths.iter().map(|depth| {
            let part = 1.0 - depth / half;
            let (even, odd) = hyperbolic(&(step * part));
            let [even_uniform, odd_uniform] = deviation_from_growth(&(step * part), 2);
            // √μ relative to mid-depth
            let stress = (-0.25 * self.steepness() * part).exp();
            let displacement = middle / stress;
            let scale = Matrix4::from_diagonal(&Vector4::new(displacement, displacement, stress, stress));
            InnerStates {
                columns: scale * (Matrix4::identity() + even + odd),
                uniform: scale * (even_uniform + odd_uniform),
            }
        });
        inside.collect()
    }
}

/// Even and odd part of e^M x − e^q x for the unit vector x of one component, where M x = q x + w and w has no part
/// along x: with M^k x = q^k x + y_k, y_(k+1) = M y_k + q^k w, the sums of y_k/k!.
fn deviation_from_growth(step: &Matrix4<f64>, component: usize) -> [State; 2] {
    let mut forcing: State = step.column(component).into_owned();
    let q = std::mem::take(&mut forcing[component]);
    let mut parts = [State::zeros(), State::zeros()];
    let mut term = State::zeros();
    // |M| ≤ 110: terms shrink from the 110th on and are below rounding by the 400th
    for k in 1..400 {
        term = (step * term + forcing) / f64::from(k);
        forcing *= q / f64::from(k);
        parts[k as usize % 2] += term;
        if k > 4 && term.amax() + forcing.amax() < 1e-3 * f64::EPSILON * parts[0].amax().min(parts[1].amax()) {
            break;
        }
    }
    parts
}

/// (cosh M − 1, sinh M) by their power series, which keep the orders of small entries.
fn hyperbolic(step: &Matrix4<f64>) -> (Matrix4<f64>, Matrix4<f64>) {
    let square = step * step;
    // number of terms: size^(2k)/(2k)! below rounding
    let size = square.abs().row_sum().amax().min(square.abs().column_sum().amax());
    let (mut terms, mut last) = (1.0, 0.5 * size);
    while last > 0.1 * f64::EPSILON {
        terms += 1.0;
        last *= size / ((2.0 * terms - 1.0) * (2.0 * terms));
    }
    // Horner: cosh − 1 = M²/(1·2) (1 + M²/(3·4) (1 + ...)), sinh = M (1 + M²/(2·3) (1 + ...))
    let (mut even, mut odd) = (Matrix4::zeros(), Matrix4::zeros());
    let mut k = terms;
    while k >= 1.0 {
        even = (square + square * even) / ((2.0 * k - 1.0) * (2.0 * k));
        odd = (square + square * odd) / ((2.0 * k) * (2.0 * k + 1.0));
        k -= 1.0;
    }
    (even, step + step * odd)
}

impl Mild {
    /// Factors of the symmetrised components at the top (side = −1) or bottom (+1) face.
    fn scale(&self, side: f64) -> Matrix4<f64> {
        let stress = (side * self.quarter).exp();
        let displacement = self.displacement / stress;
        Matrix4::from_diagonal(&Vector4::new(displacement, displacement, stress, stress))
    }

    pub(super) fn face_states(&self) -> FaceStates {
        let (top, bottom) = (self.scale(-1.0), self.scale(1.0));
        let one = Matrix4::identity();
        let [even, odd] = self.uniform;
        FaceStates::Finite {
            top: top * (one + self.even + self.odd),
            bottom: bottom * (one + self.even - self.odd),
            uniform: [top * (even + odd), bottom * (even - odd)],
        }
    }

    /// Conditions in the form of half sums and half differences of the two faces.
    pub(super) fn flexibility(&self) -> Option<Flexibility> {
        let sum = Matrix4::identity() + self.even;
        let rows = Matrix4::from_rows(&[sum.row(2), self.odd.row(2), sum.row(3), self.odd.row(3)]);
        // symmetrised stress at the top face = S e^(+βh/4), at the bottom face = S e^(−βh/4)
        let (up, down) = (self.quarter.exp(), (-self.quarter).exp());
        // equal loads: uniform pressure is taken for granted, only the rest is asked for
        let [even, odd] = self.uniform;
        #[rustfmt::skip]
        let loads = Matrix4x3::new(
            0.5 * up, 0.5 * down,  -even[2],
            0.5 * up, -0.5 * down, -odd[2],
            0.0,      0.0,         -even[3],
            0.0,      0.0,         -odd[3],
        );
        let amplitudes = solve_equilibrated(rows, loads)?;
        let mut mean = sum.row(1) * amplitudes;
        let mut difference = self.odd.row(1) * amplitudes;
        mean[2] += even[1];
        difference[2] += odd[1];
        let top = |case: usize| self.displacement * up * (mean[case] + difference[case]);
        let bottom = |case: usize| self.displacement * down * (mean[case] - difference[case]);
        Some(Flexibility {
            top: top(0),
            coupling: top(1),
            bottom: bottom(1),
            equal_top: top(2),
            equal_bottom: bottom(2),
        })
    }
}

/// A thin, steeply graded layer: the state at the stiff face from the state at the soft face. In local components
/// (λμU, λμV, S, T) the state matrix in that direction has, apart from terms of relative order (λh)², entries of one
/// sign pattern, so that its exponential keeps every entry's digits.
pub(super) struct Steep {
    /// The state at the stiff face, less that at the soft one, in local components.
    growth: Matrix4<f64>,
    /// V at the stiff face from V = 1 at the soft one (in displacement, not in local components), less 1.
    lift: f64,
    /// μ₀/μ at the soft and at the stiff face.
    displacement: [f64; 2],
}

impl Exponential {
    pub(super) fn steep(&self, wave: &Wave) -> Steep {
        let h = self.thickness.get();
        let upwards = self.beta.get() < 0.0;
        let depths = if upwards { [h, 0.0] } else { [0.0, h] };
        let length = wave.wavenumber * h * if upwards { 1.0 } else { -1.0 };
        let steepness = self.steepness().abs();
        let step =
            self.local(wave).matrix() * length + Matrix4::from_diagonal(&Vector4::new(steepness, steepness, 0.0, 0.0));
        let [even, odd] = deviation_from_growth(&step, 1);
        Steep {
            growth: exponential_less_one(&step),
            lift: (even[1] + odd[1]) * (-steepness).exp(),
            displacement: depths.map(|d| self.displacement_scale(wave, d)),
        }
    }
}

/// e^M − 1 by its power series and squaring.
fn exponential_less_one(matrix: &Matrix4<f64>) -> Matrix4<f64> {
    let size = matrix.abs().column_sum().amax();
    let squarings = if size > 0.25 { (4.0 * size).log2().ceil() as i32 } else { 0 };
    let small = matrix * 0.5f64.powi(squarings);
    let mut sum = Matrix4::zeros();
    for k in (1..=12).rev() {
        sum = (small + small * sum) / f64::from(k);
    }
    for _ in 0..squarings {
        sum = sum * 2.0 + sum * sum;
    }
    sum
}

impl Steep {
    fn scale(&self, face: usize) -> Matrix4<f64> {
        let displacement = self.displacement[face];
        Matrix4::from_diagonal(&Vector4::new(displacement, displacement, 1.0, 1.0))
    }

    /// Amplitudes = the state at the soft face, or the stresses on one face while the other is clamped, as in the
    /// general body, where the faces do not just move together.
    pub(super) fn face_states(&self, soft_on_top: bool) -> FaceStates {
        let (soft, stiff) = (self.scale(0), self.scale(1));
        let stiff_states = stiff * (Matrix4::identity() + self.growth);
        let per_soft = Matrix4::from_diagonal(&soft.diagonal().map(f64::recip));
        let uniform = if soft_on_top { [self.uniform(), State::zeros()] } else { [State::zeros(), self.uniform()] };
        let to_stiff = stiff_states * per_soft - Matrix4::identity();
        let transfer = if soft_on_top { inverse(&to_stiff) } else { to_stiff };
        let clamped = Clamped::new(std::iter::once(&transfer));
        if clamped.is_independent() {
            clamped.face_states(uniform)
        } else if soft_on_top {
            FaceStates::Finite { top: soft, bottom: stiff_states, uniform }
        } else {
            FaceStates::Finite { top: stiff_states, bottom: soft, uniform }
        }
    }

    /// The field that starts from S = 1 at the stiff face, less uniform pressure, at the soft face: a column of the
    /// inverse transfer matrix. From stiffer to softer places stresses do not grow.
    fn uniform(&self) -> State {
        let [at_soft, at_stiff] = self.displacement;
        let v = self.growth.row(1) * at_stiff;
        State::new(-v[3], -v[2], self.lift, v[0] / at_soft)
    }

    /// With no shear on the soft face, its two displacements follow from S and T = 0 at the stiff face. Under equal
    /// loads the stiff face hardly moves compared with the soft one: there the two faces change their roles, with the
    /// inverse of the transfer matrix from its symplectic form (reciprocity), inverse = Ω⁻¹ transferᵀ Ω.
    pub(super) fn flexibility(&self, soft_on_top: bool) -> Option<Flexibility> {
        let g = &self.growth;
        let [at_soft, at_stiff] = self.displacement;
        let respond = |soft_load: f64, rest: f64| -> Option<[f64; 2]> {
            // rest = stiff load − soft load, exact for each load case
            let loads = Vector2::new(rest - g[(2, 2)] * soft_load, -g[(3, 2)] * soft_load);
            let w = solve_equilibrated(Matrix2::new(g[(2, 0)], g[(2, 1)], g[(3, 0)], g[(3, 1)]), loads)?;
            let stiff = g[(1, 0)] * w[0] + (1.0 + g[(1, 1)]) * w[1] + g[(1, 2)] * soft_load;
            Some([at_soft * w[1], at_stiff * stiff])
        };
        let (soft, stiff, mut equal) = (respond(1.0, -1.0)?, respond(0.0, 1.0)?, respond(1.0, 0.0)?);
        let inverse = -Matrix2::new(g[(3, 1)], g[(2, 1)], g[(3, 0)], g[(2, 0)]);
        let loads = Vector2::new(-self.lift, -g[(1, 0)] * (at_stiff / at_soft));
        equal[1] = at_soft * solve_equilibrated(inverse, loads)?[1];
        Some(if soft_on_top {
            Flexibility {
                top: soft[0],
                coupling: stiff[0],
                bottom: stiff[1],
                equal_top: equal[0],
                equal_bottom: equal[1],
            }
        } else {
            Flexibility {
                top: stiff[1],
                coupling: -stiff[0],
                bottom: soft[0],
                equal_top: equal[1],
                equal_bottom: equal[0],
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ClosedForm, Plane};

    #[test]
    fn every_entry_of_a_steep_layer_with_a_stiff_top_keeps_its_digits() {
        // multiple precision, from the exponential of the state matrix: βh = −30, ν = 1/4, λh = 0.9
        let layer = Exponential::new(1.0, 1.0, 0.25, -30.0).expect("legal");
        let wave = Wave { wavenumber: 0.9, modulus: 1.0, plane: Plane::Strain };
        let found = layer.flexibility(&wave).expect("finite");
        for (found, expected) in [
            (found.top, 13963.819366565489),
            (found.coupling, -12279.426290574647),
            (found.bottom, -106864604011.04976),
            (found.equal_top, 1684.3930759908427),
            (found.equal_bottom, -106864591731.62347),
        ] {
            assert!((found / expected - 1.0).abs() < 1e-13, "{found} ≠ {expected}");
        }
    }

    #[test]
    fn face_states_keep_the_digits_of_equal_loads_too() {
        // steeper than that, an incompressible layer answers equal loads with fewer digits
        for (poisson, steepest) in [(-0.9, 100.0), (0.0, 100.0), (0.25, 100.0), (0.5, 8.0)] {
            for steepness in [1.1, 4.0, 8.0, 30.0, 100.0].into_iter().filter(|b| *b <= steepest).flat_map(|b| [b, -b]) {
                let layer = Exponential::new(1.0, 1.0, poisson, steepness).expect("legal");
                for wavenumber in [1e-8, 1e-4, 1e-2, 0.1, 0.5, 1.0] {
                    let wave = Wave { wavenumber, modulus: 1.0, plane: Plane::Strain };
                    let expected = layer.flexibility(&wave).expect("finite");
                    let found = Flexibility::of_face_states(&layer.face_states(&wave)).expect("finite");
                    for (found, expected) in [
                        (found.top, expected.top),
                        (found.bottom, expected.bottom),
                        (found.equal_top, expected.equal_top),
                        (found.equal_bottom, expected.equal_bottom),
                    ] {
                        let error = (found / expected - 1.0).abs();
                        assert!(error < 1e-11, "ν = {poisson}, βh = {steepness}, λh = {wavenumber}: {error:e}");
                    }
                }
            }
        }
    }
}
