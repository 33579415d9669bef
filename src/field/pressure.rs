//! A contact pressure as a load on the bodies below and above it: its transform, and potentials in closed form.
use num_complex::Complex64;

use super::potentials::Potentials;
use super::strip::{Image, Singularity};
use crate::solution::{Contact, Strip};

/// A place is a singular point if it is as close to it as this, in parts of its distance from x = 0: what lies between is
/// rounding.
const AT: f64 = 4.0 * f64::EPSILON;

/// A sum of strips, each with its mirror image.
#[derive(Clone, Debug)]
pub(super) struct Pressure {
    /// As far as it reaches.
    pub(super) half_length: f64,
    strips: Vec<(f64, Image)>,
}

impl Pressure {
    pub(super) fn new(contact: &Contact) -> Self {
        let strips: Vec<(f64, Image)> = contact.strips.iter().map(|strip| (strip.at, Image::new(strip))).collect();
        let reach = |strip: &Strip| strip.at + strip.extent;
        Self { half_length: contact.strips.iter().map(reach).fold(0.0, f64::max), strips }
    }

    /// Without the last terms of each series, as long as together they stay below this part of the largest one. The
    /// resultant remains.
    pub(super) fn truncated(&self, part: f64) -> Self {
        let strips = self.strips.iter().map(|(at, image)| (*at, image.truncated(part))).collect();
        Self { strips, ..*self }
    }

    /// Middles and half-lengths of the strips.
    pub(super) fn strips(&self) -> impl Iterator<Item = (f64, f64)> {
        self.strips.iter().map(|(at, image)| (*at, image.half_length))
    }

    /// Half-length of the narrowest strip.
    pub(super) fn narrowest(&self) -> f64 {
        self.strips().fold(self.half_length, |narrowest, (_, a)| narrowest.min(a))
    }

    /// Where x ≥ 0 and stresses on the face are infinite, and how.
    pub(super) fn singular_points(&self) -> impl Iterator<Item = (f64, Singularity)> {
        let of =
            |(at, image): &(f64, Image)| image.singular_points().map(|(x, kind)| (at + x, kind)).collect::<Vec<_>>();
        self.strips.iter().flat_map(of).map(|(x, kind)| (x.abs(), kind))
    }

    /// How stresses on the face are infinite at a place; the strongest way.
    pub(super) fn singularity(&self, x: f64) -> Option<Singularity> {
        let here = self.singular_points().filter(|(at, _)| (x.abs() - at).abs() <= AT * at);
        here.map(|(_, kind)| kind).min_by_key(|kind| *kind as u8)
    }

    /// How far a place is from the nearest one at which the pressure is not smooth: ends, and singular points.
    pub(super) fn distance(&self, x: f64) -> f64 {
        let ends = self.strips().flat_map(|(at, a)| [at - a, at + a]);
        let points = ends.chain(self.singular_points().map(|(at, _)| at));
        points.map(|at| (at.abs() - x.abs()).abs()).fold(f64::INFINITY, f64::min)
    }

    /// An amplitude of p̂ at a wavenumber.
    pub(super) fn envelope(&self, wavenumber: f64) -> f64 {
        let images = |at: f64| if at == 0.0 { 1.0 } else { 2.0 };
        self.strips.iter().map(|(at, image)| images(*at) * image.envelope(wavenumber)).sum()
    }

    /// p̂(0).
    pub(super) fn resultant(&self) -> f64 {
        let images = |at: f64| if at == 0.0 { 1.0 } else { 2.0 };
        self.strips.iter().map(|(at, image)| images(*at) * image.resultant()).sum()
    }

    /// p̂ and p̂ − P at some wavenumbers, eq. (22); the latter is O(λ²) and keeps its digits.
    pub(super) fn transforms(&self, wavenumbers: &[f64]) -> Vec<[f64; 2]> {
        let mut sums = vec![[0.0; 2]; wavenumbers.len()];
        for (at, image) in &self.strips {
            let resultant = image.resultant();
            for ((sum, excess), wavenumber) in sums.iter_mut().zip(image.excesses(wavenumbers)).zip(wavenumbers) {
                let [all, excess] = if *at == 0.0 {
                    [resultant + excess, excess]
                } else {
                    // 2 cos λx (P + excess) − 2P
                    let (sin, cos) = (0.5 * wavenumber * at).sin_cos();
                    let whole = 2.0 * (cos * cos - sin * sin);
                    [whole * (resultant + excess), whole * excess - 4.0 * sin * sin * resultant]
                };
                *sum = [sum[0] + all, sum[1] + excess];
            }
            if image.is_skew() {
                for ((sum, odd), wavenumber) in sums.iter_mut().zip(image.sines(wavenumbers)).zip(wavenumbers) {
                    let odd = -2.0 * (wavenumber * at).sin() * odd;
                    *sum = [sum[0] + odd, sum[1] + odd];
                }
            }
        }
        sums
    }

    /// The potentials at a depth, eq. (25). G_1 and G_2 are infinite at the ends of the contact.
    pub(super) fn potentials(&self, x: f64, depth: f64) -> Potentials {
        let mut sums = [Complex64::ZERO; 3];
        self.images(x, |image, x, mirror| {
            let Potentials(own) = image.potentials(x, depth, mirror);
            sums.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
        });
        Potentials(sums)
    }

    /// G_(−1), less a constant that is infinite: the integral of G_0 over the depth, eq. (26).
    pub(super) fn integral(&self, x: f64, depth: f64) -> Complex64 {
        let mut sum = Complex64::ZERO;
        self.images(x, |image, x, mirror| sum += image.integral(x, depth, mirror));
        sum
    }

    /// All strips and their mirror images, with places as seen from their middles.
    fn images(&self, x: f64, mut each: impl FnMut(&Image, f64, f64)) {
        for (at, image) in &self.strips {
            each(image, x - at, 1.0);
            if *at != 0.0 {
                each(image, x + at, -1.0);
            }
        }
    }
}
