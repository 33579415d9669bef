//! The answer of the programme itself, of low accuracy: where there is no better one.
//!
//! Its pressures are constant on the elements of the grid, so it has no ends to be found and none that could be missed. What it
//! is worth is told by the elements next to the ends of its contacts, and by the grid before.
use crate::contact::answer::Answer;
use crate::contact::problem::accuracy::{COARSE, ENDLESS, SAFETY};
use crate::contact::problem::twin::Twin;
use crate::contact::problem::{Problem, Side, load};
use crate::numeric::largest;
use crate::solution::{Contact, Form, Interval, Stats, Strip, Warning, WarningCode};

use super::grid::Grid;
use super::{Cycle, FINE, LEAST_FORCE, UNRESOLVED, cycles};

/// Answers with a larger relative error are none.
const MOST_ERROR: f64 = 0.25;

/// Presses a punch or a given load: `None` if contacts are open next to the middle, or are known too badly.
pub(crate) fn answer(problem: &Problem, expected: &[f64], far: f64) -> Option<Answer> {
    let all = cycles(problem, expected, far, FINE);
    let found = |(i, contact): (usize, usize)| found(problem, contact, &all, i);
    let contacts = problem.unknown().enumerate().map(found).collect::<Option<Vec<_>>>()?;
    let elements = all.last()?.grid.elements();
    let message = format!(
        "accuracy about 1 %: Newton's method did not converge, so this is the solution of the quadratic programme with \
         constant pressures on each of {elements} elements (see troubleshooting: low accuracy)"
    );
    let warnings = vec![Warning::new(WarningCode::LowAccuracy, message)];
    let stats = Stats { modes: vec![elements; problem.contacts()], ..problem.kernel.stats() };
    Some(Answer {
        contacts,
        force: [1.0, 0.0],
        min_pressure: 0.0,
        min_gap: 0.0,
        rotations: Vec::new(),
        stats,
        warnings,
    })
}

/// What contact i of the programme, contact `contact` of the problem, is.
fn found(problem: &Problem, contact: usize, cycles: &[Cycle], i: usize) -> Option<Contact> {
    let [before, last] = cycles else { return None };
    let force: f64 = last.forces[i].iter().filter(|force| **force > 0.0).sum();
    if (force - 1.0).abs() > COARSE {
        return None;
    }
    let side = &problem.sides[contact];
    let parts = parts(last, i, side)?;
    let is_open = parts[0].left > 0.0;
    let middle = |round: &Cycle| round.pressure(i, 0);
    let change = if is_open || side.is_sharp() { 0.0 } else { SAFETY * (middle(before) - middle(last)).abs() };
    // next to nothing depends on ends that are not known better than the grid resolves them
    let lengths = parts.iter().map(|part| part.right_error / part.right).zip(&parts);
    let lengths = lengths.filter(|(_, part)| part.right_error <= last.resolution(part.right)).map(|(error, _)| error);
    // stiff layers wrapped round a punch may carry a pressure next to nothing about x = 0
    let worst = largest(lengths.chain([change / last.largest(i)]));
    // what is no number is no answer either
    if worst.is_nan() || worst > MOST_ERROR {
        return None;
    }
    let peak = match () {
        () if is_open => 0.0,
        () if side.is_sharp() => f64::INFINITY,
        () => middle(last) / force,
    };
    // elements well inside a contact are the same on all grids: no better than the coarse ones
    let middle = [peak, super::COARSE.ends * peak + change / force];
    Some(Contact::even(problem.interfaces[contact], &parts, &last.strips(i, force), middle))
}

/// Where contact i of the programme touches, from the middle outwards.
fn parts(last: &Cycle, i: usize, side: &Side) -> Option<Vec<Interval>> {
    let active = last.active().swap_remove(i);
    let corner = side.edge().filter(|_| side.is_flat());
    let error = |end: f64| if corner == Some(end) || end == 0.0 { 0.0 } else { last.resolution(end) };
    // an interval without end carries no force
    let active = if active.resolved.len() > 1 { active.resolved } else { active.separate };
    // a decaying contact is given as far as it carries one, and an end beyond is not known
    let end = last.decays(i);
    let parts = active.iter().filter(|[from, to]| to.is_finite() || *from < end).map(|[from, to]| {
        let right = if to.is_finite() { [*to, error(*to).max(to - end)] } else { [end, ENDLESS * end] };
        Interval::new([*from, error(*from)], right)
    });
    let mut parts: Vec<Interval> = parts.collect();
    // where bodies graze each other next to an end, the end may be anywhere
    let mut before = 0.0;
    for part in &mut parts {
        if let Some(grazed) = last.first_pressing(i, (before * part.left).sqrt(), part.left) {
            part.left_error = part.left_error.max(part.left - grazed);
        }
        before = part.right;
    }
    let first = parts.first_mut()?;
    // a gap about x = 0 counts if it is longer than artefacts of the grid
    if last.grid.edges().partition_point(|edge| *edge < first.left) <= 3 * UNRESOLVED {
        (first.left, first.left_error) = (0.0, 0.0);
    }
    Some(parts)
}

impl Cycle {
    /// On an element of contact i.
    fn pressure(&self, i: usize, e: usize) -> f64 {
        self.forces[i][e] / self.grid.resultant(e)
    }

    /// How far an end may be off since elements have a length.
    fn resolution(&self, end: f64) -> f64 {
        SAFETY * self.grid.width(end)
    }

    /// Where the first element of contact i begins that presses, between two places.
    fn first_pressing(&self, i: usize, from: f64, to: f64) -> Option<f64> {
        let within = (0..self.grid.elements()).map(|e| (e, self.grid.element(e)));
        let mut pressing =
            within.filter(|(e, [start, end])| *start >= from && *end <= to && self.forces[i][*e] >= LEAST_FORCE);
        pressing.next().map(|(_, [start, _])| start)
    }

    fn largest(&self, i: usize) -> f64 {
        (0..self.grid.elements()).map(|e| self.pressure(i, e)).fold(0.0, f64::max)
    }

    /// The pressures of contact i, element by element, over its resultant.
    fn strips(&self, i: usize, force: f64) -> Vec<Strip> {
        if self.grid.twin() == Twin::Round {
            return self.discs(i, force);
        }
        let pressing = self.forces[i].iter().enumerate().filter(|(_, force)| **force > 0.0);
        let strip = |(e, own): (usize, &f64)| {
            let [from, to] = self.grid.element(e);
            let (at, extent) = if from == 0.0 { (0.0, to) } else { (0.5 * (from + to), 0.5 * (to - from)) };
            let images = if from == 0.0 { 1.0 } else { 2.0 };
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

    /// Up to where contact i carries all but a small part of the force.
    fn decays(&self, i: usize) -> f64 {
        let mut left = 0.0;
        let outwards = self.forces[i].iter().enumerate().rev();
        let last = outwards.map(|(e, force)| (e, force.max(0.0))).find(|(_, force)| {
            left += force;
            left > COARSE
        });
        last.map_or(0.0, |(e, _)| self.grid.element(e)[1])
    }
}

impl Grid {
    /// The longer of the elements that meet in an edge.
    fn width(&self, edge: f64) -> f64 {
        let next = self.edges().partition_point(|other| *other < edge);
        let around = next.saturating_sub(1)..(next + 2).min(self.edges().len());
        self.edges()[around].windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max)
    }
}
