//! The answer of the programme itself: few digits, where there is no better one.
//!
//! Its pressures are constant on the elements of the grid, so it has no ends to be found and none that could be missed. What it
//! is worth is told by the elements next to the ends of its contacts, and by the grid before.
use crate::contact::problem::load;
use crate::contact::problem::load::strip;
use crate::contact::problem::profile::Indentation;
use crate::contact::programme::compliances::Compliances;
use crate::contact::programme::grid::Grid;
use crate::contact::programme::{FINE, First, Round, Rounds, rounds};
use crate::contact::quality::estimate::ENDLESS;
use crate::contact::{in_parts, stats};
use crate::kernel::Kernel;
use crate::numeric::largest;
use crate::solution::{Contact, Form, Interface, Part, Solution, Stats};

/// Ends are right to so many elements.
const ELEMENTS: f64 = 3.0;
/// Pressures are wrong by so many times what the last grid has changed ...
const SAFETY: f64 = 2.0;
/// ... and by this part at least: elements well inside a contact are the same on all grids.
const LEAST_ERROR: f64 = 0.02;
/// Answers with a larger relative error are none.
const MOST_ERROR: f64 = 0.25;
/// A gap about the middle has more elements than these.
const OPEN: usize = 6;
/// Contacts that fade before they end are given up to where this part of the force is left.
const FADED: f64 = 1e-4;
/// Forces are those given to this part.
const RESULTANT: f64 = 1e-3;

/// Presses a punch or a given load: `None` if contacts are open next to the middle, or are known too badly.
pub(in crate::contact) fn answer(
    kernel: &Kernel,
    interfaces: &[Interface],
    punch: &Indentation,
    expected: &[f64],
    far: f64,
) -> Option<Solution> {
    let Rounds { first, rounds: all } = Rounds::new(kernel, punch, expected, far, FINE);
    let under_punch = |rounds: &[Round]| contact(kernel, punch, interfaces[0], rounds, 0);
    let (top, known) = match (first, punch.load()) {
        (First::Given(_), load) => {
            let (load, force) = (load?, punch.force * kernel.modulus() * kernel.length());
            (load::contact(load, interfaces[0], force, load::strips(load, force)), 1)
        }
        // a contact that is a line load to the others is found by itself
        (First::Short(a), _) => {
            let others = all.last()?;
            let alone = Compliances::of_first(kernel, |zeta| others.deficit(1, zeta));
            (under_punch(&rounds(&alone, punch, &[a], 0.0, false, FINE))?, 0)
        }
        (First::Unknown, _) => (under_punch(&all)?, 0),
    };
    let below = (1..interfaces.len()).map(|i| contact(kernel, punch, interfaces[i], &all, i - known));
    let mut contacts = vec![top];
    contacts.extend(below.collect::<Option<Vec<Contact>>>()?);
    let elements = all.last()?.grid.elements();
    let mut warnings = vec![format!(
        "no answer of more digits was found: pressures are constant on each of {elements} elements here, and the error \
         estimates say how much they tell"
    )];
    warnings.extend(in_parts(&contacts));
    Some(Solution {
        contacts,
        stack: None,
        force: punch.force * kernel.modulus() * kernel.length(),
        force_error: 0.0,
        min_pressure: 0.0,
        min_gap: 0.0,
        stats: Stats { modes: vec![elements; interfaces.len()], ..stats(kernel) },
        warnings,
    })
}

/// One contact in the units of the scene, contact i of the programme.
fn contact(kernel: &Kernel, punch: &Indentation, interface: Interface, rounds: &[Round], i: usize) -> Option<Contact> {
    let [before, last] = rounds else { return None };
    let force: f64 = last.forces[i].iter().filter(|force| **force > 0.0).sum();
    if (force - 1.0).abs() > RESULTANT {
        return None;
    }
    let length = kernel.length();
    let unit = kernel.modulus() * punch.force / force;
    let zones = last.zones().swap_remove(i);
    let is_first = interface == Interface::Punch;
    let corner = punch.flat().filter(|_| is_first);
    let error = |end: f64| if corner == Some(end) { 0.0 } else { ELEMENTS * last.grid.width(end) };
    // bodies that touch for ever do so without a force
    let zones = if zones.sure.len() > 1 { zones.sure } else { zones.apart };
    // as far as they do with one
    let fades = last.fades(i);
    let mut parts = zones.iter().filter(|[from, to]| to.is_finite() || *from < fades).map(|[from, to]| Part {
        from: from * length,
        from_error: error(*from) * length,
        to: if to.is_finite() { *to } else { fades } * length,
        to_error: if to.is_finite() { error(*to) } else { ENDLESS * fades } * length,
    });
    // a gap about the middle is one if it is longer than rounding may feign
    let open = |first: &Part| last.grid.edges().partition_point(|edge| edge * length < first.from) > OPEN;
    let first = parts.next().filter(|first| first.from == 0.0 || open(first))?;
    let parts: Vec<Part> = parts.collect();
    let mut strips = Vec::new();
    for (e, force) in last.forces[i].iter().enumerate().filter(|(_, force)| **force > 0.0) {
        let [from, to] = last.grid.element(e);
        let (at, extent) = if from == 0.0 { (0.0, to) } else { (0.5 * (from + to), 0.5 * (to - from)) };
        let images = if from == 0.0 { 1.0 } else { 2.0 };
        strips.push(strip(Form::Uniform, at * length, extent * length, unit * length * force / images));
    }
    let middle = |round: &Round| round.pressure(i, 0);
    let is_open = first.from > 0.0;
    let is_sharp = is_first && punch.is_sharp();
    let change = if is_open || is_sharp { 0.0 } else { SAFETY * (middle(before) - middle(last)).abs() };
    let lengths = [&first].into_iter().chain(&parts).map(|part| part.to_error / part.to);
    let lengths = lengths.filter(|error| *error < ENDLESS);
    // stiff sheets wrapped round a punch may press next to nothing about the middle
    let worst = largest(lengths.chain([change / last.largest(i)]));
    let peak_pressure = match () {
        () if is_open => 0.0,
        () if is_sharp => f64::INFINITY,
        () => unit * middle(last),
    };
    // what is no number is no answer either
    if worst.is_nan() || worst > MOST_ERROR {
        return None;
    }
    Some(Contact {
        interface,
        half_length: first.to,
        half_length_error: first.to_error,
        opening: first.from,
        opening_error: if is_open { first.from_error } else { 0.0 },
        peak_pressure,
        peak_pressure_error: if is_sharp { 0.0 } else { LEAST_ERROR * peak_pressure + unit * change },
        resultant: strips.iter().map(|strip| strip.resultant() * if strip.at == 0.0 { 1.0 } else { 2.0 }).sum(),
        strips,
        parts,
    })
}

impl Round {
    /// On an element of contact i.
    fn pressure(&self, i: usize, e: usize) -> f64 {
        let [from, to] = self.grid.element(e);
        self.forces[i][e] / (2.0 * (to - from))
    }

    fn largest(&self, i: usize) -> f64 {
        (0..self.grid.elements()).map(|e| self.pressure(i, e)).fold(0.0, f64::max)
    }

    /// Up to where contact i carries all but a small part of the force.
    fn fades(&self, i: usize) -> f64 {
        let mut left = 0.0;
        let outwards = self.forces[i].iter().enumerate().rev();
        let last = outwards.map(|(e, force)| (e, force.max(0.0))).find(|(_, force)| {
            left += force;
            left > FADED
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
