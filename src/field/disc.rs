//! The pressure on a disc about the axis: its transform ∫ p J₀(λr) r dr, and potentials by quadrature.
//!
//! p(ρ) = ∫ h(s)/√(s² − ρ²) ds from ρ = r/a to 1 makes every pressure a sum of sources at the complex depths d − ias: with
//! ∫ J₀(λr) e^(−λw) dλ = 1/√(w² + r²) the potentials are integrals of h over s, whose integrands are singular at s = r/a ± id/a only.
//! arcosh(1/ρ) has h = 1, a uniform pressure 2s/(π√(1 − s²)), and 1/√(1 − ρ²) is all at s = 1. A series is a sum of products, see
//! [`super::spheroid`].
use std::f64::consts::{FRAC_PI_2, PI};

use num_complex::Complex64;

use super::potentials::{Closed, Potentials};
use super::sources::{point, sources};
use super::spheroid::{self, Spheroidal};
use super::strip::StripPressure;
use crate::numeric::bessel::{self, Kind, Wanted};
use crate::numeric::quadrature::rule;
use crate::solution::{Form, jacobi_weights};

/// Gauss points in v, and per unit of it.
const POINTS: usize = 12;
const PER_LENGTH: f64 = 7.0;

impl StripPressure {
    /// p̂ − p̂(0) at some wavenumbers, accurate to rounding.
    pub(super) fn disc_minus_resultant(&self, wavenumbers: &[f64]) -> Vec<f64> {
        let arguments: Vec<f64> = wavenumbers.iter().map(|wavenumber| wavenumber * self.half_length).collect();
        let resultant = self.resultant();
        match self.form {
            Form::Line => vec![0.0; arguments.len()],
            Form::Uniform => arguments.iter().map(|z| resultant * bessel::jinc_minus_one(*z)).collect(),
            Form::Parabolic => {
                let mut bessel = vec![0.0; 4 * arguments.len()];
                bessel::table(4, &arguments, &mut bessel);
                let third = &bessel[3 * arguments.len()..];
                let over = |j: &f64, z: &f64| if *z > 0.0 { 2.0 * j / z } else { 0.0 };
                let each = arguments.iter().zip(third);
                each.map(|(z, j)| resultant * (bessel::jinc_minus_one(*z) + over(j, z))).collect()
            }
            Form::Series => self.disc_series(&arguments),
        }
    }

    fn disc_series(&self, arguments: &[f64]) -> Vec<f64> {
        let (count, orders) = (arguments.len(), 2 * self.series.len() + 1);
        let wanted = Wanted::ZERO_AND_ODD.of_kind(Kind::Spherical);
        let columns = wanted.below(orders);
        let mut table = vec![0.0; columns * count];
        if self.series.len() > 1 {
            bessel::scaled_orders(orders, wanted, arguments, 1.0, count, &mut table);
        }
        let (square, weighted) = (self.half_length * self.half_length, self.weighted());
        let of = |(i, z): (usize, &f64)| {
            let first = self.first() / 3.0 * bessel::spherical_jinc_minus_one(*z);
            let of_orders = weighted.iter().enumerate().skip(1);
            let sum: f64 = of_orders.map(|(m, c)| c * table[(m + 1) * count + i]).sum();
            // (1 − cos z)/z² − ½ = ½ (sinc²(z/2) − 1)
            let half = bessel::sinc_minus_one(0.5 * z);
            let (corners, tip) = (self.corners * bessel::sinc_minus_one(*z), 0.5 * self.tip * half * (half + 2.0));
            square * (first + if *z > 0.0 { sum / z } else { 0.0 } + corners + tip)
        };
        arguments.iter().enumerate().map(of).collect()
    }

    /// The potentials at a distance r from the axis and a depth; potentials of J₁ are odd in r, and n > 0 is not asked for on the face.
    pub(super) fn disc_potentials(&self, r: f64, depth: f64) -> Closed {
        if self.form == Form::Line {
            return point(self.resultant(), r, depth);
        }
        let a = self.half_length;
        let mut sums = [Complex64::ZERO; 4];
        if self.form != Form::Series || self.tip != 0.0 {
            for (theta, weight) in places(&Spheroidal::new(r.abs() / a, depth / a)) {
                let weight = a * weight * self.source(theta);
                let values = sources(a * theta.sin(), r, depth);
                sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
            }
        }
        if self.corners != 0.0 {
            sums.iter_mut().zip(sources(a, r, depth)).for_each(|(sum, value)| *sum += a * self.corners * value);
        }
        if self.form == Form::Series {
            let of = spheroid::potentials(&self.by_order, a, r, depth);
            let Potentials([zeroth, first, second]) = of.potentials;
            sums.iter_mut().zip([zeroth, first, second, of.integral]).for_each(|(sum, value)| *sum += value);
        }
        let [zeroth, first, second, integral] = sums;
        let mut potentials = [zeroth, first, second];
        if depth == 0.0 {
            // the pressure itself
            potentials[0].re = self.on_face(r);
        }
        Closed { potentials: Potentials(potentials), integral }
    }

    /// The coefficients of j_(2m+1)(λa)/λ in p̂/a.
    pub(super) fn weighted(&self) -> Vec<f64> {
        self.series.iter().zip(jacobi_weights()).map(|(c, weight)| c / weight).collect()
    }

    /// h(s) ds/dθ with s = sin θ, without the part of a series.
    fn source(&self, theta: f64) -> f64 {
        let (sin, cos) = theta.sin_cos();
        let mean = self.resultant() / (self.half_length * self.half_length);
        match self.form {
            // p = 2 p̂(0)/a² and 4 p̂(0)/a² (1 − ρ²)
            Form::Uniform => 4.0 / PI * mean * sin,
            Form::Parabolic => 16.0 / PI * mean * sin * cos * cos,
            Form::Series | Form::Line => self.tip * cos,
        }
    }

    /// The pressure on the face; the mean of both sides where it ends.
    fn on_face(&self, r: f64) -> f64 {
        let s = r.abs() / self.half_length;
        let mean = self.resultant() / (self.half_length * self.half_length);
        if s > 1.0 {
            return 0.0;
        }
        match self.form {
            Form::Uniform => {
                if s == 1.0 {
                    mean
                } else {
                    2.0 * mean
                }
            }
            Form::Parabolic => 4.0 * mean * (1.0 - s * s),
            Form::Series | Form::Line => {
                let root = ((1.0 - s) * (1.0 + s)).sqrt();
                let corners = if self.corners == 0.0 { 0.0 } else { self.corners / root };
                let tip = if self.tip == 0.0 { 0.0 } else { self.tip * s.recip().acosh() };
                crate::solution::jacobi_sum(&self.series, s) + corners + tip
            }
        }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solution::Strip;

    /// The same by the transform: ∫ p̂ λ^(n+1) e^(−λd) J(λr) dλ.
    fn by_transform(disc: &StripPressure, r: f64, depth: f64, power: i32) -> Complex64 {
        let mut sum = Complex64::ZERO;
        let (panels, last) = (400, 40.0 / depth);
        for panel in 0..panels {
            let [from, to] = [panel, panel + 1].map(|k| last * f64::from(k) / f64::from(panels));
            for (wavenumber, weight) in rule(16).on(from, to) {
                let transform = disc.resultant() + disc.disc_minus_resultant(&[wavenumber])[0];
                let mut bessel = [0.0; 2];
                bessel::table(2, &[wavenumber * r], &mut bessel);
                let size = transform * wavenumber.powi(power + 1) * (-wavenumber * depth).exp() * weight;
                sum += size * Complex64::new(bessel[0], bessel[1]);
            }
        }
        sum
    }

    #[test]
    fn potentials_are_those_of_the_transform() {
        let round = |strip: Strip| StripPressure::new(&Strip { is_round: true, ..strip });
        let series = Strip::series(0.8, vec![1.0, -0.3, 0.2]);
        for disc in [
            round(series.clone()),
            round(Strip::series(0.8, (0..80).map(|m| 1.0 / f64::from(m * m + 1)).collect())),
            round(Strip { tip: 0.4, corners: 0.3, ..series.clone() }),
            round(Strip { form: Form::Uniform, ..Strip::series(0.8, vec![1.0]) }),
            round(Strip { form: Form::Parabolic, ..Strip::series(0.8, vec![1.0]) }),
            round(Strip { form: Form::Line, ..Strip::series(0.0, vec![1.0]) }),
        ] {
            for (r, depth) in [(0.0, 0.5), (0.3, 0.4), (0.79, 0.3), (1.7, 0.6)] {
                let found = disc.disc_potentials(r, depth);
                let Potentials([zeroth, first, second]) = found.potentials;
                for (power, found) in [(0, zeroth), (1, first), (2, second), (-1, found.integral)] {
                    let expected = by_transform(&disc, r, depth, power);
                    let error = (found - expected).norm();
                    assert!(error < 1e-10 * expected.norm(), "{disc:?} {r} {depth} {power}: {found} {expected}");
                }
            }
        }
    }

    #[test]
    fn close_to_the_face_they_are_the_pressure() {
        let disc = StripPressure::new(&Strip { is_round: true, ..Strip::series(0.8, vec![1.0, -0.3, 0.2]) });
        for r in [0.0, 0.1, 0.5, 0.75] {
            let [face, near] = [0.0, 1e-9].map(|depth| disc.disc_potentials(r, depth));
            let (Potentials([on, ..]), Potentials([below, ..])) = (face.potentials, near.potentials);
            assert!((on - below).norm() < 1e-7, "{r}: {on} {below}");
            assert!((face.integral - near.integral).norm() < 1e-7, "{r}: {} {}", face.integral, near.integral);
        }
    }
}
