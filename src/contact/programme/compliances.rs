//! The kernels of the contacts whose pressures are unknown, as the programme sees them.
use std::ops::Range;

use crate::contact::problem::load::Given;
use crate::contact::problem::{Problem, Side};
use crate::contact::programme::constraints::{Carried, Constraint};
use crate::contact::programme::grid::Grid;
use crate::kernel::Kernel;

/// The kernels of some contacts, one below the other. What presses on their laminates from the next contact, above or
/// below, is given.
pub(super) struct Compliances<'a> {
    problem: &'a Problem<'a>,
    /// All layers that may come apart are laminates of their own in it.
    kernel: &'a Kernel,
    contacts: Range<usize>,
    /// Between which places one of several punches may press and the next one may.
    between: &'a [f64],
}

impl<'a> Compliances<'a> {
    pub(super) fn new(problem: &'a Problem<'a>, kernel: &'a Kernel, between: &'a [f64]) -> Self {
        let mut unknown = problem.unknown();
        let first = unknown.next().unwrap_or(problem.contacts());
        Self {
            problem,
            kernel,
            contacts: first..first + unknown.count() + usize::from(first < problem.contacts()),
            between,
        }
    }

    /// Whether layers lie on each other but for openings.
    pub(super) fn has_openings(&self) -> bool {
        self.contacts.clone().any(|contact| self.problem.is_opened(contact))
    }

    /// How many contacts there are.
    pub(super) fn contacts(&self) -> usize {
        self.contacts.len()
    }

    /// Number of the punch that may press on contact i at x, from the left; 0 between layers.
    fn punch(&self, i: usize, x: f64) -> usize {
        match self.problem.sides[self.contacts.start + i] {
            Side::Punches(_) if self.contacts.start + i == 0 => self.between.partition_point(|between| *between < x),
            _ => 0,
        }
    }

    /// The moment of all that presses on the stack, about x = 0; `None` if it is to be found.
    pub(super) fn moment(&self) -> Option<f64> {
        self.problem.groups(0).iter().map(|group| group.moment).sum()
    }

    /// What the pressure of contact i has to carry under each punch, or in all.
    pub(super) fn constraints(&self, i: usize, grid: &Grid) -> Vec<Constraint> {
        let weights = |moment: usize, group: Option<usize>| -> Vec<f64> {
            let middle = |e: usize| 0.5 * (grid.edges()[e] + grid.edges()[e + 1]);
            let belongs = |e: usize| group.is_none_or(|group| self.punch(i, middle(e)) == group);
            (0..grid.elements()).map(|e| if belongs(e) { grid.carried(e)[moment] } else { 0.0 }).collect()
        };
        let contact = self.contacts.start + i;
        let (mut all, is_even) = (Vec::new(), self.problem.is_even());
        let of = |kind: Carried, weights: Vec<f64>| Constraint { contact: i, weights, kind };
        for (number, group) in self.problem.groups(contact).into_iter().enumerate() {
            // weights are in equilibrium by themselves
            let share = if self.problem.is_opened(contact) { 1.0 } else { group.share };
            all.push(of(Carried::Resultant(share), weights(0, Some(number))));
            if let (0, Some(moment)) = (contact, group.moment.filter(|_| group.turns)) {
                all.push(of(Carried::Moment(number, moment), weights(1, Some(number))));
            }
        }
        if !is_even && (contact > 0 || self.moment().is_none()) {
            all.push(of(Carried::WholeMoment, weights(1, None)));
        }
        all
    }

    /// The height of what presses on contact i above its tip; `None` if it does not reach all of an element.
    pub(super) fn height(&self, i: usize, [from, to]: [f64; 2]) -> Option<impl Fn(f64) -> f64> {
        let side = &self.problem.sides[self.contacts.start + i];
        let punch = self.punch(i, 0.5 * (from + to));
        let [left, right] = side.ends_of(punch);
        (from >= left && to <= right).then_some(move |x: f64| side.height_above_tip(punch, x))
    }

    /// The pressure over what weights press with on each element of contact i that does not touch.
    pub(super) fn apart(&self, i: usize, grid: &Grid) -> Vec<f64> {
        let middle = |e: usize| 0.5 * (grid.edges()[e] + grid.edges()[e + 1]);
        match &self.problem.sides[self.contacts.start + i] {
            Side::Openings(closed) => (0..grid.elements()).map(|e| -closed.at(middle(e))).collect(),
            _ => vec![0.0; grid.elements()],
        }
    }

    /// What the kernel of contact i tends to for short waves.
    pub(super) fn limit(&self, i: usize) -> f64 {
        self.kernel.asymptote(self.contacts.start + i).limit
    }

    /// The kernel of contact i if its neighbours have the same pressure.
    pub(super) fn own(&self, i: usize, zeta: f64) -> f64 {
        self.limit(i) + self.kernel.remainder(self.contacts.start + i, zeta)
    }

    /// The couplings of contact i and its neighbours of which the pressure is given, all together.
    pub(super) fn coupled(&self, i: usize, zeta: f64) -> f64 {
        -self.known_neighbours(i).map(|(coupling, _)| self.kernel.coupling(coupling, zeta)).sum::<f64>()
    }

    /// The same times p̂/P − 1 of those pressures.
    pub(super) fn given(&self, i: usize, zeta: f64) -> f64 {
        let one =
            |(coupling, given): (usize, &Given)| self.kernel.coupling(coupling, zeta) * given.transform_minus_one(zeta);
        -self.known_neighbours(i).map(one).sum::<f64>()
    }

    /// The couplings times the odd transforms of the given pressures, less the transform of a pressure with the same moment, which is ζ + `beyond` per unit moment.
    pub(super) fn given_odd(&self, i: usize, zeta: f64, beyond: f64) -> f64 {
        let one = |(coupling, given): (usize, &Given)| {
            let less = given.odd_transform_less_moment(zeta) - given.moment * beyond;
            self.kernel.coupling(coupling, zeta) * less
        };
        self.known_neighbours(i).map(one).sum::<f64>()
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
        -self.kernel.coupling(self.contacts.start + i, zeta)
    }
}
