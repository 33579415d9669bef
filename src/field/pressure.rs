//! A contact pressure as a load on the bodies below and above it: its transform, and potentials in closed form.
use std::iter::zip;

use num_complex::Complex64;

use super::closed::Closed;
use super::strip::TabulatedStrip;
use super::transform::{Potentials, Transform};
use crate::solution::{ClosedInterface, Contact, Form, Strip};

/// A place counts as a singular point if the distance between them is below this part of their distance from the middle, which is rounding.
const AT: f64 = 4.0 * f64::EPSILON;

/// Most strips of one pressure whose ends are places of their own; of more, as elements of low accuracy are, the ends of the intervals are, and
/// of more intervals the outermost ends: steps from one element to the next mean nothing, and each end takes a dozen points in every row.
const APART: usize = 16;

/// A sum of strips.
#[derive(Clone, Debug)]
pub(crate) struct ContactPressure {
    /// The distance of the farthest end from the middle of the field, from which all places here are counted.
    pub(super) half_length: f64,
    /// The strips; of an even pressure those whose middles are at x ≥ 0, each of which has a mirror image.
    strips: Vec<TabulatedStrip>,
    /// The places at which it ends or its slope jumps, of an even pressure those x ≥ 0, from left to right.
    pub(super) ends: Vec<f64>,
    /// Whether these are the ends of all strips; the others are taken as smooth.
    is_whole: bool,
    is_even: bool,
    /// How far the middle is from x = 0: places in the scene have as many digits as that leaves.
    far: f64,
    /// Of an interface that weights press together, the strips of which are slopes of gaps, what makes the pressure there.
    closed: Option<Closed>,
}

impl ContactPressure {
    /// The pressure of a contact, which is even if `is_even`, with places that are counted from a `middle`.
    pub(crate) fn new(contact: &Contact, is_even: bool, middle: f64) -> Self {
        let (contact, far) = (contact.clone().moved(-middle), middle.abs());
        let strips = || contact.strips.iter().filter(|strip| !is_even || strip.at >= 0.0);
        let end = |strip: &Strip| strip.at.abs() + strip.extent;
        let half_length = strips().map(end).fold(0.0, f64::max);
        let intervals: Vec<[f64; 2]> = contact.intervals.iter().map(|one| [one.left, one.right]).collect();
        let of_strips = strips().map(Strip::ends).collect();
        let outermost = intervals.first().zip(intervals.last()).map(|(first, last)| [first[0], last[1]]);
        let lists: [Vec<[f64; 2]>; 3] = [of_strips, intervals, outermost.into_iter().collect()];
        let is_whole = lists[0].len() <= APART;
        let chosen = lists.into_iter().find(|list| list.len() <= APART).unwrap_or_default();
        let strips = strips().map(TabulatedStrip::new).collect();
        let mut pressure = Self { half_length, strips, ends: Vec::new(), is_whole, is_even, far, closed: None };
        pressure.ends = chosen.into_iter().flatten().map(|end| pressure.place(end)).collect();
        pressure.ends.sort_by(f64::total_cmp);
        pressure.ends.dedup_by(|next, end| *next - *end <= AT * half_length);
        pressure
    }

    /// The pressure of an interface that weights press together: of what is even on both sides, with the ends of the right one.
    pub(super) fn of_closed(interface: &ClosedInterface, is_even: bool, closed: Closed) -> Self {
        let strips: Vec<TabulatedStrip> = interface.slopes.iter().map(TabulatedStrip::new).collect();
        let ends = strips.iter().flat_map(|one| one.strip.ends());
        let ends: Vec<f64> = ends.filter(|end| !is_even || *end >= 0.0).collect();
        let half_length = ends.iter().fold(closed.half_length(), |most, end| most.max(end.abs()));
        Self { half_length, strips, ends, is_whole: true, is_even: false, far: 0.0, closed: Some(closed) }
    }

    /// Whether waves beyond the closed forms of its faces are to be summed.
    pub(super) fn has_waves(&self) -> bool {
        self.closed.is_some()
    }

    /// The place at which the pressure is looked at: an even pressure is known for x ≥ 0.
    fn place(&self, x: f64) -> f64 {
        if self.is_even { x.abs() } else { x }
    }

    /// How many strips a strip stands for, with its mirror image.
    fn images(&self, strip: &Strip) -> f64 {
        if self.is_even && strip.at != 0.0 { 2.0 } else { 1.0 }
    }

    /// The strips without their mirror images.
    pub(super) fn strips(&self) -> impl Iterator<Item = &Strip> {
        self.strips.iter().map(|tabulated| &tabulated.strip)
    }

    /// The ends; where the pressure ends abruptly, next to them on both sides, at which stresses are the limits from there.
    pub(super) fn sides(&self) -> impl Iterator<Item = f64> {
        let is_abrupt = |strip: &Strip| strip.form == Form::Uniform || strip.corners != [0.0; 2];
        self.ends.iter().flat_map(move |end| match self.ending(*end, is_abrupt) {
            Some(strip) => [-2.0, 2.0].map(|side| end + side * AT * strip.extent.max(end.abs() + self.far)),
            None => [*end; 2],
        })
    }

    /// The ends at which the pressure jumps from one finite value to another, but for x = 0 of an even pressure.
    pub(super) fn jumps(&self) -> impl Iterator<Item = f64> {
        let is_jump = |end: &f64| self.ending(*end, |strip| strip.form == Form::Uniform).is_some();
        self.ends.iter().copied().filter(|end| !self.is_even || *end > 0.0).filter(is_jump)
    }

    /// A strip of some kind that ends at a place.
    fn ending(&self, end: f64, is_wanted: impl Fn(&Strip) -> bool) -> Option<&Strip> {
        let ends = |strip: &&Strip| {
            let is_end = |at: f64| (end - self.place(at)).abs() <= AT * (strip.at.abs() + strip.extent);
            strip.ends().into_iter().any(is_end) && is_wanted(strip)
        };
        self.strips().filter(|_| self.is_whole).find(ends)
    }

    /// The places at which stresses on the face are infinite, of an even pressure those x ≥ 0, and whether the face sinks without limit there.
    pub(super) fn singular_points(&self) -> impl Iterator<Item = (f64, bool)> {
        self.strips().flat_map(Strip::singular_points).map(|(x, sinks)| (self.place(x), sinks))
    }

    /// Whether the face sinks without limit at a place at which stresses on it are infinite; `None` where they are finite.
    pub(super) fn singularity(&self, x: f64) -> Option<bool> {
        let here = self.singular_points().filter(|(at, _)| (self.place(x) - at).abs() <= AT * (at.abs() + self.far));
        here.map(|(_, sinks)| sinks).max()
    }

    /// The distance of a place from the nearest one at which the pressure is not smooth: ends, and singular points.
    pub(super) fn distance(&self, x: f64) -> f64 {
        let ends = self.strips().flat_map(Strip::ends);
        let points = ends.chain(self.singular_points().map(|(at, _)| at));
        points.map(|at| (self.place(at) - self.place(x)).abs()).fold(f64::INFINITY, f64::min)
    }

    /// An amplitude of p̂ at a wavenumber, and of what is not local in it, which has no closed form.
    pub(super) fn envelopes(&self, wavenumber: f64) -> [f64; 2] {
        if let Some(closed) = &self.closed {
            return closed.envelopes(wavenumber);
        }
        [self.strips.iter().map(|one| self.images(&one.strip) * one.envelope(wavenumber)).sum(), 0.0]
    }

    /// Its resultant; of a disc ∫ p r dr.
    pub(crate) fn resultant(&self) -> f64 {
        self.long_waves(0.0).re
    }

    /// The mean pressure if it were spread over this half-length.
    pub(super) fn mean(&self, length: f64) -> f64 {
        let resultant = self.resultant();
        if self.is_round() { 2.0 * resultant / (length * length) } else { resultant / (2.0 * length) }
    }

    /// Whether the pressure is about the axis of an axisymmetric problem.
    pub(super) fn is_round(&self) -> bool {
        // openings about an axis are not solved for
        self.strips().any(|strip| strip.is_round)
    }

    /// The transform of long waves, P + iλM with the resultant and the moment.
    pub(crate) fn long_waves(&self, wavenumber: f64) -> Complex64 {
        if let Some(closed) = &self.closed {
            return closed.long_waves(wavenumber);
        }
        let resultant = self.strips().map(|strip| self.images(strip) * strip.long_waves()).sum();
        let moment = self.strips().map(|strip| strip.at * strip.long_waves() + strip.moment()).sum::<f64>();
        Complex64::new(resultant, wavenumber * moment)
    }

    /// The transforms about the middle at some wavenumbers; of an even pressure only their real parts have a meaning.
    pub(crate) fn transforms(&self, wavenumbers: &[f64]) -> Vec<Transform> {
        if let Some(closed) = &self.closed {
            return closed.transforms(wavenumbers);
        }
        let mut sums = vec![Transform::default(); wavenumbers.len()];
        for strip in self.strips() {
            let (images, resultant) = (self.images(strip), strip.long_waves());
            for ((sum, own), wavenumber) in zip(zip(&mut sums, strip.transforms(wavenumbers)), wavenumbers) {
                let Transform { value, variation, .. } = own.moved(*wavenumber, strip.at, resultant);
                sum.value += images * value;
                sum.variation += images * variation;
                sum.local = sum.value;
            }
        }
        sums
    }

    /// The potentials at a depth, eq. (25); G_(−1) is 0 if it takes time and is not wanted. G_1 and G_2 are infinite at the ends of the contact.
    pub(super) fn potentials(&self, x: f64, depth: f64, integral: bool) -> Potentials {
        let mut sums = Potentials::default();
        for one in &self.strips {
            let at = one.strip.at;
            zip(&mut sums, one.potentials(x - at, depth, integral)).for_each(|(sum, own)| *sum += own);
            if self.is_even && at != 0.0 {
                let image = one.potentials(-x - at, depth, integral);
                zip(&mut sums, image).for_each(|(sum, image)| *sum += image.conj());
            }
        }
        match &self.closed {
            Some(closed) => closed.potentials(sums, (x, depth), integral),
            None => sums,
        }
    }
}
