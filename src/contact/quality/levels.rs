//! Refinement levels: more and more modes, until the tolerance is met.
use crate::contact::ends::Converged;
use crate::contact::ends::newton::{Newton, Work};
use crate::contact::error::ContactError;
use crate::contact::integrals::layout::negligible;
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::{COARSE, SLOW};
use crate::contact::problem::modes::{COARSEST, FINEST, Modes, weight};
use crate::contact::problem::twin::Twin;
use crate::contact::quality::admissible;
use crate::contact::quality::estimates::{BEST, Level};
use crate::kernel::Kernel;
use crate::solution::Stopped;

/// Orders of the modes solved for, 2 per mode, reach this part of the turning point of the longest wave whose compliance is the
/// compliance of the layers at the faces of the contact alone.
const PER_WAVE: f64 = 0.6;
/// Where the first modes have failed before, the first steps have this many times more: next to thin, stiff coatings, and in
/// decaying contacts, few modes lead astray. With no more than at first some of these are missed; with twice as many, the first
/// steps take longer and find nothing else.
const FINER: usize = 8;
/// Modes next to a graded face for ten digits.
const GRADED: usize = 40;
/// Modes that sweeps add: half as many as are solved for, at least these.
const MORE: usize = 16;
/// So many more about an axis, where pressures are more peaked: without these many axisymmetric scenes miss ten digits by one, and
/// take a second level.
const ABOUT_AXIS: usize = 4;
/// What is known to begin with.
pub(crate) enum Start {
    /// Half-lengths from formulas: Newton's method may converge to a non-physical root, which is given up as soon as it shows.
    Guess { half_lengths: Vec<f64> },
    /// Half-lengths from the quadratic programme, or from another solution: the first steps are finer than usual.
    Cold { half_lengths: Vec<f64> },
}

/// The best level that was reached.
pub(crate) struct Refined {
    pub(crate) level: Level,
    /// The largest number of modes, if the tolerance is not met.
    pub(crate) not_met: Option<usize>,
}

/// Solves with more and more modes until the tolerance is met.
pub(crate) fn refine(problem: &Problem, start: Start, work: &mut Work) -> Result<Refined, ContactError> {
    let mut levels = Levels::new(problem, &start, work.clone());
    let refined = levels.run(start);
    *work = levels.newton.work;
    refined
}

/// The best level so far: where rounding prevails, more modes make errors larger.
#[derive(Default)]
struct Best {
    level: Option<Level>,
    /// Whether the last level has gained nothing.
    stalled: bool,
}

impl Best {
    /// Keeps a level if it is better; whether neither this one nor the one before has gained anything.
    fn keep(&mut self, level: Level) -> bool {
        let gains = self.level.as_ref().is_none_or(|best| level.worst_error() < SLOW * best.worst_error());
        let is_stuck = !gains && self.stalled;
        self.stalled = !gains;
        if self.level.as_ref().is_none_or(|best| level.is_better_than(best)) {
            self.level = Some(level);
        }
        is_stuck
    }
}

/// Numbers of modes from level to level.
struct Levels<'a> {
    newton: Newton<'a>,
    problem: &'a Problem<'a>,
    tolerance: f64,
    finest: usize,
    /// Modes of the coarse solution.
    coarse: Vec<usize>,
    /// Modes solved for, and all.
    solved: Vec<usize>,
    modes: Vec<usize>,
    /// Both numbers on the level before.
    before: (Vec<usize>, Vec<usize>),
    /// Next to a graded face modes fall like a power.
    graded: Vec<bool>,
}

impl<'a> Levels<'a> {
    fn new(problem: &'a Problem, start: &Start, work: Work) -> Self {
        let (Start::Guess { half_lengths } | Start::Cold { half_lengths }) = start;
        let n = half_lengths.len();
        let finest = FINEST.min(2 * FINEST / n);
        let mut solved = coarsest(problem.kernel, half_lengths, finest / 2);
        let finer = if matches!(start, Start::Cold { .. }) { FINER } else { 1 };
        let coarse = |modes: &usize| (modes / 2 * finer).min((FINEST / 8).min(finest)).max(COARSEST);
        let mut coarse: Vec<usize> = solved.iter().map(coarse).collect();
        solved.iter_mut().zip(&coarse).for_each(|(solved, coarse)| *solved = (*solved).max(*coarse));
        one_where_known(problem, &mut solved);
        one_where_known(problem, &mut coarse);
        let graded = (0..n).map(|i| !problem.kernel.asymptote(i).is_constant()).collect();
        let tolerance = problem.tolerance.max(BEST);
        let newton = Newton::new(problem, work);
        let before = (coarse.clone(), coarse.clone());
        Self { newton, problem, tolerance, finest, coarse, modes: solved.clone(), solved, before, graded }
    }

    fn run(&mut self, start: Start) -> Result<Refined, ContactError> {
        let (Start::Guess { half_lengths } | Start::Cold { half_lengths }) = start;
        let (mut half_lengths, rough) = self.newton.coarse(half_lengths, &self.coarse, self.tolerance)?;
        self.first(&rough);
        let mut fewer = self.coarse.clone();
        let mut best = Best::default();
        loop {
            let found = self.converge(&half_lengths, &fewer);
            let level = match found {
                Ok(found) => {
                    let mut level = Level::new(found, self.problem, negligible(self.tolerance));
                    level.doubt(&half_lengths);
                    level
                }
                // fewer modes more may be within the node budget
                Err(_) if self.newton.budget_exceeded && self.grow_less() => continue,
                // the node budget, or rounding, leaves the best level, or one of few digits
                Err(_) => match best.level {
                    Some(best) => return Ok(self.refined(best)),
                    None => return self.few_digits(half_lengths),
                },
            };
            if level.worst_error() <= self.tolerance {
                return Ok(self.refined(level));
            }
            self.give_up_early(&level, best.level.as_ref())?;
            self.before = (self.solved.clone(), self.modes.clone());
            let may_grow = self.grow(&level);
            fewer.clone_from(&level.counts);
            half_lengths.clone_from(&level.support.half_lengths);
            let is_stuck = best.keep(level);
            if (!may_grow || is_stuck)
                && let Some(best) = best.level.take()
            {
                return Ok(self.refined(best));
            }
        }
    }

    /// An error if more modes will not lead to an answer: with tension that is no truncation error, and after two levels without a
    /// digit.
    fn give_up_early(&self, level: &Level, best: Option<&Level>) -> Result<(), ContactError> {
        if level.swept.iter().all(|swept| *swept) {
            admissible::check_pressures(self.problem, level, f64::INFINITY)?;
        } else {
            admissible::check_gross_tension(self.problem, level)?;
        }
        let knows_nothing = |level: &Level| level.worst_error() > 1.0;
        if knows_nothing(level) && best.is_some_and(knows_nothing) {
            return Err(self.problem.not_converged(&level.support.half_lengths));
        }
        Ok(())
    }

    /// Numbers of modes of the first level, after a coarse solution.
    fn first(&mut self, coarse: &Modes) {
        let power = (1e-10 / self.tolerance).powf(1.0 / 6.0);
        let with_more = |(solved, coarse): (&usize, &Vec<f64>)| {
            self.with_more(*solved, self.tolerance).min(enough_modes(coarse, *solved, self.tolerance))
        };
        self.modes = self.solved.iter().zip(coarse).map(with_more).collect();
        one_where_known(self.problem, &mut self.modes);
        for i in self.problem.unknown().filter(|i| self.graded[*i]) {
            let wanted = ((GRADED + self.about_axis()) as f64 * power) as usize;
            if wanted > self.modes[i] {
                self.modes[i] = wanted.next_multiple_of(4).min(self.finest);
                self.solved[i] = self.solved[i].max((self.modes[i] / 3).next_multiple_of(4));
            }
        }
        self.match_singular();
    }

    /// Solves on one level.
    fn converge(&mut self, half_lengths: &[f64], fewer: &[usize]) -> Result<Converged, ContactError> {
        self.newton.budget_exceeded = false;
        let found = self.newton.converge(half_lengths.to_vec(), fewer, &self.solved, &self.modes, self.tolerance);
        self.newton.work.stopped.push(match &found {
            Ok(found) => found.stopped,
            Err(_) if self.newton.budget_exceeded => Stopped::Budget,
            Err(_) => Stopped::Diverged,
        });
        found
    }

    /// Half as many modes more than on the level before; whether a quarter is left for some contact.
    fn grow_less(&mut self) -> bool {
        let counts = [&mut self.solved, &mut self.modes].into_iter().zip([&self.before.0, &self.before.1]);
        let mut any = false;
        for (count, before) in counts.flat_map(|(counts, before)| counts.iter_mut().zip(before)) {
            let less = before + (count.saturating_sub(*before) / 2).next_multiple_of(4);
            any |= less < *count && 4 * less >= 5 * before;
            *count = less.min(*count);
        }
        any
    }

    /// A level of few digits, where the first level cannot be solved.
    fn few_digits(&mut self, half_lengths: Vec<f64>) -> Result<Refined, ContactError> {
        self.modes = self.coarse.iter().map(|solved| self.with_more(*solved, COARSE)).collect();
        one_where_known(self.problem, &mut self.modes);
        let found = self.newton.converge(half_lengths, &self.coarse, &self.coarse, &self.modes, COARSE)?;
        let fewer: Vec<usize> = self.coarse.iter().map(|modes| modes.div_ceil(2)).collect();
        let (coarse, _) = self.newton.coarse(found.support.half_lengths.clone(), &fewer, COARSE)?;
        let mut level = Level::new(found, self.problem, negligible(COARSE));
        level.doubt(&coarse);
        Ok(self.refined(level))
    }

    /// More modes where they make the error smaller; whether there are any.
    fn grow(&mut self, level: &Level) -> bool {
        let error = |i: usize| level.own_errors[i];
        let enough = |i: usize| error(i) <= 0.1 * self.tolerance;
        let wanted: Vec<usize> = (0..self.solved.len()).filter(|i| !enough(*i)).collect();
        if wanted.iter().all(|i| self.solved[*i] >= self.finest) {
            return false;
        }
        for i in wanted {
            // pressures for which sweeps converge need not be solved for, only continued
            let grown = match self.graded[i] && level.swept[i] {
                true => (error(i) / self.tolerance).powf(0.2).clamp(1.25, 2.0),
                false => 2.0,
            };
            // a contact of few modes costs next to nothing beside one of many
            let least = self.solved.iter().max().map_or(0, |largest| largest / 4);
            let grow = |count: usize| ((count as f64 * grown) as usize).max(least).next_multiple_of(4);
            let most = self.with_more(self.finest, self.tolerance);
            self.solved[i] = grow(self.solved[i]).min(self.finest);
            self.modes[i] = grow(self.modes[i]).max(self.with_more(self.solved[i], self.tolerance)).min(most);
        }
        self.match_singular();
        true
    }

    /// A punch that is not smooth excites all modes of the contact below: both contacts have as many.
    fn match_singular(&mut self) {
        for (i, _) in self.problem.sides.iter().enumerate().filter(|(_, side)| !side.is_smooth()) {
            for counts in [&mut self.solved, &mut self.modes] {
                counts[i] = counts.get(i + 1).map_or(counts[i], |below| counts[i].max(*below));
            }
        }
    }

    /// Modes that are solved for, and those that sweeps add.
    fn with_more(&self, solved: usize, tolerance: f64) -> usize {
        let more = MORE + self.about_axis();
        solved + (solved / 2).max(if tolerance < COARSE { more } else { more / 2 })
    }

    /// By how many modes more axisymmetric problems begin.
    fn about_axis(&self) -> usize {
        if self.problem.twin() == Twin::Round { ABOUT_AXIS } else { 0 }
    }

    fn refined(&self, level: Level) -> Refined {
        let modes = self.modes.iter().max().copied().unwrap_or(0);
        let not_met = (level.worst_error() > self.tolerance).then_some(modes);
        Refined { level, not_met }
    }
}

/// The transform of a given pressure is known: it counts as one mode.
fn one_where_known(problem: &Problem, counts: &mut [usize]) {
    counts.iter_mut().enumerate().filter(|(i, _)| problem.is_known(*i)).for_each(|(_, count)| *count = 1);
}

/// All modes, where the last of the coarse solution are below the tolerance already: sweeps add a few only.
fn enough_modes(coarse: &[f64], solved: usize, tolerance: f64) -> usize {
    let last = weight(coarse, coarse.len().saturating_sub(2)..coarse.len());
    if last < tolerance { solved + MORE / 4 } else { usize::MAX }
}

/// Modes to begin with: enough to resolve waves so short that the layers at the faces alone make their compliance.
fn coarsest(kernel: &Kernel, half_lengths: &[f64], finest: usize) -> Vec<usize> {
    let modes = |(i, a): (usize, &f64)| {
        let wanted = (PER_WAVE * a * kernel.governed_by_faces(i)).min(finest as f64).max(COARSEST as f64);
        (wanted as usize).next_multiple_of(4)
    };
    half_lengths.iter().enumerate().map(modes).collect()
}
