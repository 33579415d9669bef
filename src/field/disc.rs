//! The pressure on a disc about the axis: its transform ∫ p J₀(λr) r dr, and potentials by quadrature.
//!
//! p(ρ) = ∫ h(s)/√(s² − ρ²) ds from ρ = r/a to 1 makes every pressure a sum of sources at the complex depths d − ias: with
//! ∫ J₀(λr) e^(−λw) dλ = 1/√(w² + r²) the potentials are integrals of h over s, whose integrands are singular at s = r/a ± id/a only.
//! arcosh(1/ρ) has h = 1, a uniform pressure 2s/(π√(1 − s²)), and 1/√(1 − ρ²) is all at s = 1. A series is a sum of products, see
//! [`super::spheroid`].
use std::f64::consts::{FRAC_PI_2, PI};
use std::iter::zip;

use num_complex::Complex64;

use super::spheroid::{self, Spheroidal};
use super::strip::TabulatedStrip;
use super::transform::{Potentials, combined};
use crate::numeric::bessel::{self, Kind, Wanted};
use crate::numeric::largest;
use crate::numeric::quadrature::rule;
use crate::solution::{Form, Strip, jacobi_weights};

/// Gauss points in v, and per unit of it.
const POINTS: usize = 12;
const PER_LENGTH: f64 = 7.0;

impl Strip {
    /// p̂ − p̂(0) of a series at some λa, accurate to rounding.
    pub(super) fn disc_series(&self, arguments: &[f64]) -> Vec<f64> {
        let count = arguments.len();
        let orders = bessel::orders_up_to(largest(arguments.iter().copied())).min(2 * self.coefficients.len() + 1);
        let wanted = Wanted::ZERO_AND_ODD.of_kind(Kind::Spherical);
        let columns = wanted.below(orders);
        let mut table = vec![0.0; columns * count];
        if self.coefficients.len() > 1 {
            bessel::scaled_orders(orders, wanted, arguments, 1.0, count, &mut table);
        }
        let (square, weighted) = (self.extent * self.extent, self.weighted());
        let of_orders = weighted.iter().enumerate().take(columns - 1).skip(1).map(|(m, c)| (m + 1, *c));
        let sums = combined(&table, count, of_orders);
        let of = |(z, sum): (&f64, f64)| {
            let first = self.first() / 3.0 * bessel::spherical_jinc_minus_one(*z);
            // (1 − cos z)/z² − ½ = ½ (sinc²(z/2) − 1)
            let half = bessel::sinc_minus_one(0.5 * z);
            let edge = self.even_and_odd_corners()[0] * bessel::sinc_minus_one(*z);
            let tip = 0.5 * self.tip * half * (half + 2.0);
            square * (first + if *z > 0.0 { sum / z } else { 0.0 } + edge + tip)
        };
        arguments.iter().zip(sums).map(of).collect()
    }

    /// The coefficients of j_(2m+1)(λa)/λ in p̂/a.
    pub(super) fn weighted(&self) -> Vec<f64> {
        self.coefficients.iter().zip(jacobi_weights()).map(|(c, weight)| c / weight).collect()
    }

    /// h(s) ds/dθ with s = sin θ, without the part of a series.
    fn source(&self, theta: f64) -> f64 {
        let (sin, cos) = theta.sin_cos();
        let mean = self.long_waves() / (self.extent * self.extent);
        match self.form {
            // p = 2 p̂(0)/a² and 4 p̂(0)/a² (1 − ρ²)
            Form::Uniform => 4.0 / PI * mean * sin,
            Form::Parabolic => 16.0 / PI * mean * sin * cos * cos,
            Form::Series | Form::Line => self.tip * cos,
        }
    }
}

impl TabulatedStrip {
    /// The potentials at a distance r from the axis and a depth; potentials of J₁ are odd in r, and n > 0 is not asked for on the face.
    pub(super) fn disc_potentials(&self, r: f64, depth: f64) -> Potentials {
        let Strip { extent: a, tip, form, .. } = self.strip;
        if form == Form::Line {
            return point(self.strip.long_waves(), r, depth);
        }
        let mut sums = Potentials::default();
        let mut add = |factor: f64, potentials: Potentials| {
            zip(&mut sums, potentials).for_each(|(sum, potential)| *sum += factor * potential);
        };
        if form != Form::Series || tip != 0.0 {
            for (theta, weight) in places(&Spheroidal::new(r.abs() / a, depth / a)) {
                add(a * weight * self.strip.source(theta), sources(a * theta.sin(), r, depth));
            }
        }
        let [edge, _] = self.strip.even_and_odd_corners();
        if edge != 0.0 {
            add(a * edge, sources(a, r, depth));
        }
        if form == Form::Series {
            add(1.0, spheroid::potentials(&self.by_order, a, r, depth));
        }
        if depth == 0.0 {
            sums[1].re = self.strip.pressure(r);
        }
        sums
    }
}

/// Places 0 < θ < π/2 and weights; the sources at s = sin θ have singular points θ = ±α − iβ. θ = α ± u² takes the root out, and u = √β sinh v
/// moves the singular points to v = arsinh e^(±iπ/4), however close to the disc the place is.
fn places(Spheroidal { xi, eta, beyond, .. }: &Spheroidal) -> Vec<(f64, f64)> {
    let alpha = f64::atan2(beyond.sqrt(), *eta);
    // on the disc the root is taken out, and the nearest singular point is the other one
    let near = if *xi > 0.0 { xi.asinh() } else { alpha }.sqrt();
    let mut places = Vec::new();
    let sides = [(-1.0, alpha.sqrt()), (1.0, (FRAC_PI_2 - alpha).max(0.0).sqrt())];
    for (sign, whole) in sides.into_iter().filter(|(_, whole)| *whole > 0.0) {
        let longest = if near > 0.0 { (whole / near).asinh() } else { 1.0 };
        let place = |(v, weight): (f64, f64)| {
            let (u, slope) = if near > 0.0 { (near * v.sinh(), near * v.cosh()) } else { (whole * v, whole) };
            (alpha + sign * u * u, 2.0 * weight * u * slope)
        };
        places.extend(rule(POINTS + (PER_LENGTH * longest) as usize).on(0.0, longest).map(place));
    }
    places
}

/// Im ∫ λ^n e^(−λ(d − is)) J(λr) dλ for n = −1, 0, 1, 2: of J₀ as real parts, of J₁ as imaginary ones.
fn sources(s: f64, r: f64, depth: f64) -> Potentials {
    let w = Complex64::new(depth, -s);
    // (d − is)² + r² without cancellation; the root of positive real part
    let square = Complex64::new(depth * depth + (r - s) * (r + s), -2.0 * depth * s);
    let root = root_of(square);
    let over = root.inv();
    let (third, sum) = (over * over * over, (root + w).inv());
    let fifth = third * over * over;
    let pairs = [
        (Complex64::new(0.0, sum.arg()), r * sum),
        (over, r * over * sum),
        (w * third, r * third),
        ((2.0 * w * w - r * r) * fifth, 3.0 * r * w * fifth),
    ];
    pairs.map(|(zeroth, first)| Complex64::new(zeroth.im, first.im))
}

/// The square root with a positive real part; next to the negative axis its imaginary part has the sign of the imaginary part of the square.
fn root_of(square: Complex64) -> Complex64 {
    let larger = (0.5 * (square.norm() + square.re.abs())).sqrt();
    let smaller = if larger > 0.0 { 0.5 * square.im / larger } else { 0.0 };
    if square.re > 0.0 {
        Complex64::new(larger, smaller)
    } else {
        Complex64::new(smaller.abs(), larger.copysign(square.im))
    }
}

/// The potentials of a force P on the axis, p̂ = P/2π everywhere.
fn point(transform: f64, r: f64, depth: f64) -> Potentials {
    let distance = r.hypot(depth);
    let over = distance.recip();
    let (cos, sin) = (depth * over, r * over);
    let (square, third) = (over * over, over * over * over);
    let zeroth = Complex64::new(cos, sin);
    let first = Complex64::new(2.0 * cos * cos - sin * sin, 3.0 * cos * sin);
    let second = Complex64::new(6.0 * cos.powi(3) - 9.0 * cos * sin * sin, 3.0 * sin * (4.0 * cos * cos - sin * sin));
    let integral = Complex64::new(over, r / (distance * (distance + depth)));
    [integral, zeroth * square, first * third, second * (third * over)].map(|potential| potential * transform)
}
