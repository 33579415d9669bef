//! The transform of the pressure on one strip.
use std::f64::consts::{FRAC_PI_2, PI};

use super::strip::StripPressure;
use crate::numeric::bessel;
use crate::solution::Form;

/// The envelope of the transform is sampled from λa = 1 on, at this number of wavenumbers, each this factor times the one before: up to
/// λa = 2^20, beyond the cut-off of any field.
const SAMPLES: i32 = 41;
const SAMPLED: f64 = std::f64::consts::SQRT_2;

/// Bessel functions whose order is above z + BEYOND z^(1/3) + BEYOND are below rounding, by Airy's function at 15.
const BEYOND: f64 = 12.0;

impl StripPressure {
    /// p̂ oscillates like cos λa: its amplitude is the length of two values a quarter of a wave apart.
    pub(super) fn sampled_envelope(&self) -> Vec<f64> {
        if self.half_length == 0.0 {
            return Vec::new();
        }
        let sample = |k: i32| {
            let wavenumbers = [0.0, FRAC_PI_2].map(|quarter| (SAMPLED.powi(k) + quarter) / self.half_length);
            let even = self.minus_resultant(&wavenumbers).into_iter().map(|variation| self.resultant() + variation);
            even.chain(self.sines(&wavenumbers).into_iter().map(|[value, _]| value)).fold(0.0, f64::hypot)
        };
        (0..SAMPLES).map(sample).collect()
    }

    /// An amplitude of p̂ at a wavenumber; the amplitude of a line load is the same at all wavenumbers.
    pub(super) fn envelope(&self, wavenumber: f64) -> f64 {
        let sample = (wavenumber * self.half_length).log2() * 2.0;
        let Some(last) = self.envelope.len().checked_sub(1).filter(|_| sample >= 0.0) else { return self.resultant() };
        self.envelope[(sample as usize).min(last)]
    }

    /// p̂ − P at some wavenumbers, eq. (22): O(λ²), accurate to rounding.
    pub(super) fn minus_resultant(&self, wavenumbers: &[f64]) -> Vec<f64> {
        if self.is_round {
            return self.disc_minus_resultant(wavenumbers);
        }
        let resultant = self.resultant();
        let arguments: Vec<f64> = wavenumbers.iter().map(|wavenumber| wavenumber * self.half_length).collect();
        let each = |minus_one: fn(f64) -> f64| arguments.iter().map(|z| resultant * minus_one(*z)).collect();
        match self.form {
            Form::Line => each(|_| 0.0),
            Form::Uniform => each(bessel::sinc_minus_one),
            Form::Parabolic => each(bessel::spherical_jinc_minus_one),
            Form::Series => {
                let orders = orders(&arguments, 2 * self.series.len() + 1, self.tip != 0.0);
                let n = arguments.len();
                let mut bessel = vec![0.0; orders * n];
                bessel::table(orders, &arguments, &mut bessel);
                (0..n)
                    .map(|i| self.series_minus_resultant(arguments[i], |order| bessel[order * n + i], orders))
                    .collect()
            }
        }
    }

    /// p̂ − P of a series at z = λa, from Bessel functions of some orders.
    fn series_minus_resultant(&self, z: f64, bessel: impl Fn(usize) -> f64, orders: usize) -> f64 {
        let odd = (3..orders).step_by(2);
        let sum: f64 = odd.clone().zip(self.series.iter().skip(1)).map(|(j, c)| j as f64 * c * bessel(j)).sum();
        // J_0 − 1 = (2 J_1/z − 1) − J_2
        let jinc_minus_one = bessel::jinc_minus_one_from(z, bessel(1));
        let corners = self.corners * (jinc_minus_one - bessel(2));
        // ∫ J_0 from 0 to z is 2 Σ J_j over all odd j
        let tip = match self.tip {
            0.0 => 0.0,
            tip if z < bessel::INTEGRAL_FROM => tip * (jinc_minus_one + 2.0 / z * odd.map(bessel).sum::<f64>()),
            tip => tip * (bessel::integral(z) / z - 1.0),
        };
        PI * self.half_length * (0.5 * self.first() * jinc_minus_one + sum / z + corners + tip)
    }

    /// The moment of the odd part of the pressure about its middle.
    pub(super) fn moment(&self) -> f64 {
        0.25 * PI * self.half_length.powi(2) * self.skew.first().copied().unwrap_or(0.0)
    }

    /// ∫ of the odd part of the pressure times sin λx dx, at some wavenumbers, and that less λ times the moment, accurate to rounding.
    pub(super) fn sines(&self, wavenumbers: &[f64]) -> Vec<[f64; 2]> {
        let n = wavenumbers.len();
        let arguments: Vec<f64> = wavenumbers.iter().map(|wavenumber| wavenumber * self.half_length).collect();
        let orders = orders(&arguments, 2 * self.skew.len() + 1, false);
        let mut bessel = vec![0.0; orders * n];
        bessel::table(orders, &arguments, &mut bessel);
        let term = |i: usize, m: usize| (2 * m + 2) as f64 * self.skew[m] * bessel[(2 * m + 2) * n + i];
        let count = self.skew.len().min((orders - 1) / 2);
        let of = |i: usize| {
            let sum = |from: usize| PI / wavenumbers[i] * (from..count).map(|m| term(i, m)).sum::<f64>();
            [sum(0), wavenumbers[i] * self.moment() * bessel::of_order_minus_one(4, arguments[i]) + sum(1)]
        };
        (0..n).map(of).collect()
    }
}

/// The number of orders, from 0 on, that are above rounding at these arguments, three at least; no more than the series has, unless
/// there is a tip, whose series does not end.
fn orders(arguments: &[f64], of_series: usize, endless: bool) -> usize {
    let largest = arguments.iter().fold(0.0, |largest: f64, z| largest.max(*z));
    let largest = if endless { largest.min(bessel::INTEGRAL_FROM.max(of_series as f64)) } else { largest };
    let enough = (largest + BEYOND * (largest.cbrt() + 1.0)) as usize + 1;
    if endless { enough } else { enough.min(of_series) }.max(3)
}
