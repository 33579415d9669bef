//! How the intensities of the singular pressures at all ends change as ends move.
//!
//! Next to the answer all intensities vanish, each one depends on its own end only, and the pressure there tells how: these are the steps as long as they lead
//! on. Farther away, where a thin layer or a neighbour's end bends pressures near an end, derivatives are found from differences: by ends of which the pressure
//! tells nothing, and by all where steps lead nowhere.
use std::rc::Rc;

use faer::Mat;
use faer::linalg::solvers::Solve;

use crate::contact::intervals::pressure;
use crate::contact::intervals::steps::Look;
use crate::contact::intervals::support::{End, Intervals};
use crate::contact::problem::accuracy::{MINOR, SLOW};
use crate::numeric::longest;

/// Steps to both sides, in half-lengths, from which derivatives are found: where a thin layer lies between two contacts, intensities have large parts that grow with the square of a step, and
/// drop out of the difference.
const DIFFERENCE: f64 = 1e-6;
/// The longest step from derivatives, in half-lengths.
const LONGEST: f64 = 0.5;
/// The longest step of an end that goes on and on, in half-lengths.
const FARTHEST: f64 = 2.0;
/// An end of which derivatives tell nothing moves at least so far, in half-lengths.
const SHORTEST: f64 = 0.1;

/// Derivatives of intensities by steps outwards, in half-lengths.
pub(super) struct Matrix {
    by: Mat<f64>,
    /// By which ends they are known.
    known: Vec<bool>,
    /// The largest intensity where they were found: what an end does to the intensities at others is as large as its own.
    of: f64,
}

/// What is known of how intensities change, and how far each end may move.
#[derive(Default)]
pub(super) struct Derivatives {
    pub(super) matrix: Option<Rc<Matrix>>,
    /// The largest intensity at all steps so far.
    largest: Vec<f64>,
    /// The last step of each end, and how far it may move, in half-lengths.
    taken: Vec<f64>,
    limits: Vec<f64>,
    /// The list before that step, and the intensities there.
    before: Option<(Intervals, Vec<f64>)>,
}

impl Derivatives {
    /// Newton's steps in place of others: of all ends where intensities, 0 where an end stays where it is, have not fallen to half at the last step, else of ends that the pressure sends as far
    /// outwards as it may. An end whose intensity hardly falls as that end moves outwards, or rises, goes the way its sign tells. No end moves farther than it may, and the others take the steps that go with that. `None` if there are no such steps.
    pub(super) fn improve(
        &mut self,
        support: &Intervals,
        looks: &[Look],
        steps: &mut [f64],
        perturbed: impl FnMut(&[Intervals; 2]) -> Option<[Vec<f64>; 2]>,
    ) -> Option<()> {
        let q = &intensities(looks, steps)[..];
        self.largest.push(longest(q.iter().copied()));
        let size = q.len();
        let is_slow = matches!(self.largest[..], [.., before, last] if last > SLOW * before);
        // an end that is as good as found keeps the derivatives that it has
        let largest = longest(q.iter().copied());
        let is_far = |end: usize| is_slow && q[end].abs() > MINOR * largest || steps[end] >= pressure::FARTHEST;
        let wanted: Vec<bool> = (0..size).map(|end| q[end] != 0.0 && is_far(end)).collect();
        if wanted.contains(&true) {
            let mut by = self.matrix.as_ref().map_or_else(|| Mat::zeros(size, size), |matrix| matrix.by.clone());
            differences(support, &wanted, q, perturbed, &mut by)?;
            let known = |end: usize| wanted[end] || self.matrix.as_ref().is_some_and(|matrix| matrix.known[end]);
            let known = (0..size).map(known).collect();
            self.matrix = Some(Rc::new(Matrix { by, known, of: largest }));
        } else {
            self.learn(support, q);
        }
        self.before = Some((support.clone(), q.to_vec()));
        let (mut matrix, mut right) = equations(self.matrix.as_deref(), looks, q, steps);
        let mut allowed = vec![LONGEST; size];
        if let Some(own) = &self.matrix {
            for row in (0..size).filter(|row| own.leads(*row, q) == Some(false) && !looks[*row].is_weak(f64::INFINITY))
            {
                // a contact much too short grows faster and faster
                let again = 2.0 * q[row].signum() * self.taken.get(row).unwrap_or(&0.0);
                right[(row, 0)] = q[row].signum() * steps[row].abs().max(SHORTEST).max(again);
                allowed[row] = if q[row] > 0.0 { FARTHEST } else { LONGEST };
            }
        }
        self.taken.resize(size, 0.0);
        self.limits.resize(size, LONGEST);
        for _ in 0..=size {
            let solved = matrix.partial_piv_lu().solve(&right);
            steps.copy_from_slice(solved.col_as_slice(0));
            let excess = |row: usize| steps[row].abs() / self.limit(row, steps[row], allowed[row]);
            let row = (0..size).max_by(|a, b| excess(*a).total_cmp(&excess(*b)))?;
            if excess(row) <= 1.0 + f64::EPSILON.sqrt() {
                break;
            }
            right[(row, 0)] = self.limit(row, steps[row], allowed[row]).copysign(steps[row]);
            (0..size).for_each(|column| matrix[(row, column)] = if row == column { 1.0 } else { 0.0 });
        }
        self.limits = steps.iter().enumerate().map(|(row, step)| self.limit(row, *step, allowed[row])).collect();
        self.taken = steps.to_vec();
        steps.iter().all(|step| step.is_finite()).then_some(())
    }

    /// Changes derivatives by what the step to this list did to intensities (Broyden 1965).
    fn learn(&mut self, support: &Intervals, q: &[f64]) {
        let (Some(matrix), Some((list, before))) = (&self.matrix, &self.before) else { return };
        let steps = list.steps_to(support);
        let square: f64 = steps.iter().map(|step| step * step).sum();
        let mut by = matrix.by.clone();
        let is_told = |row: &usize| square > 0.0 && matrix.known[*row] && q[*row] != 0.0 && before[*row] != 0.0;
        for row in (0..q.len()).filter(is_told) {
            let expected: f64 = steps.iter().enumerate().map(|(column, step)| by[(row, column)] * step).sum();
            let missed = (q[row] - before[row] - expected) / square;
            steps.iter().enumerate().for_each(|(column, step)| by[(row, column)] += missed * step);
        }
        self.matrix = Some(Rc::new(Matrix { by, known: matrix.known.clone(), of: matrix.of }));
    }

    /// How far an end may move in the direction of a step: steps back and forth grow shorter than the longest of the last ones, since ends depend on each other.
    fn limit(&self, row: usize, step: f64, allowed: f64) -> f64 {
        let longest = longest(self.taken.iter().copied());
        if step * self.taken[row] < 0.0 { 0.5 * longest } else { (2.0 * self.limits[row]).max(longest).min(allowed) }
    }
}

impl Matrix {
    /// Whether they were found where intensities were hardly larger than these.
    pub(super) fn serves(&self, looks: &[Look]) -> bool {
        MINOR * self.of < longest(looks.iter().map(|look| look.q))
    }

    /// Whether an intensity falls as its end moves outwards, and vanishes after no more than the longest step; `None` if that is not known, or there is none.
    fn leads(&self, row: usize, q: &[f64]) -> Option<bool> {
        (self.known[row] && q[row] != 0.0).then(|| LONGEST * -self.by[(row, row)] > q[row].abs())
    }

    /// Replaces the steps that pressures tell by Newton's steps; by infinite ones where an intensity is weak and does not vanish.
    pub(super) fn improve(&self, looks: &[Look], steps: &mut [f64]) {
        let q = intensities(looks, steps);
        let (matrix, right) = equations(Some(self), looks, &q, steps);
        steps.copy_from_slice(matrix.partial_piv_lu().solve(&right).col_as_slice(0));
        let stays = |row: &usize| self.leads(*row, &q) == Some(false) && looks[*row].is_weak(f64::INFINITY);
        (0..q.len()).filter(stays).for_each(|row| steps[row] = f64::INFINITY);
    }
}

/// The steps of all ends, Newton's where derivatives are known; none of those on which next to nothing depends.
pub(super) fn steps(looks: &[Look], derivatives: Option<&Matrix>) -> Vec<Option<f64>> {
    let mut steps: Vec<f64> = looks.iter().map(|look| look.step).collect();
    if let Some(derivatives) = derivatives {
        derivatives.improve(looks, &mut steps);
    }
    let strong = |(look, step): (&Look, f64)| (!look.is_weak(look.step) && !look.is_weak(step)).then_some(step);
    looks.iter().zip(steps).map(strong).collect()
}

/// The intensities at ends, none where next to nothing depends on the end.
fn intensities(looks: &[Look], steps: &[f64]) -> Vec<f64> {
    looks.iter().zip(steps).map(|(look, step)| if *step == 0.0 || look.is_weak(*step) { 0.0 } else { look.q }).collect()
}

/// The equations for steps: intensities vanish where their derivatives are known and lead on; else steps are these, or none where an intensity is weak.
fn equations(known: Option<&Matrix>, looks: &[Look], q: &[f64], steps: &[f64]) -> (Mat<f64>, Mat<f64>) {
    let size = q.len();
    let mut matrix = Mat::identity(size, size);
    let mut right = Mat::from_fn(size, 1, |row, _| steps[row]);
    for row in 0..size {
        match known.and_then(|own| own.leads(row, q).map(|leads| (own, leads))) {
            Some((own, true)) => {
                right[(row, 0)] = -q[row];
                (0..size).for_each(|column| matrix[(row, column)] = own.by[(row, column)]);
            }
            Some((_, false)) if looks[row].is_weak(f64::INFINITY) => right[(row, 0)] = 0.0,
            _ => {}
        }
    }
    (matrix, right)
}

/// Puts derivatives of intensities by some ends into their columns, from a small step of each of these to both sides.
fn differences(
    support: &Intervals,
    wanted: &[bool],
    q: &[f64],
    mut perturbed: impl FnMut(&[Intervals; 2]) -> Option<[Vec<f64>; 2]>,
    matrix: &mut Mat<f64>,
) -> Option<()> {
    for (column, end) in support.ends().into_iter().enumerate().filter(|(column, _)| wanted[*column]) {
        let half = support.0[end.interval].half;
        let by = (DIFFERENCE * half).min(0.5 * support.gap(end).abs());
        let moved = [by, -by].map(|by| {
            let mut all = vec![0.0; q.len()];
            all[column] = by;
            support.moved(&all)
        });
        let [outwards, inwards] = perturbed(&moved)?;
        for row in (0..q.len()).filter(|row| q[*row] != 0.0) {
            matrix[(row, column)] = (outwards[row] - inwards[row]) / (2.0 * by / half);
        }
    }
    Some(())
}

impl Intervals {
    /// How much farther out each end is in another list, in half-lengths of this one.
    pub(super) fn steps_to(&self, after: &Self) -> Vec<f64> {
        let of = |end: End| end.side * (after.place(end) - self.place(end)) / self.0[end.interval].half;
        self.ends().into_iter().map(of).collect()
    }
}
