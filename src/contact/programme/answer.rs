//! The answer of the programme itself, of low accuracy: where there is no better one.
//!
//! Its pressures are constant on the elements of the grid, so it has no ends to be found and none that could be missed. What it
//! is worth is told by the elements next to the ends of its contacts, and by the grid before.
use crate::contact::answer::Answer;
use crate::contact::problem::Expected;
use crate::contact::problem::accuracy::{COARSE, ENDLESS, SAFETY};
use crate::contact::problem::{Problem, load};
use crate::kernel::Kernel;
use crate::numeric::largest;
use crate::solution::{Contact, Form, Interval, Stats, Strip, Warning, WarningCode};

use super::grid::Grid;
use super::openings::interface;
use super::patch::Patch;
use super::{Cycle, FINE, LEAST_FORCE, UNRESOLVED, cycles, touching_on};

/// Presses punches or given loads: `None` if pressures are known too badly.
pub(crate) fn answer(problem: &Problem, kernel: &Kernel, expected: &[Expected], far: f64) -> Option<Answer> {
    let all = cycles(problem, kernel, expected, far, FINE);
    let [before, last] = &all[..] else { return None };
    let touching = touching_on(problem, last);
    let found = |(i, contact): (usize, usize)| found(problem, contact, &touching, [before, last], i);
    let (opened, others): (Vec<_>, Vec<_>) =
        problem.unknown().enumerate().partition(|(_, contact)| problem.is_opened(*contact));
    let contacts = others.into_iter().map(found).collect::<Option<Vec<_>>>()?;
    let closed = opened.into_iter().map(|(i, contact)| interface(problem, contact, [before, last], i));
    let closed = closed.collect::<Option<Vec<_>>>()?;
    let elements = last.grid.elements();
    let message = format!(
        "accuracy about 1 %: Newton's method did not converge, so this is the solution of the quadratic programme with \
         constant pressures on each of {elements} elements (see troubleshooting: low accuracy)"
    );
    let warnings = vec![Warning::new(WarningCode::LowAccuracy, message)];
    let stats = Stats { modes: vec![elements; problem.contacts()], ..problem.kernel.stats() };
    let rotations = if problem.is_even() { Vec::new() } else { rotations(problem, last) };
    Some(Answer { contacts, closed, force: [1.0, 0.0], min_pressure: 0.0, min_gap: 0.0, rotations, stats, warnings })
}

/// By how much the slope of the gap of each contact grows since bodies turn, under each punch.
fn rotations(problem: &Problem, last: &Cycle) -> Vec<Vec<f64>> {
    let mut found = last.rotations.iter();
    let of = |contact: usize| {
        let Some((all, each)) = found.next() else { return Vec::new() };
        let mut own = vec![*all; problem.groups(contact).len()];
        each.iter().for_each(|(punch, more)| own[*punch] += more);
        own
    };
    let known = problem.sides.len() - problem.unknown().count();
    (0..known).map(|_| Vec::new()).chain(problem.unknown().map(of)).collect()
}

/// The result for one contact on the last two grids: number i among the contacts whose pressures are unknown, number `contact` among all.
fn found(
    problem: &Problem,
    contact: usize,
    touching: &[Expected],
    [before, last]: [&Cycle; 2],
    i: usize,
) -> Option<Contact> {
    let force: f64 = last.solved.forces[i].iter().filter(|force| **force > 0.0).sum();
    if (force - 1.0).abs() > COARSE {
        return None;
    }
    let (side, is_even) = (&problem.sides[contact], problem.is_even());
    let parts = parts(problem, contact, touching, last, i)?;
    if !is_even && find_no_room(problem, contact, &parts, &last.between) {
        return None;
    }
    let is_open = is_even && parts[0].0.left > 0.0;
    // where all is even, about x = 0, else in the middle of the interval that carries most
    let carried = |part: &Interval| last.carried(i, part);
    let widest = parts.iter().max_by(|a, b| carried(&a.0).total_cmp(&carried(&b.0)))?;
    let about = if is_even { 0.0 } else { 0.5 * (widest.0.left + widest.0.right) };
    let is_sharp = is_even && side.is_sharp();
    let middle = |cycle: &Cycle| cycle.pressure(i, cycle.grid.containing(about));
    let change = if is_open || is_sharp { 0.0 } else { SAFETY * (middle(before) - middle(last)).abs() };
    // next to nothing depends on ends that are not known better than the grid resolves them
    let lengths = parts.iter().map(|(part, _)| {
        let half = 0.5 * (part.right - part.left);
        // an interval far from where contacts are expected counts by its distance from there
        let size = |end: f64| if is_even { end } else { last.grid.distance(end).max(half) };
        let known = |(end, error): (f64, f64)| if error <= last.resolution(end) { error / size(end) } else { 0.0 };
        let left = if is_even { 0.0 } else { known((part.left, part.left_error)) };
        known((part.right, part.right_error)).max(left)
    });
    // stiff layers wrapped round a punch may carry a pressure next to nothing about x = 0
    let worst = largest(lengths.chain([change / last.largest(i)]));
    // what is no number is no answer either, nor what may be wrong by a quarter
    if worst.is_nan() || worst > 0.25 {
        return None;
    }
    let peak = match () {
        () if is_open => 0.0,
        () if is_sharp => f64::INFINITY,
        () => middle(last) / force,
    };
    // elements well inside a contact are the same on all grids: no better than the coarse ones
    let middle = [peak, super::COARSE.ends * peak + change / force];
    let (interface, strips) = (problem.interfaces[contact], last.strips(i, force));
    let (parts, punches): (Vec<Interval>, Vec<usize>) = parts.into_iter().unzip();
    Some(match is_even {
        true => Contact::even(interface, &parts, &strips, middle),
        false => Contact::new(interface, parts, strips, None, middle, punches),
    })
}

/// Whether intervals may have grown to the edge of a punch, or together under two punches, within their errors.
fn find_no_room(problem: &Problem, contact: usize, parts: &[(Interval, usize)], between: &[f64]) -> bool {
    let outgrows = |(part, punch): &(Interval, usize)| {
        let [left, right] = problem.sides[contact].ends_of(*punch);
        let is_beyond = part.left - part.left_error <= left || part.right + part.right_error >= right;
        let is_cut_off = contact == 0 && (between.contains(&part.left) || between.contains(&part.right));
        is_cut_off || is_beyond && problem.corner(contact, *punch, 1.0).is_none()
    };
    let meet = |pair: &[(Interval, usize)]| {
        let [(left, first), (right, second)] = [pair[0], pair[1]];
        first != second && right.left - left.right <= left.right_error + right.left_error
    };
    parts.iter().any(outgrows) || parts.windows(2).any(meet)
}

/// The intervals of a contact with the numbers of their punches, from left to right, or from the middle outwards where all is even.
fn parts(
    problem: &Problem,
    contact: usize,
    touching: &[Expected],
    last: &Cycle,
    i: usize,
) -> Option<Vec<(Interval, usize)>> {
    let is_even = problem.is_even();
    // a decaying contact is given as far as it carries a force, and an end beyond is not known
    let [begin, end] = last.decays(i);
    // an interval without end carries no force
    let presses = |[from, to]: &[f64; 2]| (to.is_finite() || *from < end) && (from.is_finite() || *to > begin);
    let own = touching.iter().filter(|one| one.contact == contact && presses(&one.ends));
    let mut parts: Vec<(Interval, usize)> = Vec::new();
    let mut before = None;
    for Expected { punch, ends: [from, to], .. } in own {
        let corner = |side: f64| problem.corner(contact, *punch, side);
        let error = |side: f64, x: f64| if corner(side) == Some(x) { 0.0 } else { last.resolution(x) };
        let right = if to.is_finite() { [*to, error(1.0, *to).max(to - end)] } else { [end, ENDLESS * (end - begin)] };
        let left = match from.is_finite() {
            true if *from == 0.0 && is_even => [0.0; 2],
            true if is_even => [*from, error(-1.0, *from)],
            true => [*from, error(-1.0, *from).max(begin - from)],
            false => [begin, ENDLESS * (end - begin)],
        };
        let mut own = Interval::new(left, right);
        // where bodies graze each other next to an end, the end may be anywhere
        let middle = match before.replace(own.right) {
            None if is_even => 0.0,
            None => own.left,
            Some(before) if is_even => (before * own.left).sqrt(),
            Some(before) => 0.5 * (before + own.left),
        };
        if let Some(grazed) = last.first_pressing(i, middle, own.left) {
            own.left_error = own.left_error.max(own.left - grazed);
        }
        parts.push((own, *punch));
    }
    let (first, _) = parts.first_mut()?;
    // a gap about x = 0 counts if it is longer than artefacts of the grid
    if is_even && last.grid.edges().partition_point(|edge| *edge < first.left) <= 3 * UNRESOLVED {
        (first.left, first.left_error) = (0.0, 0.0);
    }
    Some(parts)
}

impl Cycle {
    /// On an element of contact i.
    pub(super) fn pressure(&self, i: usize, e: usize) -> f64 {
        self.solved.forces[i][e] / self.grid.carried(e)[0]
    }

    /// The force of contact i on an interval.
    fn carried(&self, i: usize, Interval { left, right, .. }: &Interval) -> f64 {
        let within = |e: &usize| self.grid.element(*e)[0] >= *left && self.grid.element(*e)[1] <= *right;
        (0..self.grid.elements()).filter(within).map(|e| self.solved.forces[i][e]).sum()
    }

    /// How far an end may be off since elements have a length: where nothing is even an interval may have moved by as much as it may be longer.
    pub(super) fn resolution(&self, end: f64) -> f64 {
        let times = if self.grid.patch() == Patch::Strip { 2.0 } else { 1.0 };
        times * SAFETY * self.grid.width(end)
    }

    /// Where the first element of contact i begins that presses, between two places.
    fn first_pressing(&self, i: usize, from: f64, to: f64) -> Option<f64> {
        let within = (0..self.grid.elements()).map(|e| (e, self.grid.element(e)));
        let mut pressing =
            within.filter(|(e, [start, end])| *start >= from && *end <= to && self.solved.forces[i][*e] >= LEAST_FORCE);
        pressing.next().map(|(_, [start, _])| start)
    }

    fn largest(&self, i: usize) -> f64 {
        (0..self.grid.elements()).map(|e| self.pressure(i, e)).fold(0.0, f64::max)
    }

    /// The pressures of contact i, element by element, over its resultant.
    fn strips(&self, i: usize, force: f64) -> Vec<Strip> {
        if self.grid.patch() == Patch::Ring {
            return self.discs(i, force);
        }
        let pressing = self.solved.forces[i].iter().enumerate().filter(|(_, force)| **force > 0.0);
        let strip = |(e, own): (usize, &f64)| {
            let [from, to] = self.grid.element(e);
            let is_pair = self.grid.patch() == Patch::Pair;
            let (at, extent) = if from == 0.0 && is_pair { (0.0, to) } else { (0.5 * (from + to), 0.5 * (to - from)) };
            let images = if from == 0.0 || !is_pair { 1.0 } else { 2.0 };
            load::strip(Form::Uniform, at, extent, own / force / images)
        };
        pressing.map(strip).collect()
    }

    /// The same as discs, one for each step of the pressure from an element to the next.
    fn discs(&self, i: usize, force: f64) -> Vec<Strip> {
        let pressure = |e: usize| if e < self.grid.elements() { self.pressure(i, e).max(0.0) / force } else { 0.0 };
        let steps = (0..self.grid.elements()).map(|e| (self.grid.element(e)[1], pressure(e) - pressure(e + 1)));
        steps.filter(|(_, step)| *step != 0.0).map(|(radius, step)| load::disc(radius, step)).collect()
    }

    /// From where to where contact i carries all but a small part of the force on either side; of what is even from the middle on.
    fn decays(&self, i: usize) -> [f64; 2] {
        let outermost = |inwards: Vec<usize>| {
            let mut left = 0.0;
            inwards.into_iter().find(|e| {
                left += self.solved.forces[i][*e].max(0.0);
                left > COARSE
            })
        };
        let all = 0..self.grid.elements();
        let end = outermost(all.clone().rev().collect()).map_or(0.0, |e| self.grid.element(e)[1]);
        let is_even = self.grid.patch() != Patch::Strip;
        let begin = if is_even { None } else { outermost(all.collect()) };
        [begin.map_or(0.0, |e| self.grid.element(e)[0]), end]
    }
}

impl Grid {
    /// The element at x.
    pub(super) fn containing(&self, x: f64) -> usize {
        self.edges().partition_point(|edge| *edge <= x).clamp(1, self.elements()) - 1
    }

    /// The longer of the elements that meet in an edge.
    fn width(&self, edge: f64) -> f64 {
        let next = self.edges().partition_point(|other| *other < edge);
        let around = next.saturating_sub(1)..(next + 2).min(self.edges().len());
        self.edges()[around].windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max)
    }
}
