//! The answer of the programme itself: few digits, where there is no better one.
//!
//! Its pressures are constant on the elements of the grid, so it has no ends to be found and none that could be missed. What it
//! is worth is told by the elements next to the ends of its contacts, and by the grid before.
use crate::contact::given::strip;
use crate::contact::punch::Indentation;
use crate::contact::{in_parts, stats};
use crate::kernel::Kernel;
use crate::solution::{Contact, Form, Interface, Part, Solution, Stats};

use super::grid::Grid;
use super::{Round, rounds};

/// Ends are right to so many elements.
const ELEMENTS: f64 = 3.0;
/// Pressures are wrong by so many times what the last grid has changed ...
const SAFETY: f64 = 2.0;
/// ... and by this part at least.
const LEAST_ERROR: f64 = 0.01;
/// Answers with a larger relative error are none.
const MOST_ERROR: f64 = 0.25;
/// Forces are those given to this part.
const RESULTANT: f64 = 1e-3;

/// Presses a round punch: `None` if contacts are open about the middle, have no end, or are known too badly.
pub(in crate::contact) fn answer(
    kernel: &Kernel,
    interfaces: &[Interface],
    punch: &Indentation,
    expected: &[f64],
    far: f64,
) -> Option<Solution> {
    if punch.flat().is_some() || punch.is_sharp() {
        return None;
    }
    let rounds = rounds(kernel, punch, expected, far);
    let [before, last] = &rounds[..] else { return None };
    let contacts: Option<Vec<Contact>> = interfaces
        .iter()
        .enumerate()
        .map(|(i, interface)| contact(kernel, punch, *interface, i, last, before))
        .collect();
    let contacts = contacts?;
    let elements = last.grid.elements();
    let mut warnings = vec![format!(
        "no answer of more digits was found: pressures are constant on each of {elements} elements here, and the error \
         estimates say how much they tell"
    )];
    warnings.extend(in_parts(&contacts));
    Some(Solution {
        contacts,
        force: punch.force * kernel.modulus() * kernel.length(),
        force_error: 0.0,
        min_pressure: 0.0,
        min_gap: 0.0,
        stats: Stats { modes: vec![elements; interfaces.len()], ..stats(kernel) },
        warnings,
    })
}

/// One contact in the units of the scene.
fn contact(
    kernel: &Kernel,
    punch: &Indentation,
    interface: Interface,
    i: usize,
    last: &Round,
    before: &Round,
) -> Option<Contact> {
    let force: f64 = last.forces[i].iter().filter(|force| **force > 0.0).sum();
    if (force - 1.0).abs() > RESULTANT {
        return None;
    }
    let length = kernel.length();
    let unit = kernel.modulus() * punch.force / force;
    let zones = last.zones().swap_remove(i);
    let error = |end: f64| ELEMENTS * last.grid.width(end);
    // bodies that touch for ever do so without a force
    let zones = if zones.sure.len() > 1 { zones.sure } else { zones.apart };
    let mut parts = zones.iter().filter(|[_, to]| to.is_finite()).map(|[from, to]| Part {
        from: from * length,
        from_error: error(*from) * length,
        to: to * length,
        to_error: error(*to) * length,
    });
    let first = parts.next().filter(|first| first.from == 0.0)?;
    let parts: Vec<Part> = parts.collect();
    let mut strips = Vec::new();
    for (e, force) in last.forces[i].iter().enumerate().filter(|(_, force)| **force > 0.0) {
        let [from, to] = last.grid.element(e);
        let (at, extent) = if from == 0.0 { (0.0, to) } else { (0.5 * (from + to), 0.5 * (to - from)) };
        let images = if from == 0.0 { 1.0 } else { 2.0 };
        strips.push(strip(Form::Uniform, at * length, extent * length, unit * length * force / images));
    }
    let middle = |round: &Round| round.forces[i][0] / (2.0 * round.grid.element(0)[1]);
    let peak_pressure = unit * middle(last);
    let peak_error = LEAST_ERROR + SAFETY * (middle(before) / middle(last) - 1.0).abs();
    let lengths = [&first].into_iter().chain(&parts).map(|part| part.to_error / part.to);
    let worst = lengths.fold(peak_error, f64::max);
    // what is no number is no answer either
    if worst.is_nan() || worst > MOST_ERROR {
        return None;
    }
    Some(Contact {
        interface,
        half_length: first.to,
        half_length_error: first.to_error,
        peak_pressure,
        peak_pressure_error: peak_error * peak_pressure,
        resultant: strips.iter().map(|strip| strip.resultant() * if strip.at == 0.0 { 1.0 } else { 2.0 }).sum(),
        strips,
        parts,
    })
}

impl Grid {
    /// The longer of the elements that meet in an edge.
    fn width(&self, edge: f64) -> f64 {
        let next = self.edges().partition_point(|other| *other < edge);
        let around = next.saturating_sub(1)..(next + 2).min(self.edges().len());
        self.edges()[around].windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max)
    }
}
