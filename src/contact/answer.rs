//! The one assembly of a solution: what was found of each contact, put into the units of the scene.
use crate::contact::even::{RightInterval, whole};
use crate::contact::problem::load;
use crate::contact::problem::placed::Placed;
use crate::contact::problem::{Problem, Side};
use crate::solution::{Carried, Contact, Interface, Interval, Solution, Stats, Strip, Warning};

/// What was found of a contact whose pressure was to be found. Lengths are in units of L, pressures in units of μ₀P'.
pub(crate) struct Found {
    /// Where the bodies touch, one interval at least, from left to right.
    pub(crate) intervals: Vec<Interval>,
    /// Pressure at x = 0, and its absolute error.
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
    /// The angles of punches, per unit of P', if they are not one at x = 0 that is not turned.
    pub(crate) tilts: Vec<f64>,
    /// What it took.
    pub(crate) stats: Stats,
    pub(crate) warnings: Vec<Warning>,
}

impl Answer {
    /// The solution in the units of the scene.
    pub(crate) fn into_solution(self, problem: &Problem) -> Solution {
        let (length, unit) = (problem.kernel.length(), problem.kernel.modulus() * problem.force);
        let force = problem.total_force();
        let mut found = self.contacts.into_iter();
        let contact = |(side, interface): (&Side, &Interface)| match side.given() {
            Some(given) => Some(load::contact(&given.loads, *interface, force, problem.twin())),
            None => found.next().map(|found| found.into_contact(*interface, problem.origin * length, length, unit)),
        };
        let contacts: Vec<Contact> = problem.sides.iter().zip(problem.interfaces).filter_map(contact).collect();
        let punches = match problem.sides.first() {
            Some(Side::Punches(all)) => {
                let on = contacts[0].of_each_punch();
                let of = |((punch, contact), tilt): ((&Placed, &Contact), &f64)| {
                    let at = (problem.origin + punch.at()) * length;
                    let moment = |interval: &Interval| interval.force * (interval.centroid - at);
                    Carried {
                        force: contact.resultant,
                        tilt: tilt * problem.force,
                        moment: contact.intervals.iter().map(moment).sum(),
                    }
                };
                all.iter().zip(&on).zip(&self.tilts).map(of).collect()
            }
            _ => Vec::new(),
        };
        Solution {
            contacts,
            punches,
            stack: None,
            force,
            force_error: 0.0,
            min_pressure: self.min_pressure * unit,
            min_gap: self.min_gap * problem.force * length,
            stats: self.stats,
            warnings: self.warnings,
        }
    }
}

impl Found {
    /// What is even: intervals and strips of x ≥ 0, from the middle outwards.
    pub(crate) fn even(parts: Vec<RightInterval>, [peak, peak_error]: [f64; 2], strips: Vec<Strip>) -> Self {
        let (strips, intervals) = whole(strips, parts);
        Self { intervals, peak, peak_error, strips, punches: Vec::new() }
    }

    fn into_contact(self, interface: Interface, origin: f64, length: f64, unit: f64) -> Contact {
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
        let contact = Contact {
            interface,
            punches: self.punches,
            central_pressure: self.peak * unit,
            // an infinite pressure is known
            central_pressure_error: if self.peak.is_finite() { self.peak_error * unit } else { 0.0 },
            resultant: strips.iter().map(Strip::resultant).sum(),
            strips,
            intervals: self.intervals.iter().map(interval).collect(),
        };
        contact.with_forces()
    }
}
