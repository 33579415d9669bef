//! The pressure on one strip, about its middle: potentials in closed form.
use std::f64::consts::{FRAC_PI_2, LN_2, PI};

use num_complex::Complex64;

use super::potentials::{Closed, Potentials};
use super::spheroid;
use crate::solution::{Form, Strip};

/// Terms of the potentials below this part of the largest one are left out.
const NEGLIGIBLE: f64 = 1e-18;

/// Squares of w below this are terms of a series.
const SMALL: f64 = 1e-6;

/// Terms of the series whose sum is below this part of the largest one are left out.
const ROUNDED: f64 = 1e-16;

/// The pressure on a strip, x measured from its middle: p(x) = Σ c_j sin jφ, x = a cos φ, j = 2m + 1.
#[derive(Clone, Debug)]
pub(super) struct StripPressure {
    pub(super) half_length: f64,
    /// (−1)^m c_j.
    pub(super) series: Vec<f64>,
    /// (−1)^m c_j of j = 2m + 2, which the mirror strip has with the other sign.
    pub(super) skew: Vec<f64>,
    /// Of 1/sin φ.
    pub(super) corners: f64,
    /// Of arcosh(1/|cos φ|) = 2 Σ (−1)^m sin jφ/j.
    pub(super) tip: f64,
    pub(super) form: Form,
    /// Whether it is a disc about the axis, see [`super::disc`]: without signs in the series.
    pub(super) is_round: bool,
    /// The series of a disc as its potentials take it, see [`super::spheroid`].
    pub(super) by_order: Vec<f64>,
    /// Amplitudes of p̂ at the wavenumbers λ_k = SAMPLED^k/a.
    pub(super) envelope: Vec<f64>,
}

impl StripPressure {
    pub(super) fn new(strip: &Strip) -> Self {
        let is_round = strip.is_round;
        let sign = |m: usize| if is_round || m.is_multiple_of(2) { 1.0 } else { -1.0 };
        let signed = |all: &[f64]| all.iter().enumerate().map(|(m, c)| sign(m) * c).collect();
        let (series, skew) = (signed(&strip.coefficients), signed(&strip.skew));
        let Strip { extent: half_length, corners, tip, form, .. } = *strip;
        let [by_order, envelope] = [const { Vec::new() }; 2];
        let whole = Self { half_length, series, skew, corners, tip, form, is_round, by_order, envelope };
        let pressure = whole.truncated(ROUNDED);
        Self { envelope: pressure.sampled_envelope(), ..pressure }
    }

    /// Without the last terms of the series, as long as together they stay below this part of the largest one. The
    /// resultant remains.
    pub(super) fn truncated(&self, part: f64) -> Self {
        if self.form != Form::Series {
            return self.clone();
        }
        let largest = self.series.iter().fold(self.corners.abs(), |a, c| a.max(c.abs()));
        let mut left_out = 0.0;
        let mut keep = self.series.len();
        while keep > 1 {
            left_out += self.series[keep - 1].abs() + self.skew.get(keep - 1).map_or(0.0, |c| c.abs());
            if left_out > part * largest {
                break;
            }
            keep -= 1;
        }
        let skew = self.skew[..keep.min(self.skew.len())].to_vec();
        let (series, by_order, envelope) = (self.series[..keep].to_vec(), Vec::new(), self.envelope.clone());
        let pressure = Self { series, skew, by_order, envelope, ..*self };
        let by_order = if self.is_round { spheroid::by_order(&pressure.weighted()) } else { Vec::new() };
        Self { by_order, ..pressure }
    }

    /// The resultant P = p̂(0); of a disc P/2π.
    pub(super) fn resultant(&self) -> f64 {
        if self.is_round {
            return match self.form {
                Form::Line => self.first() / (2.0 * PI),
                _ => self.half_length * self.half_length * (self.first() / 3.0 + self.corners + 0.5 * self.tip),
            };
        }
        if self.form == Form::Line {
            return self.first();
        }
        FRAC_PI_2 * self.half_length * (self.first() + 2.0 * (self.corners + self.tip))
    }

    pub(super) fn first(&self) -> f64 {
        self.series.first().copied().unwrap_or(0.0)
    }

    /// Whether the pressure has a part that is odd about the middle.
    pub(super) fn is_skew(&self) -> bool {
        !self.skew.is_empty()
    }

    /// Whether the pressure does not vanish at its ends.
    pub(super) fn is_abrupt(&self) -> bool {
        self.form == Form::Uniform || self.corners != 0.0
    }

    /// w = √(z² + 1) − z with z = (d − ix)/a, and the root: ∫ J_j(λa) e^(−λaz) dλ/λ = wʲ/j.
    fn map(&self, x: f64, depth: f64) -> (Complex64, Complex64, Complex64) {
        let z = Complex64::new(depth, -x) / self.half_length;
        let root = (z * z + 1.0).sqrt();
        // the branch on which w is inside the unit circle
        let root = if root.re * z.re + root.im * z.im < 0.0 { -root } else { root };
        (z, root, (z + root).inv())
    }

    /// The number of terms of the series that are not negligible for powers of w² = `square`, and whether the series has that many.
    fn terms(&self, square: Complex64) -> (usize, bool) {
        let falls = square.norm().ln();
        let most = self.series.len();
        let enough = if falls < 0.0 { (NEGLIGIBLE.ln() / falls) as usize + 1 } else { usize::MAX };
        (most.min(enough), enough <= most)
    }

    /// The potentials at a depth, eq. (25), of the strip or, with `mirror` −1, of its mirror strip. G_1 and G_2 are
    /// infinite at the ends of the strip, and all of them at its [`Self::singular_points`].
    pub(super) fn potentials(&self, x: f64, depth: f64, mirror: f64) -> Potentials {
        if self.is_round {
            return self.disc_potentials(x, depth).potentials;
        }
        if self.form == Form::Line {
            // the transform is P: powers of 1/(d − ix)
            let over = Complex64::new(depth, -x).inv();
            let zeroth = self.resultant() / PI * over;
            return Potentials([zeroth, zeroth * over, 2.0 * zeroth * over * over]);
        }
        let (z, root, w) = self.map(x, depth);
        let square = w * w;
        let (terms, enough) = self.terms(square);
        if let (false, Some(closed)) = (enough, self.closed(z)) {
            return closed.potentials;
        }
        let sums = |series: &[f64], lowest: usize| {
            let mut sums = [Complex64::ZERO; 3];
            for (m, c) in series.iter().enumerate().rev() {
                let order = (2 * m + lowest) as f64;
                sums[0] = sums[0] * square + c;
                sums[1] = sums[1] * square + order * c;
                sums[2] = sums[2] * square + order * order * c;
            }
            sums
        };
        let mut all = sums(&self.series[..terms], 1).map(|sum| sum * w);
        if self.is_skew() {
            // −2 sin λm e^(iλx) = −i e^(iλ(x − m)) + i e^(iλ(x + m))
            let turned = Complex64::new(0.0, -mirror) * square;
            let odd = sums(&self.skew[..terms.min(self.skew.len())], 2);
            all.iter_mut().zip(odd).for_each(|(sum, odd)| *sum += turned * odd);
        }
        let [zeroth, first, second] = all;
        let over = root.inv();
        let a = self.half_length;
        let mut potentials = [zeroth, first * over / a, (second + z * first * over) * over * over / (a * a)];
        if self.corners != 0.0 {
            // 1/root and its derivatives
            let third = over * over * over;
            potentials[0] += self.corners * over;
            potentials[1] += self.corners * z * third / a;
            potentials[2] += self.corners * (2.0 * z * z - 1.0) * third * over * over / (a * a);
        }
        if self.tip != 0.0 {
            // 2 artanh w and its derivatives
            let first = over / z;
            potentials[0] += self.tip * artanh_twice(z, w);
            potentials[1] += self.tip * first / a;
            potentials[2] += self.tip * (2.0 * z * z + 1.0) * first * first * over / (a * a);
        }
        Potentials(potentials)
    }

    /// The places, measured from the middle, at which stresses on the face are infinite, and the kind of the singularity: a line load, the
    /// corners of a flat punch, and a sharp tip.
    pub(super) fn singular_points(&self) -> impl Iterator<Item = (f64, Singularity)> {
        let a = self.half_length;
        let line = (self.form == Form::Line).then_some((0.0, Singularity::Line));
        let corners = [-a, a].map(|end| (end, Singularity::Corner)).into_iter().filter(|_| self.corners != 0.0);
        let tip = (self.tip != 0.0).then_some((0.0, Singularity::Tip));
        line.into_iter().chain(corners).chain(tip)
    }

    /// G_(−1), minus a constant that is infinite: the integral of G_0 over the depth, eq. (26).
    pub(super) fn integral(&self, x: f64, depth: f64, mirror: f64) -> Complex64 {
        if self.is_round {
            return self.disc_potentials(x, depth).integral;
        }
        if self.form == Form::Line {
            return -self.resultant() / PI * logarithm(Complex64::new(depth, -x));
        }
        let (z, _, w) = self.map(x, depth);
        let square = w * w;
        let (terms, enough) = self.terms(square);
        if let (false, Some(closed)) = (enough, self.closed(z)) {
            return closed.integral;
        }
        let mut sum = Complex64::ZERO;
        for m in (0..terms).rev() {
            let next = self.series.get(m + 1).copied().unwrap_or(0.0);
            sum = sum * square + (self.series[m] + next) / (2 * m + 2) as f64;
        }
        let mut sum = sum * square + (self.first() + 2.0 * self.corners) * w.ln();
        for (m, c) in self.skew.iter().enumerate().take(terms) {
            let (below, above) = ((2 * m + 1) as f64, (2 * m + 3) as f64);
            let both = w.powi(2 * m as i32 + 1) / below + w.powi(2 * m as i32 + 3) / above;
            sum += Complex64::new(0.0, -mirror) * c * both;
        }
        let plain = 0.5 * self.half_length * sum;
        if self.tip == 0.0 || z == Complex64::ZERO {
            return plain + self.tip * self.half_length;
        }
        plain + self.tip * self.half_length * (1.0 - z * artanh_twice(z, w) + w.ln())
    }

    /// Remainder of the series close to the ends of strips where the pressure ends abruptly, or with a kink: below
    /// eq. (26).
    fn closed(&self, z: Complex64) -> Option<Closed> {
        let (upper, lower) = (logarithm(z + Complex64::I), logarithm(z - Complex64::I));
        // arccot z, ln (z² + 1)
        let (angle, both) = (-0.5 * Complex64::I * (upper - lower), upper + lower);
        let (a, resultant) = (self.half_length, self.resultant());
        let square = z * z + 1.0;
        let (factor, potentials, integral) = match self.form {
            Form::Uniform => {
                let factor = resultant / (PI * a);
                let potentials = [angle, square.inv() / a, 2.0 * z / (square * square) / (a * a)];
                (factor, potentials, -z * angle - 0.5 * both + (1.0 - LN_2))
            }
            Form::Parabolic => {
                let factor = 1.5 * resultant / (PI * a);
                let potentials =
                    [square * angle - z, 2.0 * (1.0 - z * angle) / a, 2.0 * (angle - z / square) / (a * a)];
                let integral = -z * (1.0 + z * z / 3.0) * angle - both / 3.0 + z * z / 3.0;
                (factor, potentials, integral + (8.0 / 9.0 - 2.0 / 3.0 * LN_2))
            }
            Form::Series | Form::Line => return None,
        };
        Some(Closed {
            potentials: Potentials(potentials.map(|potential| factor * potential)),
            integral: factor * a * integral,
        })
    }
}

/// The kind of a singularity of the stresses on a loaded face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Singularity {
    /// Like the inverse of the distance, and v like its logarithm.
    Line,
    /// Like the inverse of the root of the distance.
    Corner,
    /// Like the logarithm of the distance: shear stresses stay finite.
    Tip,
}

/// 2 artanh w, w = √(z² + 1) − z.
fn artanh_twice(z: Complex64, w: Complex64) -> Complex64 {
    if w.norm_sqr() < SMALL {
        let square = w * w;
        return 2.0 * w * (1.0 + square / 3.0 + square * square / 5.0);
    }
    // 1 − w² = 2zw keeps its digits next to the tip
    ((1.0 + w) * (1.0 + w) / (2.0 * z * w)).ln()
}

/// ln z, finite at 0.
fn logarithm(z: Complex64) -> Complex64 {
    if z == Complex64::ZERO { Complex64::new(f64::MIN_POSITIVE.ln(), 0.0) } else { z.ln() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strip(form: Form) -> StripPressure {
        with_tip(form, 0.0)
    }

    fn with_tip(form: Form, tip: f64) -> StripPressure {
        let (at, extent) = (0.0, 0.7);
        let order = |m: usize| (2 * m + 1) as f64;
        let coefficients = match form {
            Form::Line => vec![1.3],
            Form::Series => vec![1.3, -0.4, -0.1, -0.02],
            Form::Uniform => (0..64).map(|m| 1.3 / order(m)).collect(),
            Form::Parabolic => (0..64).map(|m| -3.9 / (order(m) * (order(m).powi(2) - 4.0))).collect(),
        };
        let (corners, tip) = if form == Form::Series { (0.8, tip) } else { (0.0, 0.0) };
        StripPressure::new(&Strip { at, extent, coefficients, skew: Vec::new(), corners, tip, form, is_round: false })
    }

    const FORMS: [Form; 3] = [Form::Series, Form::Uniform, Form::Parabolic];

    #[test]
    fn potentials_are_integrals_of_the_transform() {
        let rule = crate::numeric::quadrature::rule(64);
        let places = [(0.0, 0.5), (0.3, 0.9), (0.7, 0.4), (1.9, 0.6)];
        let forms = FORMS.into_iter().chain([Form::Line]);
        for (form, (x, depth)) in forms.flat_map(|form| places.map(|place| (form, place))) {
            let strip = strip(form);
            let mut sums = [Complex64::ZERO; 3];
            for panel in 0..20 {
                let (wavenumbers, weights): (Vec<f64>, Vec<f64>) =
                    rule.on(5.0 * f64::from(panel), 5.0 * f64::from(panel + 1)).unzip();
                let transforms = strip.minus_resultant(&wavenumbers);
                for ((l, weight), variation) in wavenumbers.iter().zip(weights).zip(transforms) {
                    let p = strip.resultant() + variation;
                    let wave = Complex64::new(-l * depth, l * x).exp() * (weight * p / PI);
                    sums[0] += wave;
                    sums[1] += wave * l;
                    sums[2] += wave * l * l;
                }
            }
            let Potentials(found) = strip.potentials(x, depth, 1.0);
            for (found, expected) in found.iter().zip(sums) {
                assert!((found - expected).norm() < 1e-12 * expected.norm().max(1.0), "{x} {depth} {found} {expected}");
            }
            // the integral of G_0 over the depth
            let step = 1e-4;
            let slope = (strip.integral(x, depth + step, 1.0) - strip.integral(x, depth - step, 1.0)) / (2.0 * step);
            assert!((slope + found[0]).norm() < 1e-7);
        }
    }

    #[test]
    fn on_the_face_the_potential_is_the_pressure() {
        for (s, inside) in [(0.0, true), (0.5, true), (0.99, true), (1.01, false), (30.0, false)] {
            for form in FORMS {
                let strip = strip(form);
                let x = s * strip.half_length;
                let Potentials([zeroth, ..]) = strip.potentials(x, 0.0, 1.0);
                let phi = s.min(1.0).acos();
                let sum = strip.series.iter().enumerate().map(|(m, c)| {
                    let sign = if m % 2 == 0 { 1.0 } else { -1.0 };
                    sign * c * ((2 * m + 1) as f64 * phi).sin()
                });
                let sum = sum.chain([strip.corners / phi.sin()]);
                let mean = 0.5 * strip.resultant() / strip.half_length;
                let expected = match form {
                    _ if !inside => 0.0,
                    Form::Uniform => mean,
                    Form::Parabolic => 1.5 * mean * (1.0 - s * s),
                    Form::Line | Form::Series => sum.sum(),
                };
                assert!((zeroth.re - expected).abs() < 1e-14, "{form:?} {s}: {} {expected}", zeroth.re);
            }
        }
    }

    #[test]
    fn series_and_closed_forms_are_one() {
        // where 64 terms are just enough
        for form in [Form::Uniform, Form::Parabolic] {
            let strip = strip(form);
            for (x, depth) in [(0.0, 0.25), (0.9, 0.01), (0.6, 0.3)] {
                let (z, _, w) = strip.map(x, depth);
                assert!(strip.terms(w * w).1);
                let closed = strip.closed(z).unwrap();
                let (Potentials(found), Potentials(expected)) = (strip.potentials(x, depth, 1.0), closed.potentials);
                for (found, expected) in
                    found.iter().zip(expected).chain([(&strip.integral(x, depth, 1.0), closed.integral)])
                {
                    assert!(
                        (found - expected).norm() < 1e-13 * (1.0 + expected.norm()),
                        "{form:?} {x} {found} {expected}"
                    );
                }
            }
            let edge = strip.potentials(strip.half_length, 0.0, 1.0);
            assert!(edge.0[0].re.is_finite() && strip.integral(strip.half_length, 0.0, 1.0).is_finite());
        }
    }

    #[test]
    fn a_tip_is_the_sum_of_its_series() {
        let tip = 0.6;
        let sharp = with_tip(Form::Series, tip);
        let mut series = strip(Form::Series);
        series.series.resize(4000, 0.0);
        series.series.iter_mut().enumerate().for_each(|(m, c)| *c += 2.0 * tip / (2 * m + 1) as f64);
        for wavenumber in [1e-3, 0.7, 30.0, 57.0, 58.0, 4e3] {
            let [found, expected] = [&sharp, &series].map(|strip| strip.minus_resultant(&[wavenumber])[0]);
            assert!((found - expected).abs() < 1e-13 * series.resultant(), "{wavenumber}: {found} {expected}");
        }
        for (x, depth) in [(0.0, 0.02), (0.3, 0.05), (0.69, 0.2), (0.1, 3.0), (40.0, 0.0), (0.0, 1e4), (1e-3, 0.01)] {
            let (Potentials(found), Potentials(expected)) =
                (sharp.potentials(x, depth, 1.0), series.potentials(x, depth, 1.0));
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).norm() < 1e-11 * expected.norm(), "{x} {depth}: {found} {expected}");
            }
            let (found, expected) = (sharp.integral(x, depth, 1.0), series.integral(x, depth, 1.0));
            assert!((found - expected).norm() < 1e-11 * expected.norm(), "{x} {depth}: {found} {expected}");
        }
        assert!((sharp.resultant() / series.resultant() - 1.0).abs() < 1e-15);
        let pressure = tip * (0.7f64 / 0.01).acosh();
        let plain = strip(Form::Series).potentials(0.01, 0.0, 1.0).0[0].re;
        assert!((sharp.potentials(0.01, 0.0, 1.0).0[0].re - plain - pressure).abs() < 1e-12);
        assert!(sharp.integral(0.0, 0.0, 1.0).is_finite());
    }
}
