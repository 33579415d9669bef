//! How the intensities of the singular pressures at all ends change as ends move.
//!
//! Next to the answer all intensities vanish, each one depends on its own end only, and the pressure there tells how: these are the steps as long as they lead
//! on. Farther away, where a thin layer or a neighbour's end bends pressures near an end, derivatives are found from differences.
use faer::Mat;
use faer::linalg::solvers::Solve;

use crate::contact::intervals::support::{End, Intervals};
use crate::contact::problem::accuracy::SLOW;
use crate::contact::problem::support::longest;

/// Steps to both sides, in half-lengths, from which derivatives are found: what stretches a thin layer grows with the square of a step, and drops out of the difference.
const DIFFERENCE: f64 = 1e-6;
/// The longest step from derivatives, in half-lengths.
const LONGEST: f64 = 0.5;
/// An end of which derivatives tell nothing moves at least so far, in half-lengths.
const SHORTEST: f64 = 0.1;

/// Derivatives of intensities by steps outwards, in half-lengths, if steps have led nowhere without.
#[derive(Default)]
pub(super) struct Derivatives {
    matrix: Option<Mat<f64>>,
    /// The largest intensity at all steps so far.
    largest: Vec<f64>,
}

impl Derivatives {
    /// Newton's steps in place of others, from the intensities of lists with one end moved, 0 where an end stays where it is. An end whose intensity hardly falls as that end moves outwards, or rises, goes
    /// the way its sign tells. `None` if derivatives cannot be found.
    pub(super) fn improve(
        &mut self,
        support: &Intervals,
        q: &[f64],
        steps: &mut [f64],
        perturbed: impl FnMut(&[Intervals; 2]) -> Option<[Vec<f64>; 2]>,
    ) -> Option<()> {
        self.largest.push(longest(q.iter().copied()));
        let [.., before, last] = self.largest[..] else { return Some(()) };
        if last > SLOW * before {
            self.matrix = Some(differences(support, q, perturbed)?);
        }
        let Some(mut matrix) = self.matrix.clone() else { return Some(()) };
        let mut right = q.to_vec();
        for (row, step) in steps.iter().enumerate() {
            let is_lost = q[row] != 0.0 && LONGEST * -matrix[(row, row)] <= q[row].abs();
            if is_lost || q[row] == 0.0 {
                (0..q.len()).for_each(|column| matrix[(row, column)] = if row == column { 1.0 } else { 0.0 });
                right[row] = if is_lost { -q[row].signum() * step.abs().max(SHORTEST) } else { 0.0 };
            }
        }
        let solved = matrix.partial_piv_lu().solve(Mat::from_fn(right.len(), 1, |row, _| -right[row]));
        let better = solved.col_as_slice(0);
        if better.iter().any(|step| !step.is_finite()) {
            return None;
        }
        let part = (LONGEST / longest(better.iter().copied())).min(1.0);
        steps.iter_mut().zip(better).for_each(|(step, better)| *step = part * better);
        Some(())
    }
}

/// Derivatives of intensities by ends, from a small step of each end that moves to both sides.
fn differences(
    support: &Intervals,
    q: &[f64],
    mut perturbed: impl FnMut(&[Intervals; 2]) -> Option<[Vec<f64>; 2]>,
) -> Option<Mat<f64>> {
    let mut matrix = Mat::zeros(q.len(), q.len());
    for (column, end) in support.ends().into_iter().enumerate().filter(|(column, _)| q[*column] != 0.0) {
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
    Some(matrix)
}

impl Intervals {
    /// How much farther out each end is in another list, in half-lengths of this one.
    pub(super) fn steps_to(&self, after: &Self) -> Vec<f64> {
        let of = |end: End| end.side * (after.place(end) - self.place(end)) / self.0[end.interval].half;
        self.ends().into_iter().map(of).collect()
    }
}
