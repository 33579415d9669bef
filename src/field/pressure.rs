//! A contact pressure as a load on the bodies below and above it: its transform, and potentials in closed form.
use num_complex::Complex64;

use super::potentials::{Closed, Potentials};
use super::strip::{Singularity, StripPressure};
use crate::solution::{Contact, Form, Strip};

/// A place counts as a singular point if the distance between them is below this part of that from x = 0, which is rounding.
const AT: f64 = 4.0 * f64::EPSILON;

/// A sum of strips for x ≥ 0, each with its mirror image.
#[derive(Clone, Debug)]
pub(super) struct Pressure {
    /// The end of the farthest strip.
    pub(super) half_length: f64,
    strips: Vec<(f64, StripPressure)>,
}

/// The transform of a pressure at a wavenumber, eq. (22).
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Transform {
    /// p̂
    pub(super) value: f64,
    /// p̂ − P, which is O(λ²), accurate to rounding.
    pub(super) variation: f64,
}

impl Pressure {
    /// The pressure of a contact that is its own mirror image.
    pub(super) fn new(contact: &Contact) -> Self {
        let right = || contact.strips.iter().filter(|strip| strip.at >= 0.0);
        let end = |strip: &Strip| strip.at + strip.extent;
        let half_length = right().map(end).fold(0.0, f64::max);
        Self { half_length, strips: right().map(|strip| (strip.at, StripPressure::new(strip))).collect() }
    }

    /// Without the last terms of each series, as long as together they stay below this part of the largest one. The
    /// resultant remains.
    pub(super) fn truncated(&self, part: f64) -> Self {
        let strips = self.strips.iter().map(|(at, strip)| (*at, strip.truncated(part))).collect();
        Self { strips, ..*self }
    }

    /// Middles and half-lengths of the strips.
    pub(super) fn strips(&self) -> impl Iterator<Item = (f64, f64)> {
        self.strips.iter().map(|(at, strip)| (*at, strip.half_length))
    }

    /// The places x ≥ 0 at which the pressure ends; where it ends abruptly, next to them on both sides, at which stresses are the limits from
    /// there.
    pub(super) fn ends(&self) -> Vec<f64> {
        let of = |(at, strip): &(f64, StripPressure)| {
            let ends = [at - strip.half_length, at + strip.half_length];
            let beside = |end: f64| [end * (1.0 - 2.0 * AT), end * (1.0 + 2.0 * AT)];
            if strip.is_abrupt() { ends.map(beside).concat() } else { ends.to_vec() }
        };
        self.strips.iter().flat_map(of).filter(|end| *end >= 0.0).collect()
    }

    /// The places x > 0 at which the pressure jumps from one finite value to another.
    pub(super) fn jumps(&self) -> impl Iterator<Item = f64> {
        let uniform = self.strips.iter().filter(|(_, strip)| strip.form == Form::Uniform);
        uniform.flat_map(|(at, strip)| [at - strip.half_length, at + strip.half_length]).filter(|end| *end > 0.0)
    }

    /// The places x ≥ 0 at which stresses on the face are infinite, and the kind of the singularity.
    pub(super) fn singular_points(&self) -> impl Iterator<Item = (f64, Singularity)> {
        let of = |(at, strip): &(f64, StripPressure)| {
            strip.singular_points().map(|(x, kind)| (at + x, kind)).collect::<Vec<_>>()
        };
        self.strips.iter().flat_map(of).map(|(x, kind)| (x.abs(), kind))
    }

    /// The strongest singularity of stresses on the face at a place.
    pub(super) fn singularity(&self, x: f64) -> Option<Singularity> {
        let here = self.singular_points().filter(|(at, _)| (x.abs() - at).abs() <= AT * at);
        here.map(|(_, kind)| kind).min_by_key(|kind| *kind as u8)
    }

    /// The distance of a place from the nearest one at which the pressure is not smooth: ends, and singular points.
    pub(super) fn distance(&self, x: f64) -> f64 {
        let ends = self.strips().flat_map(|(at, a)| [at - a, at + a]);
        let points = ends.chain(self.singular_points().map(|(at, _)| at));
        points.map(|at| (at.abs() - x.abs()).abs()).fold(f64::INFINITY, f64::min)
    }

    /// An amplitude of p̂ at a wavenumber.
    pub(super) fn envelope(&self, wavenumber: f64) -> f64 {
        let images = |at: f64| if at == 0.0 { 1.0 } else { 2.0 };
        self.strips.iter().map(|(at, strip)| images(*at) * strip.envelope(wavenumber)).sum()
    }

    /// The mean pressure if it were spread over this half-length.
    pub(super) fn mean(&self, length: f64) -> f64 {
        match self.is_round() {
            true => 2.0 * self.resultant() / (length * length),
            false => self.resultant() / (2.0 * length),
        }
    }

    /// Whether it is about the axis of an axisymmetric problem.
    pub(super) fn is_round(&self) -> bool {
        self.strips.iter().any(|(_, strip)| strip.is_round)
    }

    /// p̂(0).
    pub(super) fn resultant(&self) -> f64 {
        let images = |at: f64| if at == 0.0 { 1.0 } else { 2.0 };
        self.strips.iter().map(|(at, strip)| images(*at) * strip.resultant()).sum()
    }

    /// The transforms at some wavenumbers.
    pub(super) fn transforms(&self, wavenumbers: &[f64]) -> Vec<Transform> {
        let mut sums = vec![Transform::default(); wavenumbers.len()];
        for (at, strip) in &self.strips {
            let resultant = strip.resultant();
            for ((sum, variation), wavenumber) in
                sums.iter_mut().zip(strip.minus_resultant(wavenumbers)).zip(wavenumbers)
            {
                if *at == 0.0 {
                    sum.value += resultant + variation;
                    sum.variation += variation;
                } else {
                    // 2 cos λx (P + variation) − 2P
                    let (sin, cos) = (0.5 * wavenumber * at).sin_cos();
                    let both = 2.0 * (cos * cos - sin * sin);
                    sum.value += both * (resultant + variation);
                    sum.variation += both * variation - 4.0 * sin * sin * resultant;
                }
            }
            if strip.is_skew() {
                for ((sum, odd), wavenumber) in sums.iter_mut().zip(strip.sines(wavenumbers)).zip(wavenumbers) {
                    let odd = -2.0 * (wavenumber * at).sin() * odd;
                    sum.value += odd;
                    sum.variation += odd;
                }
            }
        }
        sums
    }

    /// The potentials at a depth, eq. (25), and if it is wanted their [`Self::integral`]: those of a disc are known together. G_1 and G_2 are
    /// infinite at the ends of the contact.
    pub(super) fn closed(&self, x: f64, depth: f64, integral: bool) -> Closed {
        let mut sums = Closed { potentials: Potentials([Complex64::ZERO; 3]), integral: Complex64::ZERO };
        self.each_strip(x, |strip, x, mirror| {
            let closed = if strip.is_round {
                strip.disc_potentials(x, depth)
            } else {
                let integral = if integral { strip.integral(x, depth, mirror) } else { Complex64::ZERO };
                Closed { potentials: strip.potentials(x, depth, mirror), integral }
            };
            sums.integral += closed.integral;
            sums.potentials.0.iter_mut().zip(closed.potentials.0).for_each(|(sum, potential)| *sum += potential);
        });
        sums
    }

    /// The potentials at a depth.
    pub(super) fn potentials(&self, x: f64, depth: f64) -> Potentials {
        self.closed(x, depth, false).potentials
    }

    /// G_(−1), minus a constant that is infinite: the integral of G_0 over the depth, eq. (26).
    pub(super) fn integral(&self, x: f64, depth: f64) -> Complex64 {
        let mut sum = Complex64::ZERO;
        self.each_strip(x, |strip, x, mirror| sum += strip.integral(x, depth, mirror));
        sum
    }

    /// Calls `each` for all strips and their mirror images, with the place measured from their middles, and −1 for a mirror image.
    fn each_strip(&self, x: f64, mut each: impl FnMut(&StripPressure, f64, f64)) {
        for (at, strip) in &self.strips {
            each(strip, x - at, 1.0);
            if *at != 0.0 {
                each(strip, x + at, -1.0);
            }
        }
    }
}
