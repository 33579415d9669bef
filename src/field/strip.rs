//! The pressure on one strip, about its middle: potentials in closed form.
use std::f64::consts::{LN_2, PI};
use std::iter::zip;
use std::sync::OnceLock;

use num_complex::Complex64;

use super::spheroid;
use super::transform::{Potentials, envelope};
use crate::solution::{Form, Strip, tip_coefficient};

/// Terms of the potentials below this part of the largest one are left out.
const NEGLIGIBLE: f64 = 1e-18;

/// Squares of w below this are terms of a series.
const SMALL: f64 = 1e-6;

/// Terms of the series whose sum is below this part of the largest one are left out.
const ROUNDED: f64 = 1e-16;

/// The pressure on a strip without negligible terms, and tables of what its fields take.
#[derive(Clone, Debug)]
pub(super) struct TabulatedStrip {
    pub(super) strip: Strip,
    /// The series of a disc as its potentials take it, see [`super::spheroid`].
    pub(super) by_order: Vec<f64>,
    /// Amplitudes of p̂ once they are wanted, see [`envelope`].
    envelope: OnceLock<Vec<f64>>,
}

impl TabulatedStrip {
    pub(super) fn new(strip: &Strip) -> Self {
        let mut strip = strip.clone();
        let (series, skew) = (&mut strip.coefficients, &mut strip.skew);
        if strip.form == Form::Series {
            // a series of odd terms alone is filled up by even terms that are zero
            series.resize(series.len().max(skew.len()), 0.0);
            // the resultant remains
            let largest = series.iter().chain(&*skew).chain(&strip.corners).fold(0.0, |a: f64, c| a.max(c.abs()));
            let term = |m: usize| series[m].abs() + skew.get(m).map_or(0.0, |c| c.abs());
            let mut left_out = 0.0;
            let is_negligible = |m: &usize| {
                left_out += term(*m);
                left_out <= ROUNDED * largest
            };
            let keep = series.len() - (1..series.len()).rev().take_while(is_negligible).count();
            series.truncate(keep);
            skew.truncate(keep);
        }
        let is_series_of_disc = strip.is_round && strip.form == Form::Series;
        let by_order = if is_series_of_disc { spheroid::by_order(&strip.weighted()) } else { Vec::new() };
        Self { envelope: OnceLock::new(), by_order, strip }
    }

    /// An amplitude of p̂ at a wavenumber; the amplitude of a line load is the same at all wavenumbers.
    pub(super) fn envelope(&self, wavenumber: f64) -> f64 {
        let sample = (wavenumber * self.strip.extent).log2() * 2.0;
        let amplitudes = self.envelope.get_or_init(|| envelope(&self.strip));
        let last = amplitudes.len().checked_sub(1).filter(|_| sample >= 0.0);
        last.map_or(self.strip.long_waves(), |last| amplitudes[(sample as usize).min(last)])
    }

    /// The potentials at a place measured from the middle, and a depth; G_(−1) is 0 if it takes time and is not wanted. G_1 and G_2 are
    /// infinite at the ends of the strip, and all of them at its [`Strip::singular_points`].
    pub(super) fn potentials(&self, x: f64, depth: f64, integral: bool) -> Potentials {
        if self.strip.is_round {
            self.disc_potentials(x, depth)
        } else {
            self.strip.plane_potentials(x, depth, integral)
        }
    }
}

impl Strip {
    /// w = √(z² + 1) − z with z = (d − ix)/a, and the root: ∫ J_j(λa) e^(−λaz) dλ/λ = wʲ/j.
    fn map(&self, x: f64, depth: f64) -> (Complex64, Complex64, Complex64) {
        let z = Complex64::new(depth, -x) / self.extent;
        let root = (z * z + 1.0).sqrt();
        // the branch on which w is inside the unit circle
        let root = if root.re * z.re + root.im * z.im < 0.0 { -root } else { root };
        (z, root, (z + root).inv())
    }

    /// The number of terms of the series that are not negligible for powers of w² = `square`, and whether the series has that many.
    fn terms(&self, square: Complex64) -> (usize, bool) {
        let falls = square.norm().ln();
        let most = self.coefficients.len();
        let enough = if falls < 0.0 { (NEGLIGIBLE.ln() / falls) as usize + 1 } else { usize::MAX };
        (most.min(enough), enough <= most)
    }

    fn plane_potentials(&self, x: f64, depth: f64, integral: bool) -> Potentials {
        let Self { extent: a, tip, .. } = *self;
        if self.form == Form::Line {
            // the transform is P: powers of 1/(d − ix)
            let place = Complex64::new(depth, -x);
            let (share, over) = (self.long_waves() / PI, place.inv());
            let zeroth = share * over;
            return [-share * logarithm(place), zeroth, zeroth * over, 2.0 * zeroth * over * over];
        }
        let (z, root, w) = self.map(x, depth);
        // the terms have the factors (−1)^m w^2m
        let square = -(w * w);
        let (terms, enough) = self.terms(square);
        if let (false, Some(closed)) = (enough, self.closed(z)) {
            return closed;
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
        let mut all = sums(&self.coefficients[..terms], 1).map(|sum| sum * w);
        if !self.skew.is_empty() {
            let odd = sums(&self.skew[..terms.min(self.skew.len())], 2);
            zip(&mut all, odd).for_each(|(sum, odd)| *sum += Complex64::I * square * odd);
        }
        let [zeroth, first, second] = all;
        let over = root.inv();
        let mut potentials =
            [Complex64::ZERO, zeroth, first * over / a, (second + z * first * over) * over * over / (a * a)];
        if self.corners != [0.0; 2] {
            // 1/root and w/root, and their derivatives
            let [even, odd] = self.even_and_odd_corners();
            let (third, odd) = (over * over * over, -Complex64::I * odd);
            potentials[1] += even * over + odd * w * over;
            potentials[2] += (even * z + odd) * third / a;
            potentials[3] += (even * (2.0 * z * z - 1.0) + odd * 3.0 * z) * third * over * over / (a * a);
        }
        if tip != 0.0 {
            // T of the tip, and its derivatives with respect to −z
            let (from_tip, sine) = self.beside_tip(z);
            potentials[1] += tip * self.logarithm_of_tip(z, w);
            potentials[2] += tip * sine * over / from_tip / a;
            let both = z * from_tip + root * root;
            potentials[3] += tip * sine * both * over * over * over / (from_tip * from_tip) / (a * a);
        }
        if integral {
            potentials[0] = self.integral(z, w, terms);
        }
        potentials
    }

    /// G_(−1) from some terms of the series.
    fn integral(&self, z: Complex64, w: Complex64, terms: usize) -> Complex64 {
        let square = -(w * w);
        let mut sum = Complex64::ZERO;
        for m in (0..terms).rev() {
            let next = self.coefficients.get(m + 1).copied().unwrap_or(0.0);
            sum = sum * square + (self.coefficients[m] - next) / (2 * m + 2) as f64;
        }
        let [even, slant] = self.even_and_odd_corners();
        let mut sum = sum * (w * w) + (self.first() + 2.0 * even) * w.ln();
        let mut odd = Complex64::ZERO;
        for m in (0..=terms.min(self.skew.len())).rev() {
            let c = |m: Option<usize>| m.and_then(|m| self.skew.get(m)).copied().unwrap_or(0.0);
            odd = odd * square + (c(Some(m)) - c(m.checked_sub(1))) / (2 * m + 1) as f64;
        }
        sum -= Complex64::I * w * (odd + 2.0 * slant);
        let plain = 0.5 * self.extent * sum;
        if self.tip == 0.0 {
            return plain;
        }
        let (from_tip, sine) = self.beside_tip(z);
        // at the tip itself the product vanishes
        let product = if from_tip == Complex64::ZERO { from_tip } else { from_tip * self.logarithm_of_tip(z, w) };
        plain + self.tip * self.extent * (sine * (1.0 + w.ln()) - product)
    }

    /// z from where the tip is, t, z + it, and sin θ with t = cos θ.
    fn beside_tip(&self, z: Complex64) -> (Complex64, f64) {
        let t = self.tip_at;
        (z + Complex64::new(0.0, t), (1.0 - t * t).sqrt())
    }

    /// T = Σ 2 sin kθ (−iw)ᵏ/(ik) = ln[(1 − ve^(−iθ))/(1 − ve^(iθ))] of a tip at cos θ, v = −iw: 2 artanh w about the middle.
    fn logarithm_of_tip(&self, z: Complex64, w: Complex64) -> Complex64 {
        let v = Complex64::new(w.im, -w.re);
        let (from_tip, sine) = self.beside_tip(z);
        let conjugate = Complex64::new(self.tip_at, -sine);
        if w.norm_sqr() < SMALL {
            let terms = (1..8).rev().fold(Complex64::ZERO, |sum, k| v * (sum + tip_coefficient(self.tip_at, k)));
            return Complex64::I * terms;
        }
        // (1 − ve^(iθ)) (1 − ve^(−iθ)) = 2iv (z + it) keeps its digits next to the tip
        let numerator = 1.0 - v * conjugate;
        (numerator * numerator / (2.0 * Complex64::I * v * from_tip)).ln()
    }

    /// Remainder of the series close to the ends of strips where the pressure ends abruptly, or with a kink: below
    /// eq. (26).
    fn closed(&self, z: Complex64) -> Option<Potentials> {
        let (upper, lower) = (logarithm(z + Complex64::I), logarithm(z - Complex64::I));
        // arccot z, ln (z² + 1)
        let (angle, both) = (-0.5 * Complex64::I * (upper - lower), upper + lower);
        let (a, resultant) = (self.extent, self.long_waves());
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
        let [zeroth, first, second] = potentials.map(|potential| factor * potential);
        Some([factor * a * integral, zeroth, first, second])
    }
}

/// ln z, finite at 0.
fn logarithm(z: Complex64) -> Complex64 {
    if z == Complex64::ZERO { Complex64::new(f64::MIN_POSITIVE.ln(), 0.0) } else { z.ln() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::bessel;
    use crate::numeric::quadrature::rule;

    fn strip(form: Form) -> TabulatedStrip {
        let order = |m: usize| (2 * m + 1) as f64;
        let coefficients = match form {
            Form::Line => vec![1.3],
            Form::Series => vec![1.3, -0.4, -0.1, -0.02],
            Form::Uniform => (0..64).map(|m| 1.3 / order(m)).collect(),
            Form::Parabolic => (0..64).map(|m| -3.9 / (order(m) * (order(m).powi(2) - 4.0))).collect(),
        };
        let corners = if form == Form::Series { [0.5, 1.1] } else { [0.0; 2] };
        TabulatedStrip::new(&Strip { corners, form, ..Strip::series(0.7, coefficients) })
    }

    /// G_n for n = −1, 0, 1, 2 by the transform; in the plane G_(−1) is infinite.
    fn by_transform(strip: &Strip, x: f64, depth: f64) -> Potentials {
        let mut sums = Potentials::default();
        let (panels, last) = (400, 40.0 / depth);
        for panel in 0..panels {
            let [from, to] = [panel, panel + 1].map(|k| last * f64::from(k) / f64::from(panels));
            let (wavenumbers, weights): (Vec<f64>, Vec<f64>) = rule(16).on(from, to).unzip();
            for ((l, weight), transform) in zip(zip(&wavenumbers, weights), strip.transforms(&wavenumbers)) {
                let mut bessel = [0.0; 2];
                bessel::table(2, &[l * x], &mut bessel);
                let plane = Complex64::cis(l * x) / PI;
                let wave = if strip.is_round { l * Complex64::new(bessel[0], bessel[1]) } else { plane };
                let size = transform.value.conj() * (-l * depth).exp() * weight;
                zip(&mut sums, -1..).for_each(|(sum, power)| *sum += size * l.powi(power) * wave);
            }
        }
        sums
    }

    #[test]
    fn potentials_are_integrals_of_the_transform() {
        let round = |strip: Strip| TabulatedStrip::new(&Strip { is_round: true, ..strip });
        let series = Strip::series(0.8, vec![1.0, -0.3, 0.2]);
        let discs = [
            round(series.clone()),
            round(Strip::series(0.8, (0..80).map(|m| 1.0 / f64::from(m * m + 1)).collect())),
            round(Strip { tip: 0.4, corners: [0.3; 2], ..series.clone() }),
            round(Strip { form: Form::Uniform, ..Strip::series(0.8, vec![1.0]) }),
            round(Strip { form: Form::Parabolic, ..Strip::series(0.8, vec![1.0]) }),
            round(Strip { form: Form::Line, ..Strip::series(0.0, vec![1.0]) }),
        ];
        let places = [(0.0, 0.5), (0.3, 0.4), (0.79, 0.3), (1.7, 0.6)];
        let strips = [Form::Series, Form::Uniform, Form::Parabolic, Form::Line].map(strip).into_iter().chain(discs);
        for (strip, (x, depth)) in strips.flat_map(|strip| places.map(|place| (strip.clone(), place))) {
            let found = strip.potentials(x, depth, true);
            let finite = usize::from(!strip.strip.is_round);
            for (found, expected) in zip(found, by_transform(&strip.strip, x, depth)).skip(finite) {
                let allowed =
                    if strip.strip.is_round { 1e-10 * expected.norm() } else { 1e-12 * expected.norm().max(1.0) };
                assert!((found - expected).norm() < allowed, "{strip:?} {x} {depth}: {found} {expected}");
            }
            // the integral of G_0 over the depth
            let step = 1e-4;
            let [above, below] = [-step, step].map(|step| strip.potentials(x, depth + step, true)[0]);
            assert!(((below - above) / (2.0 * step) + found[1]).norm() < 1e-6 * found[3].norm().max(0.1));
        }
    }

    #[test]
    fn series_and_closed_forms_are_one() {
        // where 64 terms are just enough
        for form in [Form::Uniform, Form::Parabolic] {
            let strip = strip(form);
            for (x, depth) in [(0.0, 0.25), (0.9, 0.01), (0.6, 0.3)] {
                let (z, _, w) = strip.strip.map(x, depth);
                assert!(strip.strip.terms(w * w).1);
                for (found, expected) in zip(strip.potentials(x, depth, true), strip.strip.closed(z).unwrap()) {
                    assert!(
                        (found - expected).norm() < 1e-13 * (1.0 + expected.norm()),
                        "{form:?} {x} {found} {expected}"
                    );
                }
            }
            let edge = strip.potentials(strip.strip.extent, 0.0, true);
            assert!(edge[1].re.is_finite() && edge[0].is_finite());
        }
    }

    #[test]
    fn a_tip_is_the_sum_of_its_series() {
        let tip = 0.6;
        for tip_at in [0.0f64, 0.3, -0.8] {
            let (mut sharp, mut series) = (strip(Form::Series), strip(Form::Series).strip);
            (sharp.strip.tip, sharp.strip.tip_at) = (tip, tip_at);
            series.coefficients.resize(4000, 0.0);
            series.skew.resize(4000, 0.0);
            let term = |k: usize| 2.0 * tip / k as f64 * (k as f64 * tip_at.acos()).sin();
            series.coefficients.iter_mut().enumerate().for_each(|(m, c)| *c += term(2 * m + 1));
            series.skew.iter_mut().enumerate().for_each(|(m, c)| *c += term(2 * m + 2));
            for wavenumber in [1e-3, 0.7, 30.0, 57.0, 58.0, 4e3] {
                let [found, expected] =
                    [&sharp.strip, &series].map(|strip| strip.transforms(&[wavenumber])[0].variation);
                let off = (found - expected).norm();
                assert!(off < 1e-13 * series.resultant(), "{tip_at} {wavenumber}: {found} {expected}");
            }
            let places = [(0.0, 0.02), (0.3, 0.05), (0.69, 0.2), (0.1, 3.0), (40.0, 0.0), (0.0, 1e4), (1e-3, 0.01)];
            for (x, depth) in places {
                let (found, expected) = (sharp.potentials(x, depth, true), series.plane_potentials(x, depth, true));
                for (found, expected) in zip(found, expected) {
                    let off = (found - expected).norm() / expected.norm();
                    assert!(off < 1e-11, "{tip_at} {x} {depth}: {found} {expected}");
                }
            }
            assert!((sharp.strip.resultant() / series.resultant() - 1.0).abs() < 1e-15);
            assert!((sharp.strip.moment() - series.moment()).abs() < 1e-15);
            let s = 0.01 / 0.7;
            let pressure = tip * ((1.0 - s * tip_at) / (s - tip_at).abs()).acosh();
            let plain = strip(Form::Series).potentials(0.01, 0.0, false)[1].re;
            assert!((sharp.potentials(0.01, 0.0, false)[1].re - plain - pressure).abs() < 1e-12);
            assert!((sharp.strip.pressure(0.01) - strip(Form::Series).strip.pressure(0.01) - pressure).abs() < 1e-12);
            assert!(sharp.potentials(0.7 * tip_at, 0.0, true)[0].is_finite());
        }
    }
}
