//! Starts for many loads on one stack: answers at fixed loads, and half-lengths between them by interpolation.
//!
//! Under a parabola x²/2R all half-lengths depend on R P alone. So a stack has one curve per contact, known at the points of
//! a table in ln RP, each of which is found when it is first needed: from formulas, like any answer, so that no number
//! depends on which loads came before, or on who found it.
use crate::contact::problem::accuracy::MINOR;
use std::sync::OnceLock;

use crate::contact::ends::newton::{Work, strongly_coupled};
use crate::contact::problem::Problem;
use crate::contact::problem::modes::Modes;
use crate::contact::quality::levels::{Refined, Start, refine};
use crate::contact::starts::formulas;
use crate::kernel::Kernel;
use crate::numeric::chebyshev::{barycentric_weights, interpolation_row};
use crate::options::Options;
use crate::scene::{Punch, Top};
use crate::solution::Interface;

/// Points are this far apart, in ln RP.
const APART: f64 = 0.25;
/// Number of points: loads from 1e-26 to 1e26, in the units of the stack.
const COUNT: usize = 480;
/// Points that an interpolation takes.
const POINTS: usize = 10;

/// The answers of one stack under parabolas.
#[derive(Debug)]
pub(crate) struct Table {
    points: Vec<OnceLock<Option<Entry>>>,
    nodes: Vec<f64>,
    weights: Vec<f64>,
}

/// Logarithms of the half-lengths, and the modes.
#[derive(Debug)]
struct Entry {
    lengths: Vec<f64>,
    modes: Modes,
}

/// Where a load lies in the table.
struct Neighbours<'a> {
    answers: Vec<&'a Entry>,
    /// What each of them contributes.
    row: [f64; POINTS],
}

impl Neighbours<'_> {
    fn half_length(&self, i: usize) -> f64 {
        let terms = self.answers.iter().zip(&self.row).map(|(answer, part)| part * answer.lengths[i]);
        terms.sum::<f64>().exp()
    }

    /// The larger that each mode of contact `i` is at the points on either side.
    fn modes(&self, i: usize) -> Vec<f64> {
        let [left, right] = [POINTS / 2 - 1, POINTS / 2].map(|k| &self.answers[k].modes[i]);
        left.iter().zip(right).map(|(left, right)| left.abs().max(right.abs())).collect()
    }
}

impl Default for Table {
    fn default() -> Self {
        let nodes: Vec<f64> = (0..POINTS).map(|k| k as f64).collect();
        let weights = barycentric_weights(&nodes);
        Self { points: (0..COUNT).map(|_| OnceLock::new()).collect(), nodes, weights }
    }
}

impl Table {
    /// How many numbers the answers have that were found.
    pub(crate) fn stored_numbers(&self) -> usize {
        let answers = self.points.iter().filter_map(|point| point.get()?.as_ref());
        answers.flat_map(|answer| &answer.modes).map(Vec::len).sum::<usize>() + self.points.len()
    }

    /// Half-lengths and modes to start from; `None` where formulas have to do.
    pub(crate) fn start(&self, problem: &Problem) -> Option<Start> {
        let (i, punch) = problem.profiles().next()?;
        let kernel = problem.kernel;
        let flat = punch.as_parabola(0.0)?;
        let mut place = self.place(kernel, flat)?;
        for _ in 0..if punch.is_parabola() { 0 } else { 2 } {
            let load = punch.as_parabola(place.half_length(i))?;
            if !load.is_finite() || (load / flat - 1.0).abs() >= MINOR {
                return None;
            }
            place = self.place(kernel, load)?;
        }
        let contacts = kernel.contacts();
        let half_lengths: Vec<f64> = (0..contacts).map(|i| place.half_length(i)).collect();
        // what strongly coupled contacts miss is estimated from coarse answers
        let usable =
            half_lengths.iter().all(|a| a.is_normal()) && !strongly_coupled(kernel, &half_lengths).contains(&true);
        usable.then(|| Start::Warm { half_lengths, modes: (0..contacts).map(|i| place.modes(i)).collect() })
    }

    fn place(&self, kernel: &Kernel, load: f64) -> Option<Neighbours<'_>> {
        let at = load.ln() / APART + 0.5 * COUNT as f64;
        let first = (at.floor() as usize).checked_sub(POINTS / 2 - 1)?;
        let points = self.points.get(first..first + POINTS)?;
        let answers: Option<Vec<&Entry>> = points
            .iter()
            .zip(first..)
            .map(|(point, k)| point.get_or_init(|| entry(kernel, APART * (k as f64 - 0.5 * COUNT as f64))).as_ref())
            .collect();
        let mut row = [0.0; POINTS];
        interpolation_row(&self.nodes, &self.weights, at - first as f64, &mut row);
        Some(Neighbours { answers: answers?, row })
    }
}

/// The answer at one point; `None` if it is not as good as answers usually are.
fn entry(kernel: &Kernel, load: f64) -> Option<Entry> {
    let unit = kernel.length();
    let punch = Top::from(Punch::parabola(unit).ok()?);
    let interfaces = vec![Interface::Punch; kernel.contacts()];
    let force = load.exp() * kernel.modulus() * unit;
    let problem = Problem::new(kernel, &interfaces, &punch, force, Options::default().tolerance);
    let start = Start::Guess { half_lengths: formulas::half_lengths(&problem) };
    let Refined { level, not_met, .. } = refine(&problem, start, &mut Work::default()).ok()?;
    let lengths = level.support.half_lengths.iter().map(|a| a.ln()).collect();
    not_met.is_none().then_some(Entry { lengths, modes: level.modes })
}
