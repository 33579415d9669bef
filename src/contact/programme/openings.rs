//! Where layers that weights press together are apart in the answer of the programme.
use std::f64::consts::PI;

use crate::contact::problem::accuracy::SAFETY;
use crate::contact::problem::{Problem, Side};
use crate::solution::{ClosedInterface, Opening, Strip};

use super::patch::Patch;
use super::{COARSE, Cycle, parts};

/// Terms of the slope of a gap, as many as elements tell at least.
const TERMS: usize = 24;

/// One element in the whole plane: from where to where it is, its gap, and whether layers are apart there.
type Element = ([f64; 2], f64, bool);

/// The interface of a contact whose layers lie on each other but for openings, number i among the contacts whose pressures are unknown, on the last two grids; `None` if an opening has no end.
pub(super) fn interface(problem: &Problem, contact: usize, cycles: [&Cycle; 2], i: usize) -> Option<ClosedInterface> {
    let Side::Openings(pressed) = &problem.sides[contact] else { return None };
    let (x, last) = (-problem.origin, cycles[1]);
    let elements = last.elements(i);
    let is_apart = |own: &Element| own.2;
    if elements.first().is_some_and(is_apart) || elements.last().is_some_and(is_apart) {
        return None;
    }
    let within = |[from, to]: [f64; 2]| {
        let run = |x: f64| elements.partition_point(|own| own.0[1] <= x);
        last.opening(&elements[run(from)..run(to)])
    };
    let listed: Vec<bool> = last.solved.touching[i].iter().map(|touches| !touches).collect();
    let right = parts(&listed, &last.grid);
    let is_even = last.grid.patch() != Patch::Strip;
    let both = |[from, to]: [f64; 2]| if from == 0.0 { [-to, to] } else { [from, to] };
    let left = right.iter().rev().filter(|ends| is_even && ends[0] > 0.0).map(|[from, to]| [-to, -from]);
    let all = left.chain(right.iter().map(|ends| if is_even { both(*ends) } else { *ends }));
    let (openings, slopes): (Vec<Opening>, Vec<Strip>) = all.map(within).unzip();
    let is_open = openings.iter().any(|own| own.left <= x && x <= own.right);
    let pressure = |cycle: &Cycle, e: usize| {
        let [from, to] = cycle.grid.element(e);
        pressed.at(0.5 * (from + to)) + cycle.pressure(i, e)
    };
    let central = |cycle: &Cycle| {
        let x = if cycle.grid.patch() == Patch::Strip { x } else { x.abs() };
        if is_open { 0.0 } else { pressure(cycle, cycle.grid.containing(x)) }
    };
    let [before, central] = cycles.map(central);
    let smallest = (0..last.grid.elements()).min_by(|a, b| pressure(last, *a).total_cmp(&pressure(last, *b)))?;
    let [from, to] = last.grid.element(smallest);
    let end = openings.last().map(|own| (0.0, own.right));
    let (smallest_pressure, smallest_at) = end.unwrap_or((pressure(last, smallest), 0.5 * (from + to)));
    Some(ClosedInterface {
        interface: problem.interfaces[contact],
        weight: pressed.weight,
        central_pressure: central,
        central_pressure_error: last.error(before, central),
        smallest_pressure,
        smallest_at,
        openings,
        slopes,
    })
}

impl Cycle {
    /// All elements of contact i from left to right; of what is even with their mirror images.
    fn elements(&self, i: usize) -> Vec<Element> {
        let of = |e: usize| (self.grid.element(e), self.solved.gaps[i][e], !self.solved.touching[i][e]);
        let right = (0..self.grid.elements()).map(of);
        let mirrored = right.clone().rev().filter(|_| self.grid.patch() != Patch::Strip);
        mirrored.map(|([from, to], gap, is_apart)| ([-to, -from], gap, is_apart)).chain(right).collect()
    }

    /// An opening over some elements, and the slope of its gap: the gap is linear between the middles of elements, and zero at the ends.
    fn opening(&self, elements: &[Element]) -> (Opening, Strip) {
        let (left, right) = (elements[0].0[0], elements[elements.len() - 1].0[1]);
        let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
        let inside = elements.iter().map(|([from, to], gap, _)| (0.5 * (from + to), gap.max(0.0)));
        let places: Vec<(f64, f64)> = [(left, 0.0)].into_iter().chain(inside).chain([(right, 0.0)]).collect();
        let angle = |x: f64| ((x - middle) / half).clamp(-1.0, 1.0).acos();
        // each term less, so that what is cut off does not show as waves
        let term = |n: usize| {
            let of = |pair: &[(f64, f64)]| {
                let [(from, before), (to, after)] = [pair[0], pair[1]];
                let order = n as f64;
                (after - before) / (to - from) * ((order * angle(to)).cos() - (order * angle(from)).cos()) / order
            };
            let fades = (0.5 * PI * n as f64 / TERMS as f64).cos().powi(2);
            2.0 / PI * fades * places.windows(2).map(of).sum::<f64>()
        };
        let odd = |n: &usize| n % 2 == 1;
        // a gap that closes has no first term
        let coefficients = [0.0].into_iter().chain((2..TERMS).filter(odd).map(term)).collect();
        let skew = (2..TERMS).filter(|n| !odd(n)).map(term).collect();
        let (largest_gap_at, largest_gap) =
            places.iter().copied().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or_default();
        let error = |x: f64| self.resolution(if self.grid.patch() == Patch::Strip { x } else { x.abs() });
        let (left_error, right_error) = (error(left), error(right));
        let own = Opening { left, right, left_error, right_error, largest_gap, largest_gap_at };
        (own, Strip { at: middle, skew, ..Strip::series(half, coefficients) })
    }

    /// The error of a pressure well inside a contact, from the grid before.
    fn error(&self, before: f64, pressure: f64) -> f64 {
        COARSE.ends * pressure.abs() + SAFETY * (before - pressure).abs()
    }
}
