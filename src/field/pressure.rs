//! A contact pressure as the bodies below and above it feel it: its transform, and potentials in closed form.
use std::f64::consts::{FRAC_PI_2, PI};

use num_complex::Complex64;

use crate::numeric::bessel;
use crate::solution::Contact;

/// Terms of the potentials below this part of the largest one are left out.
const NEGLIGIBLE: f64 = 1e-18;

/// Terms of the series that are together below this part of the largest one change nothing.
const ROUNDED: f64 = 1e-16;

/// p(x) = Σ c_j sin jφ, x = a cos φ, j = 2m + 1.
#[derive(Clone, Debug)]
pub(super) struct Pressure {
    pub(super) half_length: f64,
    /// (−1)^m c_j.
    series: Vec<f64>,
    /// How many terms are felt farther off than where they are smooth.
    felt: usize,
}

/// G_n = (1/π) ∫ p̂ λⁿ e^(−λd + iλx) dλ at one point, n = 0, 1, 2: real parts belong to cos λx, imaginary ones to sin λx.
#[derive(Clone, Copy, Debug)]
pub(super) struct Potentials(pub(super) [Complex64; 3]);

impl Pressure {
    pub(super) fn new(contact: &Contact) -> Self {
        let sign = |m: usize| if m.is_multiple_of(2) { 1.0 } else { -1.0 };
        let series = contact.coefficients.iter().enumerate().map(|(m, c)| sign(m) * c).collect();
        Self { half_length: contact.extent, series, felt: contact.found }.truncated(ROUNDED)
    }

    /// Without the last terms of the series, as long as together they stay below this part of the largest one. The
    /// resultant remains.
    pub(super) fn truncated(&self, part: f64) -> Self {
        let largest = self.series.iter().fold(0.0, |a: f64, c| a.max(c.abs()));
        let mut left_out = 0.0;
        let mut keep = self.series.len();
        while keep > 1 {
            left_out += self.series[keep - 1].abs();
            if left_out > part * largest {
                break;
            }
            keep -= 1;
        }
        Self { half_length: self.half_length, series: self.series[..keep].to_vec(), felt: self.felt.min(keep) }
    }

    /// The resultant P = p̂(0).
    pub(super) fn resultant(&self) -> f64 {
        FRAC_PI_2 * self.half_length * self.series.first().copied().unwrap_or(0.0)
    }

    /// p̂ and p̂ − P at some wavenumbers, eq. (22); the latter is O(λ²) and keeps its digits.
    pub(super) fn transforms(&self, wavenumbers: &[f64]) -> Vec<[f64; 2]> {
        let arguments: Vec<f64> = wavenumbers.iter().map(|wavenumber| wavenumber * self.half_length).collect();
        let n = arguments.len();
        let felt = &self.series[..self.felt.min(self.series.len())];
        let mut bessel = vec![0.0; 2 * felt.len() * n];
        bessel::table(2 * felt.len(), &arguments, &mut bessel);
        let resultant = self.resultant();
        let at = |i: usize| {
            let higher = felt.iter().enumerate().skip(1);
            let sum: f64 = higher.map(|(m, c)| (2 * m + 1) as f64 * c * bessel[(2 * m + 1) * n + i]).sum();
            let excess = resultant * bessel::jinc_deficit_from(arguments[i], bessel[n + i]) + PI * sum / wavenumbers[i];
            [resultant + excess, excess]
        };
        (0..n).map(at).collect()
    }

    /// w = √(z² + 1) − z with z = (d − ix)/a, and the root: ∫ J_j(λa) e^(−λaz) dλ/λ = wʲ/j.
    fn map(&self, x: f64, depth: f64) -> (Complex64, Complex64, Complex64) {
        let z = Complex64::new(depth, -x) / self.half_length;
        let root = (z * z + 1.0).sqrt();
        // the branch on which w is inside the unit circle
        let root = if root.re * z.re + root.im * z.im < 0.0 { -root } else { root };
        (z, root, (z + root).inv())
    }

    /// How many terms of the series matter where powers of w² fall as fast as this.
    fn terms(&self, square: Complex64) -> usize {
        let falls = square.norm().ln();
        let most = self.series.len();
        if falls < 0.0 { most.min((NEGLIGIBLE.ln() / falls) as usize + 1) } else { most }
    }

    /// The potentials at a depth, eq. (25). G_1 and G_2 are infinite at the ends of the contact.
    pub(super) fn potentials(&self, x: f64, depth: f64) -> Potentials {
        let (z, root, w) = self.map(x, depth);
        let square = w * w;
        let mut sums = [Complex64::ZERO; 3];
        for (m, c) in self.series[..self.terms(square)].iter().enumerate().rev() {
            let order = (2 * m + 1) as f64;
            sums[0] = sums[0] * square + c;
            sums[1] = sums[1] * square + order * c;
            sums[2] = sums[2] * square + order * order * c;
        }
        let [zeroth, first, second] = sums.map(|sum| sum * w);
        let over = root.inv();
        let a = self.half_length;
        Potentials([zeroth, first * over / a, (second + z * first * over) * over * over / (a * a)])
    }

    /// G_(−1), less a constant that is infinite: the integral of G_0 over the depth, eq. (26).
    pub(super) fn integral(&self, x: f64, depth: f64) -> Complex64 {
        let (_, _, w) = self.map(x, depth);
        let square = w * w;
        let mut sum = Complex64::ZERO;
        for m in (0..self.terms(square)).rev() {
            let next = self.series.get(m + 1).copied().unwrap_or(0.0);
            sum = sum * square + (self.series[m] + next) / (2 * m + 2) as f64;
        }
        let first = self.series.first().copied().unwrap_or(0.0);
        0.5 * self.half_length * (sum * square + first * w.ln())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pressure() -> Pressure {
        Pressure { half_length: 0.7, series: vec![1.3, 0.4, -0.1, 0.02], felt: 4 }
    }

    #[test]
    fn potentials_are_integrals_of_the_transform() {
        let pressure = pressure();
        let rule = crate::numeric::quadrature::rule(64);
        for (x, depth) in [(0.0, 0.5), (0.3, 0.9), (0.7, 0.4), (1.9, 0.6)] {
            let mut sums = [Complex64::ZERO; 3];
            for panel in 0..20 {
                let (wavenumbers, weights): (Vec<f64>, Vec<f64>) =
                    rule.on(5.0 * f64::from(panel), 5.0 * f64::from(panel + 1)).unzip();
                for ((l, weight), [p, _]) in wavenumbers.iter().zip(weights).zip(pressure.transforms(&wavenumbers)) {
                    let wave = Complex64::new(-l * depth, l * x).exp() * (weight * p / PI);
                    sums[0] += wave;
                    sums[1] += wave * l;
                    sums[2] += wave * l * l;
                }
            }
            let Potentials(found) = pressure.potentials(x, depth);
            for (found, expected) in found.iter().zip(sums) {
                assert!((found - expected).norm() < 1e-12 * expected.norm().max(1.0), "{x} {depth} {found} {expected}");
            }
            // the integral of G_0 over the depth
            let step = 1e-4;
            let slope = (pressure.integral(x, depth + step) - pressure.integral(x, depth - step)) / (2.0 * step);
            assert!((slope + found[0]).norm() < 1e-7);
        }
    }

    #[test]
    fn on_the_face_the_potential_is_the_pressure() {
        let pressure = pressure();
        for (s, inside) in [(0.0, true), (0.5, true), (0.99, true), (1.01, false), (30.0, false)] {
            let x = s * pressure.half_length;
            let Potentials([zeroth, ..]) = pressure.potentials(x, 0.0);
            let phi = s.min(1.0).acos();
            let sum = pressure.series.iter().enumerate().map(|(m, c)| {
                let sign = if m % 2 == 0 { 1.0 } else { -1.0 };
                sign * c * ((2 * m + 1) as f64 * phi).sin()
            });
            let expected = if inside { sum.sum() } else { 0.0 };
            assert!((zeroth.re - expected).abs() < 1e-14, "{s}: {} {expected}", zeroth.re);
        }
    }
}
