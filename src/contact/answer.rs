//! The one assembly of a solution: what was found of each contact, put into the units of the scene.
use crate::contact::even::{RightInterval, whole};
use crate::contact::problem::load;
use crate::contact::problem::{Problem, Side};
use crate::kernel::{self, Kernel};
use crate::solution::{Contact, Interface, Solution, Stats, Strip, Warning};

/// What was found of a contact whose pressure was to be found. Lengths are in units of L, pressures in units of μ₀P'.
pub(crate) struct Found {
    /// Where the bodies touch for x ≥ 0, one part at least, from the middle outwards.
    pub(crate) parts: Vec<RightInterval>,
    /// Pressure at x = 0, and its absolute error.
    pub(crate) peak: f64,
    pub(crate) peak_error: f64,
    /// The pressures whose sum, with the mirror images of those beside x = 0, is the pressure of the contact.
    pub(crate) strips: Vec<Strip>,
}

/// What was found of all contacts.
pub(crate) struct Answer {
    /// From the top down, without those whose pressure is given.
    pub(crate) contacts: Vec<Found>,
    /// Smallest pressure inside and smallest gap outside the contacts, the latter per unit of P'.
    pub(crate) min_pressure: f64,
    pub(crate) min_gap: f64,
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
            None => found.next().map(|found| found.into_contact(*interface, length, unit)),
        };
        let contacts: Vec<Contact> = problem.sides.iter().zip(problem.interfaces).filter_map(contact).collect();
        Solution {
            contacts,
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
    fn into_contact(self, interface: Interface, length: f64, unit: f64) -> Contact {
        let scaled = |RightInterval { from, from_error, to, to_error }| RightInterval {
            from: from * length,
            from_error: from_error * length,
            to: to * length,
            to_error: to_error * length,
        };
        let strips = self.strips.into_iter().map(|strip| strip.scaled(length, unit)).collect();
        let (strips, intervals) = whole(strips, self.parts.into_iter().map(scaled).collect());
        let contact = Contact {
            interface,
            central_pressure: self.peak * unit,
            // an infinite pressure is known
            central_pressure_error: if self.peak.is_finite() { self.peak_error * unit } else { 0.0 },
            resultant: strips.iter().map(Strip::resultant).sum(),
            strips,
            intervals,
        };
        contact.with_forces()
    }
}

/// What it took to evaluate the stack.
pub(crate) fn stats(kernel: &Kernel) -> Stats {
    let kernel::Evaluations { wavenumbers, layers, repeated, below_decay_depth } = kernel.work();
    let (dropped, merged) = (kernel.dropped(), kernel.merged());
    Stats {
        dropped,
        merged,
        wavenumbers,
        layers,
        repeated,
        below_decay_depth,
        uncoupled: kernel.uncoupled_values(),
        ..Stats::default()
    }
}
