//! An exponentially graded layer, μ(d) = μ_top e^(βd): closed forms for thick layers, entry-wise accurate series for
//! thin ones, continuous at β = 0.
use nalgebra::{Matrix2, Matrix4, Matrix4x3, Vector2, Vector4};
use serde::Deserialize;

use crate::linear::solve_equilibrated;
use crate::{
    FaceStates, Finite, Flexibility, Isotropic, Layer, LayerError, Material, Notation, Plane, Poisson, Positive, State,
    Thickness, Wave,
};

/// Up to this λh the amplitudes are the state at one depth; beyond, solutions that decay from either face.
const THIN: f64 = 1.0;
/// Up to this |βh| a thin layer is expanded about mid-depth, beyond from its softer face.
const MILD: f64 = 1.0;
/// Steeper layers are refused: the modulus would vary by more than e^±100.
const STEEPEST: f64 = 100.0;

/// Isotropic layer of constant Poisson's ratio whose shear modulus is μ_top e^(βd) at depth d below its top face.
///
/// ```
/// use recede_layers::{Exponential, Layer, Plane};
/// let graded = Exponential::new(1.0, 1.0, 0.25, -1.0)?;
/// let bottom = graded.material(1.0, Plane::Strain);
/// assert!((1.0 / bottom.shear_compliance - (-1.0f64).exp()).abs() < 1e-15);
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, try_from = "Fields")]
pub struct Exponential {
    thickness: Thickness,
    shear_modulus: Positive,
    poisson: Poisson,
    beta: Finite,
}

/// The fields as written in a scene, before they are checked together.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename = "Exponential")]
struct Fields {
    thickness: Thickness,
    shear_modulus: Positive,
    poisson: Poisson,
    beta: Finite,
}

impl TryFrom<Fields> for Exponential {
    type Error = LayerError;

    fn try_from(fields: Fields) -> Result<Self, LayerError> {
        let Fields { thickness, shear_modulus, poisson, beta } = fields;
        let found = beta.get() * thickness.get();
        if found.abs() <= STEEPEST {
            Ok(Self { thickness, shear_modulus, poisson, beta })
        } else {
            Err(LayerError::TooSteep { found, limit: STEEPEST })
        }
    }
}

impl Exponential {
    /// A layer of thickness h ≥ 0 (length; 0 means "not there"), shear modulus μ_top > 0 at its top face (stress),
    /// Poisson's ratio −1 < ν ≤ 1/2 and grading exponent β (1/length, positive: stiffer with depth), |βh| ≤ 100.
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite.
    pub fn new(thickness: f64, shear_modulus: f64, poisson: f64, beta: f64) -> Result<Self, LayerError> {
        Self::try_from(Fields {
            thickness: LayerError::checked("thickness", thickness)?,
            shear_modulus: LayerError::checked("shear_modulus", shear_modulus)?,
            poisson: LayerError::checked("poisson", poisson)?,
            beta: LayerError::checked("beta", beta)?,
        })
    }

    fn at(&self, depth: f64) -> Isotropic {
        Isotropic {
            shear_modulus: self.shear_modulus.get() * (self.beta.get() * depth).exp(),
            poisson: self.poisson.get(),
        }
    }

    /// βh.
    fn steepness(&self) -> f64 {
        self.beta.get() * self.thickness.get()
    }

    fn local(&self, wave: &Wave) -> Local {
        let unit = Isotropic { shear_modulus: 1.0, poisson: self.poisson.get() }.material(wave.plane);
        Local { c: unit.coupling, d: unit.normal_compliance, e: unit.axial_stiffness }
    }

    /// μ₀/μ at a depth: brings local displacements λμU to the modulus of `wave`.
    fn displacement_scale(&self, wave: &Wave, depth: f64) -> f64 {
        wave.modulus / self.at(depth).shear_modulus
    }
}

/// Coefficients of the state equations for μ = 1.
#[derive(Clone, Copy, Debug)]
struct Local {
    c: f64,
    d: f64,
    e: f64,
}

impl Local {
    /// The state matrix A of the local components (λμU, λμV, S, T) in ζ = λy, without the grading.
    #[rustfmt::skip]
    fn matrix(&self) -> Matrix4<f64> {
        Matrix4::new(
            0.0,     1.0,  0.0,     1.0,
            -self.c, 0.0,  self.d,  0.0,
            0.0,     0.0,  0.0,    -1.0,
            self.e,  0.0,  self.c,  0.0,
        )
    }
}

impl Layer for Exponential {
    fn thickness(&self) -> Option<f64> {
        Some(self.thickness.get())
    }

    fn material(&self, depth: f64, plane: Plane) -> Material {
        self.at(depth).material(plane)
    }

    fn face_states(&self, wave: &Wave) -> FaceStates {
        if wave.wavenumber * self.thickness.get() > THIN {
            self.thick(wave)
        } else if self.steepness().abs() <= MILD {
            self.mild(wave).face_states()
        } else {
            self.steep(wave).face_states(self.beta.get() > 0.0)
        }
    }

    fn flexibility(&self, wave: &Wave) -> Option<Flexibility> {
        if wave.wavenumber * self.thickness.get() > THIN {
            Flexibility::of_face_states(&self.thick(wave))
        } else if self.steepness().abs() <= MILD {
            self.mild(wave).flexibility()
        } else {
            self.steep(wave).flexibility(self.beta.get() > 0.0)
        }
    }

    fn notation(&self) -> Notation {
        Notation {
            kind: "Exponential",
            parameters: format!(
                "thickness: {}, shear_modulus: {}, poisson: {}, beta: {}",
                self.thickness.get(),
                self.shear_modulus.get(),
                self.poisson.get(),
                self.beta.get()
            ),
        }
    }
}

/// A thin, mildly graded layer: in components symmetrised by √μ its state matrix is constant, and the even and odd
/// parts of the state about mid-depth are kept apart. For β = 0 they decouple exactly into stretching and bending.
struct Mild {
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
    fn mild(&self, wave: &Wave) -> Mild {
        let half = 0.5 * self.thickness.get();
        let quarter = 0.25 * self.steepness();
        let grading = Vector4::new(-quarter, -quarter, quarter, quarter);
        let step = self.local(wave).matrix() * (wave.wavenumber * half) + Matrix4::from_diagonal(&grading);
        let (even, odd) = hyperbolic(&step);
        Mild {
            even,
            odd,
            uniform: deviation_from_growth(&step, 2),
            quarter,
            displacement: self.displacement_scale(wave, half),
        }
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

    fn face_states(&self) -> FaceStates {
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
    fn flexibility(&self) -> Option<Flexibility> {
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
struct Steep {
    /// The state at the stiff face, less that at the soft one, in local components.
    growth: Matrix4<f64>,
    /// V at the stiff face from V = 1 at the soft one (in displacement, not in local components), less 1.
    lift: f64,
    /// μ₀/μ at the soft and at the stiff face.
    displacement: [f64; 2],
}

impl Exponential {
    fn steep(&self, wave: &Wave) -> Steep {
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

    fn face_states(&self, soft_on_top: bool) -> FaceStates {
        let (soft, stiff) = (self.scale(0), self.scale(1));
        let stiff_states = stiff * (Matrix4::identity() + self.growth);
        let deviation = [State::zeros(), stiff * self.growth.column(2)];
        if soft_on_top {
            FaceStates::Finite { top: soft, bottom: stiff_states, uniform: deviation }
        } else {
            FaceStates::Finite { top: stiff_states, bottom: soft, uniform: [deviation[1], deviation[0]] }
        }
    }

    /// With no shear on the soft face, its two displacements follow from S and T = 0 at the stiff face. Under equal
    /// loads the stiff face hardly moves compared with the soft one: there the two faces change their roles, with the
    /// inverse of the transfer matrix from its symplectic form (reciprocity), inverse = Ω⁻¹ transferᵀ Ω.
    fn flexibility(&self, soft_on_top: bool) -> Option<Flexibility> {
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

/// A pair of roots ±(p ± iω) of the symmetrised state matrix, per λ: p² − ω² = 1 + b²/4, 2pω = bδ with b = β/λ and
/// δ² = c = (3 − κ)/(κ + 1). For κ > 3 the pair is real, ω² < 0. Nothing is singular where roots coincide (b → 0, κ → 3).
struct Pair {
    p: f64,
    omega_squared: f64,
    b: f64,
    local: Local,
    /// p − |b|/2 and p + |b|/2.
    shifted: [f64; 2],
}

impl Pair {
    /// The paper's (2.7), written without complex numbers and without cancellation.
    fn new(local: Local, b: f64) -> Self {
        let a = 1.0 + 0.25 * b * b;
        let root = (a * a + b * b * local.c).max(0.0).sqrt();
        let p_squared = 0.5 * (a + root);
        let p = p_squared.sqrt();
        let omega_squared = 0.25 * b * b * local.c / p_squared;
        let above = 0.5 * (1.0 + (1.0 + b * b * (0.5 + local.c)) / (root + 0.25 * b * b));
        let sum = p + 0.5 * b.abs();
        Self { p, omega_squared, b, local, shifted: [above / sum, sum] }
    }

    /// The two solutions of the roots side·(p ± iω) (side = ±1) at ζ = λy, where side·ζ ≤ 0, without the factor √μ:
    /// [X, S-part] as symmetrised local components, times `stress` for S, T and `displacement` for U, V.
    fn solutions(&self, side: f64, zeta: f64, [displacement, stress]: [f64; 2]) -> [State; 2] {
        let Local { c, e, .. } = self.local;
        let w2 = self.omega_squared;
        let [less, more] = self.shifted;
        // exponent of the displacements m = σ + b/2 and of the stresses n = σ − b/2 at σ = side·p
        let same = side * self.b > 0.0;
        let (m, n) = if same { (side * more, side * less) } else { (side * less, side * more) };
        // eigenvector S = 1, T = −n, u = −(n² + c)/e, v = m u + n as a function of σ: its value over the pair, x_r,
        // and its divided difference, x_d, x(σ ± iω) = x_r ± iω x_d. In u_r stands c − ω² = c (p² − b²/4)/p².
        let u = -(n * n + c * less * more / (self.p * self.p)) / e;
        let u_difference = -2.0 * n / e;
        let value = Vector4::new(u, m * u - w2 * u_difference + n, 1.0, -n);
        let difference = Vector4::new(u_difference, u + m * u_difference + 1.0, 0.0, -1.0);
        let (cosine, sine) = self.decay(side * zeta);
        let sine = side * sine;
        let scale = Vector4::new(displacement, displacement, stress, stress);
        [
            (value * cosine - difference * (w2 * sine)).component_mul(&scale),
            (value * sine + difference * cosine).component_mul(&scale),
        ]
    }

    /// e^(pt) cos ωt and e^(pt) sin(ωt)/ω for t ≤ 0, hyperbolic if ω² < 0.
    fn decay(&self, t: f64) -> (f64, f64) {
        let omega = self.omega_squared.abs().sqrt();
        let angle = omega * t;
        if self.omega_squared >= 0.0 {
            let decay = (self.p * t).exp();
            let sinc = if angle.abs() < 1e-4 { 1.0 - angle * angle / 6.0 } else { angle.sin() / angle };
            (decay * angle.cos(), decay * t * sinc)
        } else if angle.abs() < 0.5 {
            let decay = (self.p * t).exp();
            let square = angle * angle;
            // sinh(x)/x for |x| < 1/2
            let sinhc = 1.0
                + square / 6.0
                    * (1.0 + square / 20.0 * (1.0 + square / 42.0 * (1.0 + square / 72.0 * (1.0 + square / 110.0))));
            (decay * angle.cosh(), decay * t * sinhc)
        } else {
            let (slow, fast) = (((self.p - omega) * t).exp(), ((self.p + omega) * t).exp());
            (0.5 * (slow + fast), 0.5 * (fast - slow) / omega)
        }
    }
}

impl Exponential {
    /// Amplitudes = two solutions that decay from the top face and two that decay from the bottom face.
    fn thick(&self, wave: &Wave) -> FaceStates {
        let h = self.thickness.get();
        let z = wave.wavenumber * h;
        let pair = Pair::new(self.local(wave), self.beta.get() / wave.wavenumber);
        let [top, bottom] = [0.0, h].map(|d| self.displacement_scale(wave, d));
        // √(μ_bottom/μ_top)
        let rise = (0.5 * self.steepness()).exp();
        let [a, b] = pair.solutions(1.0, 0.0, [top, 1.0]);
        let [c, d] = pair.solutions(-1.0, z, [bottom * rise, rise.recip()]);
        let top_states = Matrix4::from_columns(&[a, b, c, d]);
        let [a, b] = pair.solutions(1.0, -z, [top / rise, rise]);
        let [c, d] = pair.solutions(-1.0, 0.0, [bottom, 1.0]);
        let bottom_states = Matrix4::from_columns(&[a, b, c, d]);
        FaceStates::thick(top_states, bottom_states)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_modulus_that_varies_too_much_is_refused() {
        assert!(Exponential::new(2.0, 1.0, 0.25, 50.0).is_ok());
        let error = Exponential::new(2.0, 1.0, 0.25, -50.1).expect_err("too steep");
        assert_eq!(error, LayerError::TooSteep { found: -100.2, limit: STEEPEST });
    }

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
    fn roots_are_those_of_the_state_matrix() {
        // s = p ± iω solves (s² − 1 − b²/4)² = −b² c, also where the pair is real (c < 0)
        for c in [-0.8, 0.0, 1.0 / 3.0, 1.0] {
            for b in [-3.0, 0.0, 1e-6, 0.5, 20.0] {
                let pair = Pair::new(Local { c, d: 0.0, e: 1.0 }, b);
                let [sum, product] = [pair.p * pair.p - pair.omega_squared, 2.0 * pair.p];
                assert!((sum / (1.0 + 0.25 * b * b) - 1.0).abs() < 1e-14, "c = {c}, b = {b}");
                let square = product * product * pair.omega_squared;
                assert!((square - b * b * c).abs() < 1e-13 * (1.0 + b * b), "c = {c}, b = {b}");
            }
        }
    }
}
