//! The contact problem as what it is, a convex programme, solved coarsely.
//!
//! Of all pressures p ≥ 0 of the right resultants the true ones make the elastic energy plus the work against the
//! punch's profile least. With pressures constant on elements of one grid for all contacts that is a quadratic
//! programme: it always has one solution, whatever the start, and says where bodies touch, in one interval or in
//! several.
mod energy;
mod grid;
mod programme;

use crate::kernel::Kernel;

use super::punch::Indentation;
use energy::Energy;
use grid::Grid;
use programme::Programme;

/// The grid reaches this many times as far as the longest contact is expected.
const REACH: f64 = 6.0;
/// And this much farther each time a contact reaches its end.
const FARTHER: f64 = 4.0;
/// At most so often.
const LONGER: usize = 3;
/// How often the grid is made longer or finer.
const ROUNDS: usize = 12;
/// Elements at the ends of contacts are as long as this part of their distance from the middle.
const FINE: f64 = 0.02;
/// Parts of a contact, and gaps between them, that are shorter than this many elements may be those of the grid.
const SURE: usize = 2;

/// Where one contact touches.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Zones {
    /// Intervals of x ≥ 0, in units of L, ascending.
    pub(super) parts: Vec<[f64; 2]>,
}

impl Zones {
    /// Whether bodies touch in one interval about the middle.
    pub(super) fn is_one(&self) -> bool {
        matches!(self.parts[..], [[start, _]] if start == 0.0)
    }

    /// Where the contact ends.
    pub(super) fn end(&self) -> f64 {
        self.parts.last().map_or(0.0, |part| part[1])
    }
}

/// Where all contacts touch, from the top down; `expected` are half-lengths to make a grid for. `None` if the programme
/// has no solution in double precision.
pub(super) fn zones(kernel: &Kernel, punch: &Indentation, expected: &[f64]) -> Option<Vec<Zones>> {
    let longest = expected.iter().fold(0.0, |longest: f64, a| longest.max(*a));
    let shortest = expected.iter().fold(f64::INFINITY, |shortest: f64, a| shortest.min(*a));
    let mut grid = Grid::new(shortest, REACH * longest);
    let mut found = None;
    let mut longer = LONGER;
    for _ in 0..ROUNDS {
        let energy = Energy::new(kernel, punch, &grid);
        let Some(touching) = Programme::new(&energy).solve() else { break };
        let zones: Vec<Zones> = touching.iter().map(|touching| Zones { parts: parts(touching, &grid) }).collect();
        let ends: Vec<usize> = touching.iter().flat_map(|touching| transitions(touching)).collect();
        found = Some(zones);
        // bodies that touch again far away do so for ever
        if longer > 0 && touching.iter().any(|touching| touching[grid.elements() - 1]) {
            longer -= 1;
            grid = grid.longer(FARTHER);
        } else if !grid.refine(&ends, FINE) {
            break;
        }
    }
    found
}

/// Elements before which bodies part or meet.
fn transitions(touching: &[bool]) -> impl Iterator<Item = usize> {
    touching.windows(2).enumerate().filter(|(_, pair)| pair[0] != pair[1]).map(|(e, _)| e + 1)
}

/// Intervals of elements that touch; what is too short to be sure of is left out.
fn parts(touching: &[bool], grid: &Grid) -> Vec<[f64; 2]> {
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
    let mut parts: Vec<[f64; 2]> = Vec::new();
    let mut before = false;
    for (e, touches) in sure.iter().enumerate() {
        let [from, to] = grid.element(e);
        match (before, touches, parts.last_mut()) {
            (true, true, Some(part)) => part[1] = if e + 1 == sure.len() { f64::INFINITY } else { to },
            (_, true, _) => parts.push([from, to]),
            _ => {}
        }
        before = *touches;
    }
    parts
}
