//! What was found of all contacts, in units of L and P', and the one assembly of a solution, in the units of the scene.
use crate::contact::problem::load;
use crate::contact::problem::placed::Placed;
use crate::contact::problem::{Problem, Side};
use crate::solution::{Carried, ClosedInterface, Contact, Interface, Interval, OwnerKey, Solution, Stats, Warning};
use crate::validity;

/// What was found of all contacts.
pub(crate) struct Answer {
    /// From the top down, without those whose pressure is given: lengths in units of L, pressures in units of μ₀P'.
    pub(crate) contacts: Vec<Contact>,
    /// Interfaces that lie on each other but for openings, in the same units; slopes per unit of P'.
    pub(crate) closed: Vec<ClosedInterface>,
    /// The force over the one that is given or expected, and its error.
    pub(crate) force: [f64; 2],
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
        let (contacts, closed, rotations, warnings) = Default::default();
        Self { contacts, closed, force: [1.0, 0.0], min_pressure: 0.0, min_gap: 0.0, rotations, stats, warnings }
    }

    /// The solution in the units of the scene, under a force that is given or expected, for a stack.
    pub(crate) fn into_solution(self, problem: &Problem, expected: f64, stack: Option<&OwnerKey>) -> Solution {
        let [force, force_error] = self.force.map(|part| part * expected);
        let (length, unit) = (problem.kernel.length(), problem.kernel.modulus() * problem.force);
        let mut found = self.contacts.into_iter();
        let contact = |(side, interface): (&Side, &Interface)| match side.given() {
            Some(given) => {
                let about = problem.is_even().then(|| problem.top.middle());
                Some(load::contact(&given.loads, *interface, force, problem.twin(), about))
            }
            None => found.next().map(|found| found.scaled(length, unit).moved(problem.top.middle())),
        };
        let contacts: Vec<Contact> = problem.sides.iter().zip(problem.interfaces).filter_map(contact).collect();
        // what lies above a contact turns with all that turns below
        let below = |contact: usize| self.rotations.iter().skip(contact).flatten().sum::<f64>();
        let is_told = problem.origin != 0.0;
        let even: Vec<Carried> = is_told.then_some(Carried { force, tilt: 0.0, moment: 0.0 }).into_iter().collect();
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
            Some(Side::Profile(_)) => even,
            _ => Vec::new(),
        };
        let rotations = (1..contacts.len()).map(|contact| below(contact) * problem.force).collect();
        let (mut warnings, middle) = (self.warnings, problem.top.middle());
        warnings.extend(validity::warnings(problem.top, problem.kernel, &contacts));
        Solution {
            axes: Vec::new(),
            contacts,
            closed: self.closed.into_iter().map(|own| own.scaled(length, middle, [unit, problem.force])).collect(),
            punches,
            rotations,
            stack: stack.cloned(),
            force,
            force_error,
            controlled: problem.prescribed.first().map(|(_, prescribed)| prescribed.controlled()),
            min_pressure: self.min_pressure * unit,
            min_gap: self.min_gap * problem.force * length,
            stats: self.stats,
            warnings,
        }
    }
}
