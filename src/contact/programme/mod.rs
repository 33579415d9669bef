//! The contact problem as a quadratic programme, solved coarsely.
//!
//! Of all pressures p ≥ 0 of the right resultants the true ones make the elastic energy plus the work against the
//! punch's profile least. With pressures constant on elements of one grid for all contacts that is a quadratic
//! programme: it always has one solution, whatever the start, and says where bodies touch, in one interval or in
//! several. Where weights press layers together pressures count from the closed state, and may be negative down to what presses there: elements that do not touch are openings.
mod active_set;
mod answer;
mod compliances;
mod constraints;
mod energy;
mod equilibrium;
mod grid;
mod openings;
mod patch;
#[cfg(test)]
mod tests;
mod waves;

use std::ops::Range;

use crate::contact::problem::Expected;
use crate::contact::problem::twin::Twin;
use crate::contact::problem::{Problem, Side, accuracy};
use crate::kernel::Kernel;
use active_set::{Programme, Solved};
use compliances::Compliances;
use energy::Energy;
use grid::Grid;
use patch::Patch;

pub(super) use answer::answer;

/// The grid reaches this many times as far as the longest contact is expected.
const REACH: f64 = 6.0;
/// For starts.
const COARSE: Resolution = Resolution { ends: 0.02, elements: 200, is_answer: false };
/// For answers.
const FINE: Resolution = Resolution { ends: 0.005, elements: 500, is_answer: true };
/// Contact intervals, and gaps between them, of no more than this many elements may be artefacts of the grid; as many elements on either
/// side of an end are refined.
const UNRESOLVED: usize = 2;

/// Intervals and gaps off the middle are no shorter than this part of their distance from there. Twice as much: ends of short intervals are
/// not resolved, and Newton's method does not find them.
const SHORTEST: f64 = 0.02;
/// A smaller part of the force on a contact is rounding. Ten times as much: intervals of re-contact are missed.
const LEAST_FORCE: f64 = 1e-8;
/// Intervals are next to each other, and one far from where contacts are expected, if the gap between them is shorter than this part of its distance from the middle.
const NEXT: f64 = 0.3;

/// How fine grids become.
#[derive(Clone, Copy)]
struct Resolution {
    /// Elements at the ends of contacts are as long as this part of their distance from the middle, or of a strip off it.
    ends: f64,
    /// Number of elements added to the first grid: with more, none are refined.
    elements: usize,
    /// Whether what is found is an answer: elements are as short, too, where a gap may open that is shorter than they are, and where bodies
    /// graze each other they count as apart.
    is_answer: bool,
}

/// The programme on one grid: which elements of each contact touch, and the forces on them.
struct Cycle {
    grid: Grid,
    solved: Solved,
    /// Between which places one of several punches may press and the next one may.
    between: Vec<f64>,
    /// By how much the slope of the gap of each contact grows since bodies turn, and how much more under some punches.
    rotations: Vec<(f64, Vec<(usize, f64)>)>,
}

/// Where all contacts touch, in one interval or in several, none further than the end of the grid, and where layers that lie on each other are apart; `expected` is where these are expected, to
/// make a grid for, and the grid reaches well beyond the distance `far` from x = 0. In the kernel all layers that may come apart are laminates of their own. `None` if the programme has
/// no solution in double precision.
pub(super) fn touching(problem: &Problem, kernel: &Kernel, expected: &[Expected], far: f64) -> Option<Vec<Expected>> {
    Some(touching_on(problem, cycles(problem, kernel, expected, far, COARSE).last()?))
}

/// The same on one grid; under several punches no interval goes on from one to the next.
fn touching_on(problem: &Problem, cycle: &Cycle) -> Vec<Expected> {
    let Cycle { grid, solved, .. } = cycle;
    let mut found = Vec::new();
    for (contact, listed) in problem.unknown().zip(&listed(problem, &solved.touching)) {
        let between = if problem.groups(contact).len() > 1 { &cycle.between[..] } else { &[] };
        for [from, to] in parts(listed, grid) {
            let inside = between.iter().copied().filter(|x| from < *x && *x < to);
            let ends: Vec<f64> = [from].into_iter().chain(inside).chain([to]).collect();
            found.extend(ends.windows(2).map(|pair| {
                let punch = between.partition_point(|between| *between < 0.5 * (pair[0] + pair[1]));
                Expected { contact, punch, ends: [pair[0], pair[1]] }
            }));
        }
    }
    found
}

/// Which elements are in intervals that are listed: where bodies touch, or where layers that lie on each other are apart.
fn listed(problem: &Problem, touching: &[Vec<bool>]) -> Vec<Vec<bool>> {
    let of = |(contact, touching): (usize, &Vec<bool>)| {
        touching.iter().map(|touches| *touches != problem.is_opened(contact)).collect()
    };
    problem.unknown().zip(touching).map(of).collect()
}

/// Places in the middle between contacts that are expected under punches next to each other.
fn between(expected: &[Expected]) -> Vec<f64> {
    let top: Vec<&Expected> = expected.iter().filter(|one| one.contact == 0).collect();
    let next = top.windows(2).filter(|pair| pair[0].punch != pair[1].punch);
    next.map(|pair| 0.5 * (pair[0].ends[1] + pair[1].ends[0])).collect()
}

/// The first grid: none where lengths are no positive numbers, or so different that there would be too many elements.
fn first_grid(problem: &Problem, expected: &[Expected], far: f64) -> Option<Grid> {
    let patch = match problem.twin() {
        Twin::Round => Patch::Ring,
        _ if problem.is_even() => Patch::Pair,
        _ => Patch::Strip,
    };
    let given = problem.sides.iter().filter_map(|side| side.given().map(|given| given.half_length));
    let ends = expected.iter().flat_map(|one| one.ends).map(f64::abs);
    let reach = REACH * given.chain(ends).fold(far.max(problem.last_fall()), f64::max);
    let half = |one: &Expected| 0.5 * (one.ends[1] - one.ends[0]);
    if patch != Patch::Strip {
        let shortest = expected.iter().map(half).fold(f64::INFINITY, f64::min);
        let edge: Vec<f64> = problem.sides.iter().filter_map(Side::edge).collect();
        return Grid::new(vec![[0.0, shortest]], [0.0, reach], &edge, patch);
    }
    let about = expected.iter().map(|one| [0.5 * (one.ends[0] + one.ends[1]), half(one)]).collect();
    let punches = expected.iter().filter(|one| one.contact == 0).map(|one| one.punch);
    let ends = punches.flat_map(|punch| problem.sides[0].ends_of(punch)).filter(|end| end.is_finite());
    let at: Vec<f64> = between(expected).into_iter().chain(ends).collect();
    Grid::new(about, [-reach, reach], &at, patch)
}

/// The last refinement cycles, two at most, with the finest grids.
fn cycles(problem: &Problem, kernel: &Kernel, expected: &[Expected], far: f64, resolution: Resolution) -> Vec<Cycle> {
    let mut between = between(expected);
    let mut cycles: Vec<Cycle> = Vec::new();
    // a prescribed traction is no unknown of the quadratic programme
    let is_known = problem.unknown().next().is_none();
    let Some(mut grid) = first_grid(problem, expected, far).filter(|_| !is_known) else { return cycles };
    let mut longer = 3;
    let most = grid.elements() + resolution.elements;
    // most grids are fine enough after a few
    for _ in 0..14 {
        let start = match cycles.last() {
            Some(coarse) => grid.inherit(&coarse.grid, &coarse.solved.touching),
            None => {
                let within: Vec<Vec<bool>> = problem.unknown().map(|contact| grid.within(expected, contact)).collect();
                listed(problem, &within)
            }
        };
        let Some(cycle) = Cycle::new((problem, kernel), &grid, start, &mut between, resolution) else { break };
        let listed = listed(problem, &cycle.solved.touching);
        let mut around: Vec<(usize, f64)> =
            listed.iter().flat_map(|listed| ends(listed, &grid, resolution.ends)).collect();
        if resolution.is_answer {
            let all = cycle.solved.touching.iter().zip(&cycle.solved.forces);
            let dips = all.flat_map(|(touching, forces)| dips(touching, forces, &grid));
            around.extend(dips.map(|edge| (edge, resolution.ends * grid.distance(grid.edges()[edge]))));
        }
        // an interval of re-contact that reaches the end of the grid does not end
        let last = grid.elements() - 1;
        let reaches_end = |listed: &Vec<bool>| listed[last] || grid.patch() == Patch::Strip && listed[0];
        let reaches_end = listed.iter().any(reaches_end);
        cycles.push(cycle);
        if cycles.len() > 2 {
            cycles.remove(0);
        }
        if longer > 0 && reaches_end {
            longer -= 1;
            grid = grid.longer(REACH);
        } else if grid.elements() > most || !grid.refine(&around) {
            break;
        }
    }
    cycles
}

impl Cycle {
    /// On a grid, from a guess of which elements touch; moves the places between which one of several punches may press and the next one may away from contacts that end there.
    fn new(
        (problem, kernel): (&Problem, &Kernel),
        grid: &Grid,
        mut start: Vec<Vec<bool>>,
        between: &mut [f64],
        resolution: Resolution,
    ) -> Option<Self> {
        let mut energy = Energy::new(&Compliances::new(problem, kernel, between), grid)?;
        let mut last: Option<Self> = None;
        for _ in 0..5 {
            let programme = Programme::new(&energy);
            let Some(mut solved) = programme.solve(start) else { break };
            let rotations = programme.rotations(&solved);
            let recede = problem.unknown().map(|contact| !problem.is_opened(contact));
            let all = recede.zip(solved.touching.iter_mut().zip(&solved.forces));
            for (_, (touching, forces)) in all.filter(|(recedes, _)| *recedes) {
                separate_where_unloaded(touching, forces);
                if resolution.is_answer {
                    separate_where_grazing(touching, forces, grid);
                }
            }
            let cycle = Self { grid: grid.clone(), between: between.to_vec(), rotations, solved };
            start = cycle.solved.touching.clone();
            let gives_way = cycle.gives_way(problem, between);
            last = Some(cycle);
            if !gives_way {
                break;
            }
            energy.press(&Compliances::new(problem, kernel, between), grid);
        }
        last
    }

    /// Moves each place between two punches where one of the contacts ends into the middle of the gap there; whether there were any.
    fn gives_way(&self, problem: &Problem, between: &mut [f64]) -> bool {
        if problem.groups(0).len() < 2 {
            return false;
        }
        let touching = intervals(&self.solved.touching[0], &self.grid);
        let mut moves = false;
        for x in between {
            let left = touching.iter().map(|own| own[1]).filter(|end| end <= x).fold(f64::NEG_INFINITY, f64::max);
            let right = touching.iter().map(|own| own[0]).filter(|end| end >= x).fold(f64::INFINITY, f64::min);
            if (left == *x) == (right == *x) {
                continue;
            }
            let middle = 0.5 * (left + right);
            let inside = self.grid.edges().iter().copied().filter(|edge| left < *edge && *edge < right);
            let nearest = inside.min_by(|a, b| (a - middle).abs().total_cmp(&(b - middle).abs()));
            moves |= nearest.is_some();
            *x = nearest.unwrap_or(*x);
        }
        moves
    }
}

/// Layers that lie on each other without a force: the sign of the pressure there is a rounding error, and they count as apart.
fn separate_where_unloaded(touching: &mut [bool], forces: &[f64]) {
    for run in runs(touching) {
        if forces[run.clone()].iter().sum::<f64>() < LEAST_FORCE {
            touching[run].fill(false);
        }
    }
}

/// The same where bodies graze each other next to an interval that presses: there elements touch in turns, in many intervals shorter than [`SHORTEST`], which are
/// artefacts of the grid.
fn separate_where_grazing(touching: &mut [bool], forces: &[f64], grid: &Grid) {
    let edges = grid.edges();
    let is_light = |run: &Range<usize>| forces[run.clone()].iter().sum::<f64>() < accuracy::COARSE;
    let is_short = |run: &Range<usize>| edges[run.end] - edges[run.start] < SHORTEST * grid.distance(edges[run.start]);
    let runs = runs(touching);
    for group in runs.chunk_by(|a, b| edges[b.start] - edges[a.end] < NEXT * grid.distance(edges[b.start])) {
        if group.iter().all(is_light) {
            continue;
        }
        for run in group.iter().filter(|run| is_light(run) && is_short(run)) {
            touching[run.clone()].fill(false);
        }
    }
}

/// Ends of contact intervals, and how long elements next to them may be: where there is a gap about x = 0, the intervals may be short.
fn ends(touching: &[bool], grid: &Grid, fine: f64) -> Vec<(usize, f64)> {
    let transitions = touching.windows(2).enumerate().filter(|(_, pair)| pair[0] != pair[1]).map(|(e, _)| e + 1);
    let strip = |edge: usize| {
        let outwards = touching[edge..].iter().take_while(|touches| **touches).count();
        let inwards = touching[..edge].iter().rev().take_while(|touches| **touches).count();
        grid.edges()[edge + outwards] - grid.edges()[edge - inwards]
    };
    let room = |edge: usize| {
        let (x, is_even) = (grid.distance(grid.edges()[edge]), grid.patch() != Patch::Strip);
        match strip(edge) {
            _ if is_even && touching[0] => x,
            strip if is_even => strip.clamp(SHORTEST * x, x),
            strip => 0.5 * strip,
        }
    };
    transitions.map(|edge| (edge, fine * room(edge))).collect()
}

/// The edges of the element of each interval with the least pressure, if that is less than half of the pressure on either side.
fn dips(touching: &[bool], forces: &[f64], grid: &Grid) -> Vec<usize> {
    let pressure = |e: usize| forces[e] / grid.carried(e)[0];
    let mut dips = Vec::new();
    for part in runs(touching) {
        let largest = |elements: Range<usize>| elements.map(pressure).fold(0.0, f64::max);
        let depth = |e: usize| pressure(e) / largest(part.start..e).min(largest(e + 1..part.end));
        let least = part.clone().map(|e| (e, depth(e))).min_by(|a, b| a.1.total_cmp(&b.1));
        dips.extend(least.filter(|(_, depth)| *depth < 0.5).into_iter().flat_map(|(e, _)| [e, e + 1]));
    }
    dips
}

/// Intervals of elements that touch; gaps that are short against what lies outside them are rounding, and where bodies graze each other far from where contacts are expected,
/// one interval begins and ends where these do.
fn parts(touching: &[bool], grid: &Grid) -> Vec<[f64; 2]> {
    let mut wide: Vec<[f64; 2]> = Vec::new();
    for part in intervals(touching, grid) {
        let longest_gap = |before: &[f64; 2]| {
            let is_expected = [*before, part].iter().any(|own| grid.is_about(*own));
            (if is_expected { SHORTEST } else { NEXT }) * grid.distance(part[0])
        };
        match wide.last_mut() {
            Some(before) if part[0] - before[1] < longest_gap(before) => before[1] = part[1],
            _ => wide.push(part),
        }
    }
    wide
}

/// Elements that touch, one after the other.
fn runs(touching: &[bool]) -> Vec<Range<usize>> {
    let mut next = 0;
    let runs = touching.chunk_by(|a, b| a == b).map(|run| {
        next += run.len();
        (run[0], next - run.len()..next)
    });
    runs.filter(|(touches, _)| *touches).map(|(_, run)| run).collect()
}

/// All intervals of elements that touch; one at the end of the grid does not end.
fn intervals(touching: &[bool], grid: &Grid) -> Vec<[f64; 2]> {
    let edges = grid.edges();
    let from = |start: usize| if start == 0 && grid.patch() == Patch::Strip { f64::NEG_INFINITY } else { edges[start] };
    let to = |end: usize| if end == touching.len() { f64::INFINITY } else { edges[end] };
    runs(touching).into_iter().map(|run| [from(run.start), to(run.end)]).collect()
}
