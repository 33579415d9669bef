//! What was found of all contacts, in units of L and P', and the one assembly of a solution, in the units of the scene.
use crate::contact::problem::load;
use crate::contact::problem::placed::Placed;
use crate::contact::problem::{Problem, Side};
use crate::solution::{Carried, Contact, Interface, Interval, OwnerKey, Solution, Stats, Strip, Warning};
use crate::validity;

/// What was found of a contact whose pressure was to be found. Lengths are in units of L, pressures in units of μ₀P'.
#[derive(Clone)]
pub(crate) struct Found {
    /// Where the bodies touch, one interval at least, from left to right.
    pub(crate) intervals: Vec<Interval>,
    /// Pressure in the middle of what is even, elsewhere in the middle of the interval with the largest force, and its absolute error.
    pub(crate) peak: f64,
    pub(crate) peak_error: f64,
    /// The pressures whose sum is the pressure of the contact, from left to right.
    pub(crate) strips: Vec<Strip>,
    /// Under several punches the number of the punch of each interval; else none.
    pub(crate) punches: Vec<usize>,
}

/// What was found of all contacts.
pub(crate) struct Answer {
    /// From the top down, without those whose pressure is given.
    pub(crate) contacts: Vec<Found>,
    /// Smallest pressure inside and smallest gap outside the contacts, the latter per unit of P'.
    pub(crate) min_pressure: f64,
    pub(crate) min_gap: f64,
    /// By how much the slope of the gap of each contact grows since bodies turn, per unit of P', under each punch; none where all is even.
    pub(crate) rotations: Vec<Vec<f64>>,
    /// What it took.
    pub(crate) stats: Stats,
    pub(crate) warnings: Vec<Warning>,
}

impl Answer {
    /// Where all pressures are given.
    pub(crate) fn known(problem: &Problem) -> Self {
        let stats = Stats { modes: vec![1; problem.contacts()], ..problem.kernel.stats() };
        let (contacts, rotations, warnings) = (Vec::new(), Vec::new(), Vec::new());
        Self { contacts, min_pressure: 0.0, min_gap: 0.0, rotations, stats, warnings }
    }

    /// The solution in the units of the scene, under a force in these units, for a stack.
    pub(crate) fn into_solution(self, problem: &Problem, force: f64, stack: Option<&OwnerKey>) -> Solution {
        let (length, unit) = (problem.kernel.length(), problem.kernel.modulus() * problem.force);
        let mut found = self.contacts.into_iter();
        let contact = |(side, interface): (&Side, &Interface)| match side.given() {
            Some(given) => {
                let about = problem.is_even().then(|| problem.top.middle());
                Some(load::contact(&given.loads, *interface, force, problem.twin(), about))
            }
            None => found.next().map(|found| found.into_contact(*interface, problem, unit)),
        };
        let contacts: Vec<Contact> = problem.sides.iter().zip(problem.interfaces).filter_map(contact).collect();
        // what lies above a contact turns with all that turns below
        let below = |contact: usize| self.rotations.iter().skip(contact).flatten().sum::<f64>();
        let punches = match problem.sides.first() {
            Some(Side::Punches(all)) => {
                let on = contacts[0].of_each_punch();
                let of = |((punch, contact), rotation): ((&Placed, &Contact), &f64)| {
                    let at = (problem.origin + punch.at()) * length;
                    let moment = |interval: &Interval| interval.force * (interval.centroid - at);
                    Carried {
                        force: contact.resultant,
                        tilt: punch.angle().unwrap_or(rotation + below(1)) * problem.force,
                        moment: contact.intervals.iter().map(moment).sum(),
                    }
                };
                all.iter().zip(&on).zip(self.rotations.iter().flatten()).map(of).collect()
            }
            Some(Side::Profile(_)) if problem.origin != 0.0 => vec![Carried { force, tilt: 0.0, moment: 0.0 }],
            _ => Vec::new(),
        };
        let rotations = (1..contacts.len()).map(|contact| below(contact) * problem.force).collect();
        let mut warnings = self.warnings;
        warnings.extend(validity::warnings(problem.top, problem.kernel, &contacts));
        Solution {
            contacts,
            punches,
            rotations,
            stack: stack.cloned(),
            force,
            force_error: 0.0,
            min_pressure: self.min_pressure * unit,
            min_gap: self.min_gap * problem.force * length,
            stats: self.stats,
            warnings,
        }
    }
}

impl Found {
    /// What is even about x = 0, from intervals and strips of x ≥ 0, from the middle outwards: an interval that begins at 0 is one with its
    /// mirror image.
    pub(crate) fn even(right: &[Interval], [peak, peak_error]: [f64; 2], strips: &[Strip]) -> Self {
        let mut intervals: Vec<Interval> = right.iter().rev().map(Interval::mirrored).collect();
        let left = intervals.pop_if(|_| right[0].left == 0.0);
        intervals.extend(right);
        if let Some(Interval { left, left_error, .. }) = left {
            let middle = &mut intervals[right.len() - 1];
            (middle.left, middle.left_error) = (left, left_error);
        }
        let images = strips.iter().rev().filter(|strip| strip.at > 0.0).map(|strip| strip.mirrored(0.0));
        let strips = images.chain(strips.iter().cloned()).collect();
        Self { intervals, peak, peak_error, strips, punches: Vec::new() }
    }

    /// As far as the bodies touch from x = 0.
    pub(crate) fn reach(&self) -> f64 {
        Interval::reach(&self.intervals)
    }

    /// The interval about x = 0, or the next one.
    pub(crate) fn innermost(&self) -> Interval {
        Interval::innermost(&self.intervals, 0.0)
    }

    fn into_contact(self, interface: Interface, problem: &Problem, unit: f64) -> Contact {
        let (origin, length) = (problem.top.middle(), problem.kernel.length());
        let interval = |Interval { left, right, left_error, right_error, .. }: &Interval| {
            let place = |x: f64, error: f64| [origin + x * length, error * length];
            Interval::new(place(*left, *left_error), place(*right, *right_error))
        };
        let strips: Vec<Strip> = self
            .strips
            .into_iter()
            .map(|strip| strip.scaled(length, unit))
            .map(|strip| Strip { at: origin + strip.at, ..strip })
            .collect();
        // an infinite pressure is known
        let error = if self.peak.is_infinite() { 0.0 } else { self.peak_error * unit };
        let middle_pressure = [self.peak * unit, error];
        let about = problem.is_even().then_some(origin);
        // the series of a sharp tip is summed in closed form in the middle
        let [central_pressure, central_pressure_error] = if about == Some(0.0) {
            middle_pressure
        } else {
            let pressure: f64 = strips.iter().map(|strip| strip.pressure(0.0)).sum();
            // so is none
            [pressure, if pressure == 0.0 || pressure.is_infinite() { 0.0 } else { self.peak_error * unit }]
        };
        let contact = Contact {
            interface,
            punches: self.punches,
            central_pressure,
            central_pressure_error,
            about,
            middle_pressure,
            resultant: strips.iter().map(Strip::resultant).sum(),
            strips,
            intervals: self.intervals.iter().map(interval).collect(),
        };
        contact.with_forces()
    }
}
