//! The contact problem as what it is, a convex programme, solved coarsely.
//!
//! Of all pressures p ≥ 0 of the right resultants the true ones make the elastic energy plus the work against the
//! punch's profile least. With pressures constant on elements of one grid for all contacts that is a quadratic
//! programme: it always has one solution, whatever the start, and says where bodies touch, in one interval or in
//! several.
mod answer;
mod energy;
mod equilibrium;
mod grid;
mod programme;
#[cfg(test)]
mod tests;

use crate::kernel::Kernel;

use super::punch::Indentation;
use energy::{Compliances, Energy};
use grid::Grid;
use programme::Programme;

pub(super) use answer::answer;

/// The grid reaches this many times as far as the longest contact is expected.
const REACH: f64 = 6.0;
/// And this much farther each time a contact reaches its end.
const FARTHER: f64 = 4.0;
/// At most so often.
const LONGER: usize = 3;
/// How often the grid is made longer or finer.
const ROUNDS: usize = 12;
/// Grids of more elements are not refined.
const MOST_ELEMENTS: usize = 200;
/// Elements at the ends of contacts are as long as this part of their distance from the middle.
const FINE: f64 = 0.02;
/// Parts of a contact, and gaps between them, that are shorter than this many elements may be those of the grid.
const SURE: usize = 2;

/// Bodies that touch again so many times farther from the middle than their contact ends do not seem to because of
/// rounding.
const FAR: f64 = 1.5;

/// Parts of the force on a contact that are smaller are rounding.
const LEAST_FORCE: f64 = 1e-8;

/// Gaps shorter than this part of where the contact outside them ends are none.
const NARROW: f64 = 0.05;

/// A contact under the punch that is expected to be this much shorter than all others, and than its body is thick, is a
/// line load to them.
const SHORT: f64 = 0.05;

/// Where one contact touches: intervals of x ≥ 0, in units of L, ascending.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Zones {
    /// All that are longer than the grid may feign.
    pub(super) sure: Vec<[f64; 2]>,
    /// That about the middle and all far from it, however short.
    pub(super) apart: Vec<[f64; 2]>,
}

impl Zones {
    /// Where the contact about the middle ends.
    pub(super) fn end(&self) -> f64 {
        self.sure.first().map_or(0.0, |part| part[1])
    }

    /// The contact about the middle, and from where to where bodies touch farther out, perhaps in several places.
    pub(super) fn hull(&self) -> Vec<[f64; 2]> {
        let parts = if self.sure.len() > 1 { &self.sure } else { &self.apart };
        match parts[..] {
            [first, second, .., last] => vec![first, [second[0], last[1]]],
            _ => parts.clone(),
        }
    }
}

/// The programme on one grid: which elements of each contact touch, and the forces on them.
struct Round {
    grid: Grid,
    touching: Vec<Vec<bool>>,
    forces: Vec<Vec<f64>>,
}

impl Round {
    fn zones(&self) -> Vec<Zones> {
        let zones = |touching: &Vec<bool>| Zones {
            sure: parts(&surely(touching), &self.grid),
            apart: apart(parts(touching, &self.grid)),
        };
        self.touching.iter().map(zones).collect()
    }
}

/// Where all contacts touch, from the top down; `expected` are half-lengths to make a grid for, and
/// `far` is a place that is to be well inside it. `None` if the programme
/// has no solution in double precision, or part of it is known.
pub(super) fn zones(kernel: &Kernel, punch: &Indentation, expected: &[f64], far: f64) -> Option<Vec<Zones>> {
    let known = short(kernel, expected);
    let all = Compliances { kernel, alone: false };
    let mut zones = rounds(&all, punch, expected, far, known).pop()?.zones();
    if let Some(a) = known {
        zones[0] = Zones { sure: vec![[0.0, a]], apart: vec![[0.0, a]] };
    }
    Some(zones)
}

/// The half-length expected under the punch, if that is a line load to all other contacts.
fn short(kernel: &Kernel, expected: &[f64]) -> Option<f64> {
    let top = kernel.laminates().first().map(|(thickness, _)| *thickness)?;
    expected[1..].iter().chain([&top]).all(|a| expected[0] < SHORT * a).then_some(expected[0])
}

/// The last rounds, two at most, with the finest grids. The half-length under the punch may be `known`, and far below that
/// of all others.
fn rounds(kernel: &Compliances, punch: &Indentation, expected: &[f64], far: f64, known: Option<f64>) -> Vec<Round> {
    let mut rounds: Vec<Round> = Vec::new();
    if punch.given().is_some() {
        return rounds;
    }
    let longest = expected.iter().fold(0.0, |longest: f64, a| longest.max(*a));
    let unknown = &expected[usize::from(known.is_some())..];
    let shortest = unknown.iter().fold(f64::INFINITY, |shortest: f64, a| shortest.min(*a));
    let mut grid = Grid::new(shortest, REACH * longest.max(far));
    let mut longer = LONGER;
    for _ in 0..ROUNDS {
        let mut energy = Energy::new(kernel, punch, &grid);
        if known.is_some() {
            // a line load about x = 0, however small the punch
            energy.barred.fill(true);
            energy.barred[0] = false;
        }
        let start = rounds.last().map(|coarse| grid.inherit(&coarse.grid, &coarse.touching));
        let Some((mut touching, forces)) = Programme::new(&energy).solve(start) else { break };
        touching.iter_mut().zip(&forces).for_each(|(touching, forces)| part_where_free(touching, forces));
        let looked_for = &touching[usize::from(known.is_some())..];
        let ends: Vec<usize> = looked_for.iter().flat_map(|touching| transitions(touching)).collect();
        // bodies that touch again far away do so for ever
        let reaches_end = touching.iter().any(|touching| touching[grid.elements() - 1]);
        rounds.push(Round { grid: grid.clone(), touching, forces });
        if rounds.len() > 2 {
            rounds.remove(0);
        }
        if longer > 0 && reaches_end {
            longer -= 1;
            grid = grid.longer(FARTHER);
        } else if grid.elements() > MOST_ELEMENTS || !grid.refine(&ends, FINE) {
            break;
        }
    }
    rounds
}

/// Layers that lie on each other without a force neither touch nor part: what rounding says of them is not to count.
fn part_where_free(touching: &mut [bool], forces: &[f64]) {
    let mut start = 0;
    while start < touching.len() {
        let length = touching[start..].iter().take_while(|touches| **touches == touching[start]).count();
        let part = start..start + length;
        if touching[start] && forces[part.clone()].iter().sum::<f64>() < LEAST_FORCE {
            touching[part].fill(false);
        }
        start += length;
    }
}

/// Elements before which bodies part or meet.
fn transitions(touching: &[bool]) -> impl Iterator<Item = usize> {
    touching.windows(2).enumerate().filter(|(_, pair)| pair[0] != pair[1]).map(|(e, _)| e + 1)
}

/// The same without what is too short to be sure of.
fn surely(touching: &[bool]) -> Vec<bool> {
    let mut sure = touching.to_vec();
    for wanted in [true, false] {
        let mut start = 0;
        while start < sure.len() {
            let length = sure[start..].iter().take_while(|touches| **touches == sure[start]).count();
            let inside = start + length < sure.len() && !(wanted && start == 0);
            if sure[start] == wanted && length <= SURE && inside {
                sure[start..start + length].fill(!wanted);
                start = 0;
            } else {
                start += length;
            }
        }
    }
    sure
}

/// The first interval and those far from it.
fn apart(mut parts: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let end = parts.first().map_or(0.0, |part| part[1]);
    parts.retain(|part| part[1] == end || part[0] > FAR * end);
    parts
}

/// Intervals of elements that touch; gaps that are short against what lies outside them are rounding.
fn parts(touching: &[bool], grid: &Grid) -> Vec<[f64; 2]> {
    let mut wide: Vec<[f64; 2]> = Vec::new();
    for part in intervals(touching, grid) {
        let end = if part[1].is_finite() { part[1] } else { part[0] };
        match wide.last_mut() {
            Some(before) if part[0] - before[1] < NARROW * end => before[1] = part[1],
            _ => wide.push(part),
        }
    }
    wide
}

/// All intervals of elements that touch.
fn intervals(touching: &[bool], grid: &Grid) -> Vec<[f64; 2]> {
    let mut parts: Vec<[f64; 2]> = Vec::new();
    let mut before = false;
    for (e, touches) in touching.iter().enumerate() {
        let [from, to] = grid.element(e);
        let to = if e + 1 == touching.len() { f64::INFINITY } else { to };
        match (before, touches, parts.last_mut()) {
            (true, true, Some(part)) => part[1] = to,
            (_, true, _) => parts.push([from, to]),
            _ => {}
        }
        before = *touches;
    }
    parts
}
