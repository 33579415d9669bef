//! Tension within intervals, and what is done about it.
use std::f64::consts::PI;
use std::ops::Range;

use crate::contact::intervals::newton::Approximation;
use crate::contact::intervals::pressure::Pressure;
use crate::contact::intervals::support::{ContactInterval, Intervals};
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::{COARSE, SAFETY};

/// What is done about tension within intervals.
pub(super) enum Tension {
    None,
    /// As much as terms that are missing may make: more of them are to tell.
    Unresolved,
    /// The list without, and the largest tension, over the mean pressure.
    Certain(Intervals, f64),
}

/// The pressure of an interval in places from its right end inwards.
struct Inside<'a> {
    interval: &'a ContactInterval,
    places: usize,
    pressures: Vec<f64>,
}

/// Looks for negative pressures, and whether fewer terms have them, too.
pub(super) fn tension(problem: &Problem, level: &Approximation) -> Tension {
    let mut found = Tension::None;
    let all = level.support.0.iter().zip(&level.solved.pressures).zip(&level.coarser[0].pressures).enumerate();
    for (number, ((interval, pressure), coarser)) in all {
        let places = pressure.places(interval);
        let inside = |own: &Pressure| level.inside(problem, number, own);
        let (own, coarser) = (Inside { interval, places, pressures: inside(pressure) }, inside(coarser));
        let mean = level.mean_pressure(interval.contact);
        let tensile: Vec<usize> = (0..coarser.len()).filter(|k| own.pressures[*k] < -COARSE * mean).collect();
        let is_certain = |k: &usize| own.pressures[*k] < -SAFETY * (own.pressures[*k] - coarser[*k]).abs();
        let certain: Vec<usize> = tensile.iter().copied().filter(is_certain).collect();
        // as a part of what its punch carries: each punch keeps an interval
        let share = problem.group(interval.contact, interval.punch).map_or(1.0, |group| group.share);
        let part = if interval.opens { 1.0 } else { pressure.force(interval) / share };
        let is_like = |other: &&ContactInterval| other.punch == interval.punch;
        let is_light = part < COARSE && level.support.of(interval.contact).iter().filter(is_like).count() > 1;
        let parts = match certain[..] {
            [] => None,
            _ if is_light => Some(Vec::new()),
            [first, ..] => own.without_tail(&certain, part).or_else(|| own.without(first)),
        };
        if let Some(parts) = parts {
            let mut all = level.support.0.clone();
            all.splice(number..=number, parts);
            let largest = certain.iter().map(|k| -own.pressures[*k] / mean).fold(0.0, f64::max);
            return Tension::Certain(Intervals(all), largest);
        }
        if !tensile.is_empty() {
            found = Tension::Unresolved;
        }
    }
    found
}

impl Inside<'_> {
    fn angle(&self, k: usize) -> f64 {
        PI * (k + 1) as f64 / self.places as f64
    }

    fn place(&self, k: usize) -> f64 {
        self.interval.place(self.angle(k))
    }

    /// The first and the last of the places around one at which the pressure is negative.
    fn around(&self, k: usize) -> [usize; 2] {
        let is_negative = |k: &usize| self.pressures[*k] < 0.0;
        let first = (0..=k).rev().take_while(is_negative).last().unwrap_or(k);
        [first, (k..self.pressures.len()).take_while(is_negative).last().unwrap_or(k)]
    }

    /// What positive pressures carry in some places, in a unit of its own.
    fn carried(&self, places: Range<usize>) -> f64 {
        let arm = |k: usize| self.place(k).abs().powi(self.interval.twin.lengths - 1);
        places.map(|k| self.pressures[k].max(0.0) * self.angle(k).sin() * arm(k)).sum()
    }

    /// The interval up to the innermost place of certain tension beyond which it carries next to nothing, itself carrying a part of the force of its punch.
    fn without_tail(&self, certain: &[usize], part: f64) -> Option<Vec<ContactInterval>> {
        let (interval, count) = (self.interval, self.pressures.len());
        let nothing = COARSE * self.carried(0..count) / part;
        let right = certain.iter().rev().find(|k| self.carried(0..**k) < nothing);
        let left = certain.iter().find(|k| !interval.is_even() && self.carried(**k..count) < nothing);
        let (ends, kept) = match (right, left) {
            (Some(k), _) => ([interval.from(), self.place(self.around(*k)[1])], [true, false]),
            (None, Some(k)) => ([self.place(self.around(*k)[0]), interval.to()], [false, true]),
            (None, None) => return None,
        };
        let corners = [0, 1].map(|side| kept[side] && interval.corners[side]);
        (ends[0] < ends[1]).then(|| vec![interval.between(ends).with_corners(corners)])
    }

    /// The parts of the interval on both sides of the tension around a place; about the middle of what is even the outer part only. `None` if nothing is left.
    fn without(&self, k: usize) -> Option<Vec<ContactInterval>> {
        let (interval, [first, last]) = (self.interval, self.around(k));
        let [left, right] = interval.corners;
        let inner = (!interval.is_even() || last + 1 < self.pressures.len()).then(|| {
            let ends = [interval.from(), self.place(last)];
            interval.between(ends).with_corners([left && !interval.is_even(), false])
        });
        // the last place is the middle of what is even
        let from = if interval.is_even() && first + 1 == self.pressures.len() {
            0.5 * self.place(first.saturating_sub(1))
        } else {
            self.place(first)
        };
        let outer = interval.between([from, interval.to()]).with_corners([false, right]);
        let parts: Vec<ContactInterval> = inner.into_iter().chain([outer]).filter(|part| part.half > 0.0).collect();
        (!parts.is_empty()).then_some(parts)
    }
}

impl Approximation {
    /// The largest of the mean pressures on the intervals of a contact, with which tension is compared.
    pub(super) fn mean_pressure(&self, contact: usize) -> f64 {
        let own = self.support.0.iter().zip(&self.solved.pressures).filter(|(interval, _)| interval.contact == contact);
        own.map(|(interval, pressure)| pressure.mean(interval)).fold(0.0, f64::max)
    }
}
