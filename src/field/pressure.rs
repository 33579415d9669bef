//! A contact pressure as a load on the bodies below and above it: its transform, and potentials in closed form.
use num_complex::Complex64;

use super::potentials::{Closed, Potentials};
use super::strip::{Singularity, StripPressure};
use crate::numeric::bessel;
use crate::solution::{Contact, Form, Strip};

/// A place counts as a singular point if the distance between them is below this part of that from x = 0, which is rounding.
const AT: f64 = 4.0 * f64::EPSILON;

/// Most strips of one pressure whose ends are places of their own; of more, as elements of low accuracy are, the ends of the intervals are, and
/// of more intervals the outermost ends: steps from one element to the next mean nothing, and each end takes a dozen points in every row.
const APART: usize = 16;

/// A sum of strips.
#[derive(Clone, Debug)]
pub(super) struct Pressure {
    /// The distance of the farthest end from x = 0.
    pub(super) half_length: f64,
    /// The strips with their middles; of an even pressure those for x ≥ 0, each of which has a mirror image.
    strips: Vec<(f64, StripPressure)>,
    /// The places at which it ends or its slope jumps, of an even pressure those x ≥ 0, from left to right.
    pub(super) ends: Vec<f64>,
    /// Whether these are the ends of all strips; the others are taken as smooth.
    is_whole: bool,
    is_even: bool,
}

/// The part of a pressure that is even about x = 0, which loads the bodies like cos λx, or the odd part, which loads them like sin λx.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Parity {
    Even,
    Odd,
}

/// The transform of a pressure at a wavenumber, eq. (22): ∫ p cos λx dx, or of the odd part ∫ p sin λx dx.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Transform {
    /// p̂
    pub(super) value: f64,
    /// What is left of p̂ without its limit for long waves, P, or λ times the moment of an odd pressure: accurate to rounding.
    pub(super) variation: f64,
}

impl Pressure {
    /// The pressure of a contact, which is even if `is_even`.
    pub(super) fn new(contact: &Contact, is_even: bool) -> Self {
        let strips = || contact.strips.iter().filter(|strip| !is_even || strip.at >= 0.0);
        let end = |strip: &Strip| strip.at.abs() + strip.extent;
        let half_length = strips().map(end).fold(0.0, f64::max);
        let intervals: Vec<[f64; 2]> = contact.intervals.iter().map(|one| [one.left, one.right]).collect();
        let of_strips = strips().map(|strip| [strip.at - strip.extent, strip.at + strip.extent]).collect();
        let outermost = intervals.first().zip(intervals.last()).map(|(first, last)| [first[0], last[1]]);
        let lists: [Vec<[f64; 2]>; 3] = [of_strips, intervals, outermost.into_iter().collect()];
        let is_whole = lists[0].len() <= APART;
        let chosen = lists.into_iter().find(|list| list.len() <= APART).unwrap_or_default();
        let strips = strips().map(|strip| (strip.at, StripPressure::new(strip))).collect();
        let mut pressure = Self { half_length, strips, ends: Vec::new(), is_whole, is_even };
        pressure.ends = chosen.into_iter().flatten().map(|end| pressure.place(end)).collect();
        pressure.ends.sort_by(f64::total_cmp);
        pressure.ends.dedup_by(|next, end| *next - *end <= AT * half_length);
        pressure
    }

    /// The place at which the pressure is looked at: an even pressure is known for x ≥ 0.
    fn place(&self, x: f64) -> f64 {
        if self.is_even { x.abs() } else { x }
    }

    /// How many strips a strip with this middle stands for, with its mirror image.
    fn images(&self, at: f64) -> f64 {
        if self.is_even && at != 0.0 { 2.0 } else { 1.0 }
    }

    /// Middles and half-lengths of the strips.
    pub(super) fn strips(&self) -> impl Iterator<Item = (f64, f64)> {
        self.strips.iter().map(|(at, strip)| (*at, strip.half_length))
    }

    /// The ends; where the pressure ends abruptly, next to them on both sides, at which stresses are the limits from there.
    pub(super) fn sides(&self) -> impl Iterator<Item = f64> {
        self.ends.iter().flat_map(|end| match self.ending(*end, StripPressure::is_abrupt) {
            Some(strip) => [-2.0, 2.0].map(|side| end + side * AT * strip.half_length.max(end.abs())),
            None => [*end; 2],
        })
    }

    /// The ends at which the pressure jumps from one finite value to another, but for x = 0 of an even pressure.
    pub(super) fn jumps(&self) -> impl Iterator<Item = f64> {
        let is_jump = |end: &f64| self.ending(*end, |strip| strip.form == Form::Uniform).is_some();
        self.ends.iter().copied().filter(|end| !self.is_even || *end > 0.0).filter(is_jump)
    }

    /// A strip of some kind that ends at a place.
    fn ending(&self, end: f64, is_wanted: impl Fn(&StripPressure) -> bool) -> Option<&StripPressure> {
        if !self.is_whole {
            return None;
        }
        let is_end = |middle: f64, a: f64| {
            let places = [middle - a, middle + a].map(|at| self.place(at));
            places.iter().any(|at| (end - at).abs() <= AT * (middle.abs() + a))
        };
        let ends = |(middle, strip): &&(f64, StripPressure)| {
            let a = strip.half_length;
            is_end(*middle, a) && is_wanted(strip)
        };
        self.strips.iter().find(ends).map(|(_, strip)| strip)
    }

    /// The places at which stresses on the face are infinite, of an even pressure those x ≥ 0, and the kind of the singularity.
    pub(super) fn singular_points(&self) -> impl Iterator<Item = (f64, Singularity)> {
        let of = |(at, strip): &(f64, StripPressure)| {
            strip.singular_points().map(|(x, kind)| (at + x, kind)).collect::<Vec<_>>()
        };
        self.strips.iter().flat_map(of).map(|(x, kind)| (self.place(x), kind))
    }

    /// The strongest singularity of stresses on the face at a place.
    pub(super) fn singularity(&self, x: f64) -> Option<Singularity> {
        let here = self.singular_points().filter(|(at, _)| (self.place(x) - at).abs() <= AT * at.abs());
        here.map(|(_, kind)| kind).min_by_key(|kind| *kind as u8)
    }

    /// The distance of a place from the nearest one at which the pressure is not smooth: ends, and singular points.
    pub(super) fn distance(&self, x: f64) -> f64 {
        let ends = self.strips().flat_map(|(at, a)| [at - a, at + a]);
        let points = ends.chain(self.singular_points().map(|(at, _)| at));
        points.map(|at| (self.place(at) - self.place(x)).abs()).fold(f64::INFINITY, f64::min)
    }

    /// An amplitude of p̂ at a wavenumber.
    pub(super) fn envelope(&self, wavenumber: f64) -> f64 {
        self.strips.iter().map(|(at, strip)| self.images(*at) * strip.envelope(wavenumber)).sum()
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
        self.strips.iter().map(|(at, strip)| self.images(*at) * strip.resultant()).sum()
    }

    /// The limit of the transform for long waves: the resultant of the even part, the moment of the odd part times the wavenumber.
    pub(super) fn of_long_waves(&self, parity: Parity, wavenumber: f64) -> f64 {
        let moment = |(at, strip): &(f64, StripPressure)| at * strip.resultant() + strip.moment();
        match parity {
            Parity::Even => self.resultant(),
            Parity::Odd => wavenumber * self.strips.iter().map(moment).sum::<f64>(),
        }
    }

    /// The transforms of the even or of the odd part at some wavenumbers.
    pub(super) fn transforms(&self, parity: Parity, wavenumbers: &[f64]) -> Vec<Transform> {
        let mut sums = vec![Transform::default(); wavenumbers.len()];
        for (at, strip) in &self.strips {
            let (images, resultant) = (self.images(*at), strip.resultant());
            let sines = if strip.is_skew() { strip.sines(wavenumbers) } else { Vec::new() };
            let variations = strip.minus_resultant(wavenumbers);
            for (q, ((sum, variation), wavenumber)) in sums.iter_mut().zip(variations).zip(wavenumbers).enumerate() {
                let [odd, odd_variation] = sines.get(q).copied().unwrap_or_default();
                match parity {
                    Parity::Even if *at == 0.0 => {
                        sum.value += resultant + variation;
                        sum.variation += variation;
                    }
                    Parity::Even => {
                        // cos λx (P + variation) − P, and the part that is odd about the middle
                        let (sin, cos) = (0.5 * wavenumber * at).sin_cos();
                        let wave = images * (cos * cos - sin * sin);
                        let odd = -images * (wavenumber * at).sin() * odd;
                        sum.value += wave * (resultant + variation) + odd;
                        sum.variation += wave * variation - 2.0 * images * sin * sin * resultant + odd;
                    }
                    Parity::Odd => {
                        let phase = wavenumber * at;
                        let ((sin, cos), half) = (phase.sin_cos(), (0.5 * phase).sin());
                        sum.value += sin * (resultant + variation) + cos * odd;
                        let of_place = resultant * phase * bessel::sinc_minus_one(phase) + sin * variation;
                        sum.variation += of_place + cos * odd_variation - 2.0 * half * half * (odd - odd_variation);
                    }
                }
            }
        }
        sums
    }

    /// The potentials at a depth, eq. (25), and if it is wanted their [`Self::integral`]: for a disc both are known together. G_1 and G_2 are
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
            if self.is_even && *at != 0.0 {
                each(strip, x + at, -1.0);
            }
        }
    }
}
