//! Where bodies touch, or, at interfaces that are closed elsewhere, where they are apart, in the order of contacts and from left to right; where all is even, intervals of x ≥ 0, each with its mirror image.
use std::f64::consts::PI;

use crate::contact::problem::modes::alternating;
use crate::contact::problem::twin::Twin;
use crate::contact::problem::{Prescribed, Problem};
use crate::numeric::bessel::Wanted;

/// Neighbours' intervals whose lengths differ by a larger factor are not alike: their pressures have their resultants in common, and no more.
const ALIKE: f64 = 10.0;

/// What the mirror image of an interval about x = 0 is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Parity {
    /// The interval itself: its pressure is even.
    Even,
    /// Another interval with the mirror image of its pressure.
    Pair,
    /// Nothing of the kind.
    None,
}

/// An interval in which the bodies of a contact touch, in units of L.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ContactInterval {
    pub(super) contact: usize,
    /// Whether it is a disc about an axis: then it is even.
    pub(super) twin: Twin,
    /// The number of the punch that presses there, from the left; 0 between layers.
    pub(super) punch: usize,
    pub(super) middle: f64,
    pub(super) half: f64,
    pub(super) parity: Parity,
    /// Whether the bodies are apart there, and lie on each other beside it: what presses in a contact is the slope of the gap then.
    pub(super) opens: bool,
    /// Whether the left and the right end stay where they are: at the corners of a flat punch, where the pressure may be singular, or where that is prescribed.
    pub(super) corners: [bool; 2],
}

/// One end of an interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct End {
    /// The number of the interval.
    pub(super) interval: usize,
    /// 1 for a right end, −1 for a left one.
    pub(super) side: f64,
}

impl ContactInterval {
    /// From one place to another on x ≥ 0 where all is even; about x = 0 if it begins there.
    pub(super) fn even(twin: Twin, contact: usize, [from, to]: [f64; 2]) -> Self {
        let (middle, parity) = if from > 0.0 { (0.5 * (from + to), Parity::Pair) } else { (0.0, Parity::Even) };
        Self { contact, twin, punch: 0, middle, half: to - middle, parity, opens: false, corners: [false; 2] }
    }

    /// From one place to another where nothing is even.
    pub(super) fn anywhere(contact: usize, punch: usize, [left, right]: [f64; 2]) -> Self {
        let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
        Self {
            contact,
            twin: Twin::Plane,
            punch,
            middle,
            half,
            parity: Parity::None,
            opens: false,
            corners: [false; 2],
        }
    }

    /// An opening from one place to another, on x ≥ 0 where all is even.
    pub(super) fn opening(problem: &Problem, contact: usize, [from, to]: [f64; 2]) -> Self {
        let interval = match problem.is_even() {
            true => Self::even(problem.twin(), contact, [from.max(0.0), to]),
            false => Self::anywhere(contact, 0, [from, to]),
        };
        Self { opens: true, ..interval }
    }

    /// An interval of the same contact and punch between other places, without corners.
    pub(super) fn between(&self, ends: [f64; 2]) -> Self {
        let interval = match self.parity {
            Parity::None => Self::anywhere(self.contact, self.punch, ends),
            Parity::Even | Parity::Pair => Self::even(self.twin, self.contact, ends),
        };
        Self { opens: self.opens, ..interval }
    }

    /// The same interval with ends at corners, or not.
    pub(super) fn with_corners(self, corners: [bool; 2]) -> Self {
        Self { corners, ..self }
    }

    /// Whether an end is at a corner, by its side.
    pub(super) fn is_corner(&self, side: f64) -> bool {
        self.corners[usize::from(side > 0.0)]
    }

    /// Whether it is its own mirror image.
    pub(super) fn is_even(&self) -> bool {
        self.parity == Parity::Even
    }

    /// Whether what presses there is odd, where all is even: the slope of a gap is.
    pub(super) fn is_odd(&self) -> bool {
        self.opens && self.parity != Parity::None
    }

    /// Whether its pressure has terms of odd orders, and of even ones, which are odd about its middle.
    pub(super) fn has_orders(&self) -> [bool; 2] {
        [!(self.is_even() && self.opens), !self.is_even() || self.opens]
    }

    /// The sign of what presses next to an end, with which this is positive: the gap of an opening falls at its right end.
    pub(super) fn sign(&self, side: f64) -> f64 {
        if self.opens { -side } else { 1.0 }
    }

    /// Whether the next interval is under the same punch, or of the same laminates: openings are each by itself.
    pub(super) fn is_grouped_with(&self, next: &Self) -> bool {
        self.punch == next.punch && !self.opens
    }

    /// Where it begins, on x ≥ 0 if all is even.
    pub(super) fn from(&self) -> f64 {
        if self.is_even() { 0.0 } else { self.middle - self.half }
    }

    pub(super) fn to(&self) -> f64 {
        self.middle + self.half
    }

    /// x = middle + half cos φ.
    pub(super) fn place(&self, phi: f64) -> f64 {
        self.middle + self.half * phi.cos()
    }

    /// Itself, and its mirror image if that is another interval.
    pub(super) fn images(&self) -> f64 {
        if self.parity == Parity::Pair { 2.0 } else { 1.0 }
    }

    /// What its ends are compared with: their distance from the middle of what is even, or the half-length.
    pub(super) fn sizes(&self) -> [f64; 2] {
        if self.parity == Parity::None { [self.half; 2] } else { [self.from(), self.to()] }
    }

    /// The order j of the term sin jφ of number m of its pressure, x = middle + half cos φ.
    pub(super) fn order(&self, m: usize) -> usize {
        match self.has_orders() {
            [true, true] => m + 1,
            [true, false] => 2 * m + 1,
            [false, _] => 2 * m + 2,
        }
    }

    /// The Bessel functions that its terms need.
    pub(super) fn wanted(&self) -> Wanted {
        if self.has_orders()[1] { Wanted::ALL } else { Wanted::ZERO_AND_ODD.of_kind(self.twin.bessel) }
    }

    /// The place of one order among these.
    pub(super) fn among_wanted(&self, order: usize) -> usize {
        if self.has_orders()[1] { order } else { order.div_ceil(2) }
    }

    /// The amplitude of sin φ on the interval and its mirror image that has the resultant 1.
    pub(super) fn unit(&self) -> f64 {
        self.twin.unit(self.half) / (PI * self.images())
    }

    /// How term number m rises next to an end, per unit of sin φ with the amplitude [`Self::unit`].
    pub(super) fn at_end(&self, m: usize) -> f64 {
        self.twin.norm * self.twin.scale(m)
    }

    /// The column of term number m, and its test, over the Bessel function of its order.
    pub(super) fn transform(&self, m: usize) -> f64 {
        2.0 * alternating(self.order(m) / 2) * self.at_end(m) / self.half
    }

    /// What the test of term number m sees of ∫ f' cos kφ dφ of a slope f'.
    pub(super) fn test(&self, m: usize) -> f64 {
        4.0 / (PI * self.half) * self.twin.load(m)
    }

    /// What term number m does to its own test on a half-plane with λμ₀C = 1.
    pub(super) fn on_half_plane(&self, m: usize) -> f64 {
        4.0 / (PI * self.images()) * self.twin.product(self.order(m), m, self.half)
    }

    /// Its ends that are not the mirror images of others: 1 for a right one, −1 for a left one.
    pub(super) fn sides(&self) -> &'static [f64] {
        if self.is_even() { &[1.0] } else { &[-1.0, 1.0] }
    }
}

/// All intervals of all contacts.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Intervals(pub(super) Vec<ContactInterval>);

impl Intervals {
    /// The intervals of a contact.
    pub(super) fn of(&self, contact: usize) -> &[ContactInterval] {
        let first = self.0.partition_point(|interval| interval.contact < contact);
        let after = self.0.partition_point(|interval| interval.contact <= contact);
        &self.0[first..after]
    }

    /// Whether the lists of the contacts above and below a laminate are alike: as many intervals of the same kinds and nearly the same lengths.
    pub(super) fn are_alike(&self, laminate: usize) -> bool {
        let [above, below] = [self.of(laminate), self.of(laminate + 1)];
        let alike = |(above, below): (&ContactInterval, &ContactInterval)| {
            above.parity == below.parity && !below.opens && (above.half / below.half).ln().abs() < ALIKE.ln()
        };
        above.len() == below.len() && above.iter().zip(below).all(alike)
    }

    /// Makes numbers of terms the same on neighbours the lists of which are alike, so that their unknowns can be counted from each other.
    pub(super) fn equalise(&self, counts: &mut [usize]) {
        let last = self.0.last().map_or(0, |interval| interval.contact);
        let first = |contact: usize| self.0.partition_point(|interval| interval.contact < contact);
        for laminate in (0..last).chain((0..last).rev()).filter(|laminate| self.are_alike(*laminate)) {
            for (above, below) in (first(laminate)..first(laminate + 1)).zip(first(laminate + 1)..) {
                let most = counts[above].max(counts[below]);
                (counts[above], counts[below]) = (most, most);
            }
        }
    }

    /// With contacts under punches ending where that is prescribed, if it is, and staying there.
    pub(super) fn held(mut self, problem: &Problem) -> Self {
        for (punch, prescribed) in &problem.prescribed {
            let Prescribed::End { side, at } = *prescribed else { continue };
            let is_there = |interval: &&mut ContactInterval| interval.contact == 0 && interval.punch == *punch;
            let mut own: Vec<&mut ContactInterval> = self.0.iter_mut().filter(is_there).collect();
            own.iter_mut().for_each(|interval| interval.corners = [false; 2]);
            let held = match problem.is_even() || side < 0.0 {
                true => own.into_iter().next(),
                false => own.into_iter().next_back(),
            };
            let Some(interval) = held else { continue };
            let other = if side > 0.0 { interval.from() } else { interval.to() };
            let other = match side * (at - other) > 0.0 {
                true => other,
                false if problem.is_even() => 0.0,
                false => at - 2.0 * side * interval.half,
            };
            *interval = interval.between([other.min(at), other.max(at)]).with_corners([side < 0.0, side > 0.0]);
        }
        self
    }

    /// All ends, from the top down and outwards.
    pub(super) fn ends(&self) -> Vec<End> {
        let of = |(interval, own): (usize, &ContactInterval)| {
            own.sides().iter().map(move |side| End { interval, side: *side }).collect::<Vec<_>>()
        };
        self.0.iter().enumerate().flat_map(of).collect()
    }

    /// Where an end is.
    pub(super) fn place(&self, end: End) -> f64 {
        let interval = &self.0[end.interval];
        interval.middle + end.side * interval.half
    }

    /// From an end to the next interval of the same contact, or to the middle of what is even; infinite where there is none.
    pub(super) fn gap(&self, end: End) -> f64 {
        let own = &self.0[end.interval];
        let same = |other: &&ContactInterval| other.contact == own.contact;
        if end.side > 0.0 {
            return self.0.get(end.interval + 1).filter(same).map_or(f64::INFINITY, |next| next.from() - own.to());
        }
        let before = end.interval.checked_sub(1).and_then(|before| self.0.get(before)).filter(same);
        let first = if own.parity == Parity::None { f64::NEG_INFINITY } else { 0.0 };
        own.from() - before.map_or(first, ContactInterval::to)
    }

    /// With each end moved outwards by so much.
    pub(super) fn moved(&self, outwards: &[f64]) -> Self {
        let mut moved = self.clone();
        for (end, by) in self.ends().into_iter().zip(outwards) {
            let interval = &mut moved.0[end.interval];
            if interval.is_even() {
                interval.half += by;
            } else {
                interval.half += 0.5 * by;
                interval.middle += 0.5 * end.side * by;
            }
        }
        moved
    }
}
