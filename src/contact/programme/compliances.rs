//! The kernels of the contacts whose pressures are unknown, as the programme sees them.
use std::ops::Range;

use crate::contact::problem::load::Given;
use crate::contact::problem::{Problem, Side};

/// The kernels of some contacts, one below the other. What presses on their laminates from the next contact, above or
/// below, is given.
pub(super) struct Compliances<'a> {
    problem: &'a Problem<'a>,
    contacts: Range<usize>,
}

impl<'a> Compliances<'a> {
    pub(super) fn new(problem: &'a Problem<'a>) -> Self {
        let mut unknown = problem.unknown();
        let first = unknown.next().unwrap_or(problem.contacts());
        Self { problem, contacts: first..first + unknown.count() + usize::from(first < problem.contacts()) }
    }

    /// How many contacts there are.
    pub(super) fn contacts(&self) -> usize {
        self.contacts.len()
    }

    /// What is special about contact i.
    pub(super) fn side(&self, i: usize) -> &Side<'a> {
        &self.problem.sides[self.contacts.start + i]
    }

    /// What the kernel of contact i tends to for short waves.
    pub(super) fn limit(&self, i: usize) -> f64 {
        self.problem.kernel.asymptote(self.contacts.start + i).limit
    }

    /// The kernel of contact i if its neighbours have the same pressure.
    pub(super) fn own(&self, i: usize, zeta: f64) -> f64 {
        self.limit(i) + self.problem.kernel.remainder(self.contacts.start + i, zeta)
    }

    /// The couplings of contact i and its neighbours of which the pressure is given, all together.
    pub(super) fn coupled(&self, i: usize, zeta: f64) -> f64 {
        -self.known_neighbours(i).map(|(coupling, _)| self.problem.kernel.coupling(coupling, zeta)).sum::<f64>()
    }

    /// The same times p̂/P − 1 of those pressures.
    pub(super) fn given(&self, i: usize, zeta: f64) -> f64 {
        let one = |(coupling, given): (usize, &Given)| {
            self.problem.kernel.coupling(coupling, zeta) * given.transform_minus_one(zeta)
        };
        -self.known_neighbours(i).map(one).sum::<f64>()
    }

    /// Pressures that are given next to contact i, and the laminates between.
    fn known_neighbours(&self, i: usize) -> impl Iterator<Item = (usize, &Given<'a>)> {
        let contact = self.contacts.start + i;
        let neighbours = [contact.checked_sub(1).map(|above| (above, above)), Some((contact + 1, contact))];
        let sides = &self.problem.sides;
        neighbours.into_iter().flatten().filter_map(|(other, coupling)| Some((coupling, sides.get(other)?.given()?)))
    }

    /// The coupling of contacts i and i + 1.
    pub(super) fn coupling(&self, i: usize, zeta: f64) -> f64 {
        -self.problem.kernel.coupling(self.contacts.start + i, zeta)
    }
}
