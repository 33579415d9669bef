//! The transform of the pressure on one strip, and the potentials of which closed forms in x consist.
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::iter::zip;

use num_complex::Complex64;

use crate::numeric::{bessel, largest};
use crate::solution::{Form, Strip};

/// The envelope of the transform is sampled from λa = 1 on, at this number of wavenumbers, each this factor times the one before: up to
/// λa = 2^20, beyond the cut-off of any field.
const SAMPLES: i32 = 41;
const SAMPLED: f64 = std::f64::consts::SQRT_2;

/// Wavenumbers at which Bessel functions are tabulated at once: the table stays in the cache of the processor, and of long waves it has few orders. No number depends on it
/// but by rounding.
const AT_ONCE: usize = 64;

/// From this z (1 − |t|) on, the transform of a tip at t follows from an asymptotic series with this number of terms.
const LONG: f64 = 40.0;
const TERMS: u32 = 30;

/// G_n = (1/π) ∫ p̂ λⁿ e^(−λd + iλx) dλ at one point for n = −1, 0, 1, 2, eq. (25): real parts belong to cos λx, imaginary ones to sin λx.
/// G_(−1), the integral of G_0 over the depth, lacks a constant that is infinite, eq. (26).
pub(super) type Potentials = [Complex64; 4];

/// The transform of a pressure at a wavenumber, eq. (22), ∫ p e^(iλx) dx: the real part belongs to the part of the pressure that is even
/// about x = 0, which loads the bodies like cos λx, the imaginary one to the odd part, which loads them like sin λx.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Transform {
    /// p̂
    pub(crate) value: Complex64,
    /// The difference of p̂ and its limit for long waves, P + iλM with the moment M: accurate to rounding.
    pub(crate) variation: Complex64,
    /// The part of p̂ of which closed forms next to a loaded face are known: all of a sum of strips.
    pub(super) local: Complex64,
}

impl Transform {
    /// No numbers.
    pub(super) fn none() -> Self {
        let none = Complex64::new(f64::NAN, f64::NAN);
        Self { value: none, variation: none, local: none }
    }

    /// p̂, its variation and its local part in the even part, 0, or in the odd part, 1.
    pub(super) fn part(&self, part: usize) -> [f64; 3] {
        [self.value, self.variation, self.local].map(|value| [value.re, value.im][part])
    }

    /// The transform of the pressure moved by a length; P is the resultant.
    pub(super) fn moved(self, wavenumber: f64, length: f64, resultant: f64) -> Self {
        if length == 0.0 {
            return self;
        }
        let phase = wavenumber * length;
        let sin = (0.5 * phase).sin();
        let (wave, missing) = (Complex64::new((0.5 * phase).cos().powi(2) - sin * sin, phase.sin()), 2.0 * sin * sin);
        let Self { value, variation, .. } = self;
        let even = wave.re * variation.re - missing * resultant - wave.im * value.im;
        let of_place = resultant * phase * bessel::sinc_minus_one(phase) + wave.im * variation.re;
        let odd = of_place + wave.re * variation.im - missing * (value.im - variation.im);
        Self { value: wave * value, variation: Complex64::new(even, odd), local: wave * value }
    }
}

/// Amplitudes of p̂ at the wavenumbers λ_k = SAMPLED^k/a: p̂ oscillates like cos λa, and its amplitude is the length of two values a quarter
/// of a wave apart.
pub(super) fn envelope(strip: &Strip) -> Vec<f64> {
    if strip.extent == 0.0 {
        return Vec::new();
    }
    let sample = |k: i32| {
        let wavenumbers = [0.0, FRAC_PI_2].map(|quarter| (SAMPLED.powi(k) + quarter) / strip.extent);
        let transforms = strip.transforms(&wavenumbers);
        let parts = [|value: Complex64| value.re, |value: Complex64| value.im];
        parts.into_iter().flat_map(|part| transforms.iter().map(move |one| part(one.value))).fold(0.0, f64::hypot)
    };
    (0..SAMPLES).map(sample).collect()
}

impl Strip {
    /// The transform about the middle at some wavenumbers.
    pub(super) fn transforms(&self, wavenumbers: &[f64]) -> Vec<Transform> {
        if self.tip_at != 0.0 {
            return self.transforms_with_tip(wavenumbers);
        }
        wavenumbers.chunks(AT_ONCE).flat_map(|some| self.transforms_at_once(some)).collect()
    }

    /// The same at a few wavenumbers, of a pressure without a tip off the middle.
    fn transforms_at_once(&self, wavenumbers: &[f64]) -> impl Iterator<Item = Transform> {
        let arguments: Vec<f64> = wavenumbers.iter().map(|wavenumber| wavenumber * self.extent).collect();
        let even = self.even_variations(&arguments);
        let is_even = self.skew.is_empty() && self.corners[0] == self.corners[1];
        let odd = if is_even { vec![[0.0; 2]; even.len()] } else { self.sines(&arguments) };
        zip(even, odd).map(|(even, [odd, variation])| Transform {
            value: Complex64::new(self.long_waves() + even, odd),
            variation: Complex64::new(even, variation),
            ..Transform::default()
        })
    }

    /// The same with a tip off the middle: by the terms of its series up to the orders whose Bessel functions are above rounding, or by its asymptotic series.
    fn transforms_with_tip(&self, wavenumbers: &[f64]) -> Vec<Transform> {
        let last = LONG / (1.0 - self.tip_at.abs());
        let is_long = |wavenumber: &f64| wavenumber * self.extent > last;
        let [long, short]: [Vec<f64>; 2] =
            [true, false].map(|wanted| wavenumbers.iter().copied().filter(|l| is_long(l) == wanted).collect());
        let plain = Self { tip: 0.0, tip_at: 0.0, ..self.clone() };
        let mut of_long = plain.transforms(&long).into_iter();
        let largest = short.iter().fold(0.0, |largest: f64, l| largest.max(l * self.extent));
        let mut of_short = self.without_tip(bessel::orders_up_to(largest)).transforms(&short).into_iter();
        let (resultant, moment) = (self.resultant() - plain.resultant(), self.moment() - plain.moment());
        let of = |wavenumber: &f64| {
            if !is_long(wavenumber) {
                return of_short.next().unwrap_or_default();
            }
            let Transform { value, variation, .. } = of_long.next().unwrap_or_default();
            let tip = self.tip * self.extent * transform_of_tip(self.tip_at, wavenumber * self.extent);
            let long_waves = Complex64::new(resultant, wavenumber * moment);
            Transform { value: value + tip, variation: variation + (tip - long_waves), ..Transform::default() }
        };
        wavenumbers.iter().map(of).collect()
    }

    /// With the first terms of its series in place of what a tip makes.
    fn without_tip(&self, orders: usize) -> Self {
        let with = |own: &[f64], first: usize| -> Vec<f64> {
            let count = own.len().max(orders / 2);
            let of = |m: usize| own.get(m).unwrap_or(&0.0) + self.tip_coefficient(2 * m + first);
            (0..count).map(of).collect()
        };
        let (coefficients, skew) = (with(&self.coefficients, 1), with(&self.skew, 2));
        Self { coefficients, skew, tip: 0.0, tip_at: 0.0, ..self.clone() }
    }

    /// p̂ − P of the even part at some λa: O(λ²).
    fn even_variations(&self, arguments: &[f64]) -> Vec<f64> {
        let of_power = |power: i32| {
            let order = power + 1 + i32::from(self.is_round);
            arguments.iter().map(|z| self.long_waves() * bessel::of_order_minus_one(order, *z)).collect()
        };
        match self.form {
            Form::Line => vec![0.0; arguments.len()],
            // like (1 − s²)^(n/2)
            Form::Uniform => of_power(0),
            Form::Parabolic => of_power(2),
            Form::Series if self.is_round => self.disc_series(arguments),
            Form::Series => {
                let (orders, bessel) = table(arguments, 2 * self.coefficients.len() + 1, self.tip != 0.0);
                let odd = || (3..orders).step_by(2);
                let terms = zip(odd(), alternating(&self.coefficients).skip(1)).map(|(j, c)| (j, j as f64 * c));
                let sums = combined(&bessel, arguments.len(), terms);
                // ∫ J_0 from 0 to z is 2 Σ J_j over all odd j
                let of_tip = odd().filter(|_| self.tip != 0.0).map(|j| (j, 2.0));
                let of_tip = combined(&bessel, arguments.len(), of_tip);
                let [first, second] = [1, 2].map(|order| &bessel[order * arguments.len()..]);
                let all = zip(zip(arguments, zip(first, second)), zip(sums, of_tip));
                all.map(|((z, (j1, j2)), sums)| self.series_variation(*z, [*j1, *j2], sums)).collect()
            }
        }
    }

    /// p̂ − P of a series at z = λa, from J_1 and J_2, Σ j c_j J_j over the terms after the first one, and what a tip makes with J_3 and higher orders.
    fn series_variation(&self, z: f64, [j1, j2]: [f64; 2], (sum, of_tip): (f64, f64)) -> f64 {
        // J_0 − 1 = (2 J_1/z − 1) − J_2
        let jinc_minus_one = bessel::jinc_minus_one_from(z, j1);
        let corners = self.even_and_odd_corners()[0] * (jinc_minus_one - j2);
        let tip = match self.tip {
            0.0 => 0.0,
            tip if z < bessel::INTEGRAL_FROM => tip * (jinc_minus_one + of_tip / z),
            tip => tip * (bessel::integral(z) / z - 1.0),
        };
        PI * self.extent * (0.5 * self.first() * jinc_minus_one + sum / z + corners + tip)
    }

    /// ∫ of the odd part of the pressure times sin λx dx at some λa, and its difference from λ times the moment: O(λ³). The difference of values
    /// would lose digits for short waves, their sum for long ones.
    fn sines(&self, arguments: &[f64]) -> Vec<[f64; 2]> {
        let [_, corners] = self.even_and_odd_corners();
        let (orders, bessel) = table(arguments, 2 * self.skew.len() + 1, false);
        let count = arguments.len();
        let terms = zip((2..orders).step_by(2), alternating(&self.skew)).map(|(j, c)| (j, j as f64 * c));
        let sums = combined(&bessel, count, terms.skip(1));
        let (first, linear) = (self.skew.first().unwrap_or(&0.0), PI * self.extent * corners);
        let of = |((z, sum), (j1, j2)): ((&f64, f64), (&f64, &f64))| {
            let sum = PI * self.extent / z * sum;
            let variation = 0.25 * PI * self.extent * z * first * bessel::of_order_minus_one(4, *z);
            let of_corners = linear * 0.5 * z * bessel::jinc_minus_one_from(*z, *j1);
            let value = PI * self.extent / z * 2.0 * first * j2;
            [value + sum + linear * j1, variation + sum + of_corners]
        };
        zip(zip(arguments, sums), zip(&bessel[count..], &bessel[2 * count..])).map(of).collect()
    }
}

/// Σ factor · J_order at each of some arguments, from a table of all orders.
pub(super) fn combined(table: &[f64], arguments: usize, factors: impl Iterator<Item = (usize, f64)>) -> Vec<f64> {
    let mut sums = vec![0.0; arguments];
    for (order, factor) in factors {
        sums.iter_mut().zip(&table[order * arguments..]).for_each(|(sum, value)| *sum += factor * value);
    }
    sums
}

/// The terms (−1)^m c_m of a series.
fn alternating(series: &[f64]) -> impl Iterator<Item = f64> + Clone {
    series.iter().zip([1.0, -1.0].into_iter().cycle()).map(|(c, sign)| sign * c)
}

/// ∫ arcosh((1 − st)/|s − t|) e^(izs) ds over |s| < 1 for large z (1 − |t|): (π/z) √(1 − t²) e^(itz) ∫ e^(−itτ) J_0(τ) dτ from 0 to z, where the integral is
/// 1/√(1 − t²) less the one from z on, an asymptotic series.
fn transform_of_tip(t: f64, z: f64) -> Complex64 {
    // ∫ e^(iqτ) √(2/πτ) e^(−iπ/4) Σ c_k τ^(−k) dτ from z on, where H_0 is e^(iτ) times the sum with q = 0
    let beyond = |q: f64| {
        let (mut c, mut d, mut sum, mut power) = (Complex64::ONE, Complex64::ZERO, Complex64::ZERO, 1.0);
        for k in 0..TERMS {
            let order = f64::from(k);
            d = (c + (order - 0.5) * d) / Complex64::new(0.0, q);
            sum += d * power;
            power /= z;
            let odd = 2.0 * order + 1.0;
            c *= Complex64::new(0.0, -odd * odd / (8.0 * (order + 1.0)));
        }
        -Complex64::cis(q * z - FRAC_PI_4) * (2.0 / (PI * z)).sqrt() * sum
    };
    let sine = (1.0 - t * t).sqrt();
    let rest = 0.5 * (beyond(1.0 - t) + beyond(1.0 + t).conj());
    PI / z * sine * Complex64::cis(t * z) * (sine.recip() - rest)
}

/// The number of orders, from 0 on, of Bessel functions that are above rounding at these arguments, three at least, and their values; no more
/// orders than the series has, unless there is a tip, whose series does not end.
fn table(arguments: &[f64], of_series: usize, endless: bool) -> (usize, Vec<f64>) {
    let largest = largest(arguments.iter().copied());
    let largest = if endless { largest.min(bessel::INTEGRAL_FROM.max(of_series as f64)) } else { largest };
    let enough = bessel::orders_up_to(largest);
    let orders = if endless { enough } else { enough.min(of_series) }.max(3);
    let mut bessel = vec![0.0; orders * arguments.len()];
    bessel::table(orders, arguments, &mut bessel);
    (orders, bessel)
}
