//! How the intensities of the singular pressures at all ends change as ends move.
//!
//! Next to the answer all intensities vanish, each one depends on its own end only, and the pressure there tells how: that is where steps come from as long as
//! they lead on. Farther away, where a thin layer or a neighbour's end bends pressures near an end, derivatives are found from differences, and kept up to date by what
//! steps do (Broyden 1965).
use faer::Mat;
use faer::linalg::solvers::Solve;

use crate::contact::intervals::support::{End, Intervals};
use crate::contact::problem::accuracy::SLOW;
use crate::contact::problem::support::longest;
use crate::numeric::dot;

/// Steps, in half-lengths, from which derivatives are found.
const DIFFERENCE: f64 = 1e-4;
/// The longest step from derivatives, in half-lengths.
const LONGEST: f64 = 0.5;

/// The same where equations are factorised anew for each end: intensities change by as much over the thickness of a thin layer.
const DIFFERENCE_ANEW: f64 = 1e-5;
/// An end of which derivatives tell nothing moves at least so far, in half-lengths.
const SHORTEST: f64 = 0.1;

/// Derivatives of intensities by steps outwards, in half-lengths, if steps have led nowhere without.
#[derive(Default)]
pub(super) struct Derivatives {
    matrix: Option<Mat<f64>>,
    /// The last step, and the intensities before it.
    pub(super) taken: Vec<f64>,
    before: Vec<f64>,
    /// The largest intensity at all steps so far.
    largest: Vec<f64>,
}

impl Derivatives {
    /// Newton's steps in place of others, where both go the same way: the signs of intensities say which way, whatever derivatives do. Whether derivatives are known; `None`
    /// if they cannot be found.
    pub(super) fn improve(
        &mut self,
        support: &Intervals,
        q: &[f64],
        steps: &mut [f64],
        perturbed: impl FnMut(&Intervals) -> Option<Vec<f64>>,
    ) -> Option<bool> {
        self.update(support, q, perturbed)?;
        let Some(better) = self.steps(q) else { return Some(false) };
        let same_way = steps.iter_mut().zip(better).filter(|(step, better)| **step * better >= 0.0);
        same_way.for_each(|(step, better)| *step = better);
        Some(true)
    }

    /// The same with derivatives from equations that are factorised anew for each end, for all ends: factors of other ends are not accurate enough where a thin layer turns a
    /// small difference of two ends into a large one of pressures.
    pub(super) fn improve_anew(
        &mut self,
        support: &Intervals,
        q: &[f64],
        steps: &mut [f64],
        mut anew: impl FnMut(&Intervals) -> Option<Vec<f64>>,
    ) -> Option<bool> {
        self.largest.push(longest(q.iter().copied()));
        let [.., before, last] = self.largest[..] else { return Some(false) };
        if last > SLOW * before {
            let moves: Vec<f64> =
                anew(support)?.iter().zip(q).map(|(own, q)| if *q == 0.0 { 0.0 } else { *own }).collect();
            self.matrix = Some(differences(support, &moves, DIFFERENCE_ANEW, anew)?);
        }
        let Some(mut matrix) = self.matrix.clone() else { return Some(false) };
        let mut right = q.to_vec();
        let mut are_all = true;
        for (row, step) in steps.iter().enumerate() {
            // an intensity that hardly falls as its own end moves outwards, or rises, tells by its sign only which way that end is to go
            let is_lost = q[row] != 0.0 && LONGEST * -matrix[(row, row)] <= q[row].abs();
            are_all &= !is_lost;
            if is_lost {
                (0..q.len()).for_each(|column| matrix[(row, column)] = if row == column { 1.0 } else { 0.0 });
                right[row] = -q[row].signum() * step.abs().max(SHORTEST);
            }
        }
        let better = steps_of(matrix, &right)?;
        steps.copy_from_slice(&better);
        Some(are_all)
    }

    /// Takes note of intensities, 0 where an end stays where it is, and finds derivatives if these are needed, with the intensities of other lists.
    fn update(
        &mut self,
        support: &Intervals,
        q: &[f64],
        perturbed: impl FnMut(&Intervals) -> Option<Vec<f64>>,
    ) -> Option<()> {
        if let Some(matrix) = &mut self.matrix {
            let square = dot(&self.taken, &self.taken);
            let expected = &*matrix * column(&self.taken);
            for (row, (now, before)) in q.iter().zip(&self.before).enumerate() {
                let missed = if square > 0.0 { (now - before - expected[(row, 0)]) / square } else { 0.0 };
                self.taken.iter().enumerate().for_each(|(k, taken)| matrix[(row, k)] += missed * taken);
            }
        }
        self.before = q.to_vec();
        self.largest.push(longest(q.iter().copied()));
        // a step from derivatives is to do what two others do
        let back = if self.matrix.is_some() { 1 } else { 2 };
        let leads_on = |before: usize| self.largest[self.largest.len() - 1] <= SLOW * self.largest[before];
        if !(self.largest.len() - 1).checked_sub(back).is_none_or(leads_on) {
            self.matrix = Some(differences(support, q, DIFFERENCE, perturbed)?);
        }
        Some(())
    }

    /// Newton's steps; `None` where derivatives are not known.
    fn steps(&self, q: &[f64]) -> Option<Vec<f64>> {
        steps_of(self.matrix.clone()?, q)
    }
}

/// Newton's step outwards of each end, in half-lengths, shortened as a whole if it is too long.
fn steps_of(mut matrix: Mat<f64>, q: &[f64]) -> Option<Vec<f64>> {
    for row in (0..q.len()).filter(|row| q[*row] == 0.0) {
        (0..q.len()).for_each(|column| matrix[(row, column)] = if row == column { 1.0 } else { 0.0 });
    }
    let solved = matrix.partial_piv_lu().solve(column(q));
    let part = (LONGEST / longest(solved.col_as_slice(0).iter().copied())).min(1.0);
    let steps: Vec<f64> = solved.col_as_slice(0).iter().map(|step| -part * step).collect();
    steps.iter().all(|step| step.is_finite()).then_some(steps)
}

fn column(values: &[f64]) -> Mat<f64> {
    Mat::from_fn(values.len(), 1, |row, _| values[row])
}

/// Derivatives of intensities by ends, from a small step of each end that moves.
fn differences(
    support: &Intervals,
    q: &[f64],
    difference: f64,
    mut perturbed: impl FnMut(&Intervals) -> Option<Vec<f64>>,
) -> Option<Mat<f64>> {
    let mut matrix = Mat::zeros(q.len(), q.len());
    for (column, end) in support.ends().into_iter().enumerate().filter(|(column, _)| q[*column] != 0.0) {
        let half = support.0[end.interval].half;
        let mut by = vec![0.0; q.len()];
        by[column] = (difference * half).min(0.5 * support.gap(end).abs());
        let after = perturbed(&support.moved(&by))?;
        for (row, (after, before)) in after.iter().zip(q).enumerate().filter(|(_, (_, before))| **before != 0.0) {
            matrix[(row, column)] = (after - before) / (by[column] / half);
        }
    }
    Some(matrix)
}

impl Intervals {
    /// How much farther out each end is in another list, in half-lengths of this one.
    pub(super) fn steps_to(&self, after: &Self) -> Vec<f64> {
        let of = |end: End| end.side * (after.place(end) - self.place(end)) / self.0[end.interval].half;
        self.ends().into_iter().map(of).collect()
    }
}
