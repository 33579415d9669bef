//! The force under which the contact of the punch has a prescribed half-length, or the punch has sunk by a prescribed depth.
//!
//! Both grow with the force: the logarithm of the force is found as a function of the logarithm of what is prescribed by the secant method, kept between
//! forces known to be too small and too large. A force at which the solver fails says nothing: another one is tried.
use std::f64::consts::LN_2;

use crate::contact::error::{ContactError, Controlled, NoSolution};
use crate::contact::problem::accuracy::{BEST, COARSE};
use crate::contact::problem::profile::PunchProfile;
use crate::contact::problem::twin::Twin;
use crate::contact::starts::formulas;
use crate::kernel::Kernel;
use crate::options::Options;
use crate::scene::{Punch, Top};
use crate::solution::{Solution, Stats};

/// The half-length is met to this part of the tolerance, or of its own error where that is larger.
const MET: f64 = 0.1;
/// Forces tried at most.
const TRIALS: usize = 60;
/// Longest step in the logarithm of the force.
const LONGEST: f64 = 3.0;

/// The value of what is prescribed in a solution, and its absolute error.
pub(crate) struct Measured {
    pub(crate) value: f64,
    pub(crate) error: f64,
}

/// Presses a punch on a stack until what is prescribed is as large as wanted; `press` presses to a tolerance with a force, `measure` tells how large it is
/// then. The force is found to a few digits first.
pub(crate) fn press_to<E: From<ContactError>>(
    kernel: &Kernel,
    top: &Top,
    (controlled, wanted): (Controlled, f64),
    options: &Options,
    press: impl Fn(f64, f64) -> Result<Solution, ContactError>,
    measure: impl Fn(&Solution) -> Result<Measured, E>,
) -> Result<Solution, E> {
    let punch = even_punch(top, controlled)?;
    let unreachable = |below, above| {
        let punch = top.label(kernel.geometry());
        ContactError::from(NoSolution::Unreachable { controlled, punch, wanted, below, above })
    };
    let is_length = controlled == Controlled::HalfLength;
    let (flat, edge) = (punch.shape().flat(), punch.max_half_length().filter(|_| is_length));
    if is_length && (wanted <= flat || edge.is_some_and(|edge| wanted >= edge)) {
        return Err(unreachable(edge, Some(flat)).into());
    }
    let mut work = Stats::default();
    let mut find = |tolerance: f64, guess: [f64; 2]| {
        let mut search = Search::new(tolerance, guess);
        let found = search.find(wanted, |force| press(tolerance, force), &measure, &mut work)?;
        Ok::<_, E>((found, search))
    };
    let mut guess = first_guess(kernel, punch, controlled, wanted);
    if options.tolerance < COARSE {
        let (rough, search) = find(COARSE, guess)?;
        guess = rough.map_or(guess, |_| [search.trial, search.slope]);
    }
    let (found, mut search) = find(options.tolerance, guess)?;
    if let Some(found) = found {
        let Stats { newton_steps, factorisations, interpolated, .. } = work;
        return Ok(Solution { stats: Stats { newton_steps, factorisations, interpolated, ..found.stats }, ..found });
    }
    let [below, above] = search.reached(edge);
    let ends = search.is_narrow() || !search.trial.exp().is_normal();
    let cause = match search.tried.pop() {
        Some((_, Outcome::Failed(failure))) => Some(Box::new(failure)),
        // it jumps from one to the other, or there is no such force
        _ if ends => return Err(unreachable(below, above).into()),
        _ => None,
    };
    let punch = top.label(kernel.geometry());
    Err(ContactError::from(NoSolution::ForceNotFound { controlled, punch, wanted, below, above, cause }).into())
}

/// The punch, of which alone something else than the force can be prescribed.
fn even_punch(top: &Top, controlled: Controlled) -> Result<&Punch, ContactError> {
    let missing =
        if top.loads().is_some() { ContactError::LoadControlled(controlled) } else { ContactError::UnevenPunch };
    top.even_punch().ok_or(missing)
}

/// What came of a force that was tried.
enum Outcome {
    /// The logarithm of what is wanted over what was found, and the latter.
    Solved { missing: f64, value: f64 },
    /// The punch is too small for it.
    TooLarge,
    /// The solver failed.
    Failed(NoSolution),
}

/// The secant method for the logarithm of the force, from all that was tried.
struct Search {
    /// What is wanted is to be met to this, relative.
    enough: f64,
    /// ln P of the force to be tried.
    trial: f64,
    /// The derivative of ln P with respect to the logarithm of what is prescribed.
    slope: f64,
    /// ln P of the forces tried, and what came of them.
    tried: Vec<(f64, Outcome)>,
}

impl Search {
    /// From ln P and the slope to begin with.
    fn new(tolerance: f64, [trial, slope]: [f64; 2]) -> Self {
        Self { enough: MET * tolerance.max(BEST), trial, slope, tried: Vec::new() }
    }

    /// The solution with what is wanted, if it is found, what all took, and the next force that would be tried.
    fn find<E: From<ContactError>>(
        &mut self,
        wanted: f64,
        press: impl Fn(f64) -> Result<Solution, ContactError>,
        measure: impl Fn(&Solution) -> Result<Measured, E>,
        work: &mut Stats,
    ) -> Result<Option<Solution>, E> {
        for _ in 0..TRIALS {
            let force = self.trial.exp();
            if !force.is_normal() {
                break;
            }
            let outcome = match press(force) {
                Ok(mut solution) => {
                    work.newton_steps.append(&mut solution.stats.newton_steps);
                    work.factorisations += solution.stats.factorisations;
                    work.interpolated += solution.stats.interpolated;
                    let Measured { value, error } = measure(&solution)?;
                    let (missing, error) = ((wanted / value).ln(), error / value);
                    if missing.abs() <= self.enough.max(MET * error) {
                        // the last step is too short to tell the slope
                        self.trial += self.slope * missing;
                        let force_error = self.slope * (error + missing.abs()) * force;
                        return Ok(Some(Solution { force_error, ..solution }));
                    }
                    Outcome::Solved { missing, value }
                }
                // so much that the punch is too small for it
                Err(ContactError::NoSolution(NoSolution::PunchTooSmall { .. })) => Outcome::TooLarge,
                Err(ContactError::NoSolution(failure)) => Outcome::Failed(failure),
                Err(error) => return Err(error.into()),
            };
            self.note(outcome);
            if self.is_narrow() {
                break;
            }
        }
        Ok(None)
    }

    /// ln P and value of the largest force known to be too small, and of the smallest known to be too large, for which the value is not known if the
    /// punch is too small for it; infinite where there is none.
    fn bracket(&self) -> [(f64, Option<f64>); 2] {
        let mut bracket = [(f64::NEG_INFINITY, None), (f64::INFINITY, None)];
        for (trial, outcome) in &self.tried {
            let [low, high] = &mut bracket;
            match outcome {
                Outcome::Solved { missing, value } if *missing > 0.0 && *trial > low.0 => *low = (*trial, Some(*value)),
                Outcome::Solved { missing, value } if *missing < 0.0 && *trial < high.0 => {
                    *high = (*trial, Some(*value))
                }
                Outcome::TooLarge if *trial <= high.0 => *high = (*trial, None),
                _ => {}
            }
        }
        bracket
    }

    /// The values on either side of the one that is wanted, as far as they are known; `edge` is the half-length of the punch.
    fn reached(&self, edge: Option<f64>) -> [Option<f64>; 2] {
        let [low, high] = self.bracket();
        [low.1, high.1.or(edge.filter(|_| high.0.is_finite()))]
    }

    /// Whether the bracket of the force is as narrow as what is wanted is to be met, or as rounding.
    fn is_narrow(&self) -> bool {
        let [low, high] = self.bracket();
        high.0 - low.0 <= self.enough.max(f64::EPSILON * self.trial.abs())
    }

    /// The forces that were solved for, the last first, and what was missing.
    fn solved(&self) -> impl Iterator<Item = (f64, f64)> {
        self.tried.iter().rev().filter_map(|(trial, outcome)| match outcome {
            Outcome::Solved { missing, .. } => Some((*trial, *missing)),
            _ => None,
        })
    }

    /// The slope from the last force that was solved for to the one that is tried, at which this is missing.
    fn slope_to(&self, missing: f64) -> f64 {
        let secant = self.solved().next().map(|(before, was)| (self.trial - before) / (was - missing));
        secant.filter(|secant| secant.is_finite() && *secant > 0.0).unwrap_or(self.slope)
    }

    /// Takes note of what came of the force that was tried, and chooses the next one.
    fn note(&mut self, outcome: Outcome) {
        if let Outcome::Solved { missing, .. } = outcome {
            self.slope = self.slope_to(missing);
        }
        self.tried.push((self.trial, outcome));
        let [(low, _), (high, _)] = self.bracket();
        self.trial = match &self.tried[self.tried.len() - 1] {
            (trial, Outcome::Solved { missing, .. }) => {
                let next = trial + (self.slope * missing).clamp(-LONGEST, LONGEST);
                // as next to where the half-length jumps: secants come from one side only
                let is_slow = self.solved().take(3).filter(|(_, other)| other * missing > 0.0).count() == 3;
                let is_between = low < next && next < high;
                let is_bracketed = low.is_finite() && high.is_finite();
                if is_between && !(is_slow && is_bracketed) { next } else { between(low, high, 0.5) }
            }
            (_, Outcome::TooLarge) => between(low, high, 0.5),
            // a failure says nothing: another force within the bracket, on the way to what failed first, or on either side of it
            (_, Outcome::Failed(_)) => {
                let failed = self.tried.iter().rev().take_while(|(_, outcome)| matches!(outcome, Outcome::Failed(_)));
                let all: Vec<f64> = failed.map(|(trial, _)| *trial).collect();
                let (first, count) = (all[all.len() - 1], all.len());
                let part = scattered(count);
                match [low, high].map(f64::is_finite) {
                    [true, true] => between(low, high, part),
                    [false, false] => {
                        let side = if count.is_multiple_of(2) { 1.0 } else { -1.0 };
                        first + side * LONGEST * scattered(count.div_ceil(2))
                    }
                    [is_low, _] => {
                        let known = if is_low { low } else { high };
                        known + part * (first - known)
                    }
                }
            }
        };
    }
}

/// A place in a bracket, as far from its lower end as this part of it; a step beyond its only end if one is not known.
fn between(low: f64, high: f64, part: f64) -> f64 {
    match (low, high) {
        (f64::NEG_INFINITY, high) => high - LONGEST,
        (low, f64::INFINITY) => low + LONGEST,
        (low, high) => low + part * (high - low),
    }
}

/// The points 1/2, 1/4, 3/4, 1/8, 5/8, ...: bits of a number from 1 on in reverse order, which fill (0, 1) evenly.
fn scattered(number: usize) -> f64 {
    (number as u64).reverse_bits() as f64 * (-64f64).exp2()
}

/// ln P to begin with, and its derivative with respect to the logarithm of what is prescribed.
fn first_guess(kernel: &Kernel, punch: &Punch, controlled: Controlled, wanted: f64) -> [f64; 2] {
    let expected = |half_length: f64| expected(kernel, punch, half_length).ln();
    match controlled {
        Controlled::HalfLength => {
            let trial = expected(wanted);
            let slope = (trial - expected(0.5 * wanted)) / LN_2;
            // the compliance that is expected may fall faster than any body's; by Hertz P is like a²
            [trial, if slope.is_finite() && slope > 0.0 { slope } else { 2.0 }]
        }
        // by Hertz P is like δ but for a logarithm, and under a flat punch it is proportional to δ
        Controlled::Approach => {
            let trial = expected(length_at(punch, wanted));
            [if trial.is_finite() { trial } else { (kernel.modulus() * wanted).ln() }, 1.0]
        }
    }
}

/// The half-length at which a profile is as high as this above its lowest point.
fn length_at(punch: &Punch, height: f64) -> f64 {
    let edge = punch.max_half_length().unwrap_or(f64::MAX);
    let is_higher = |x: f64| punch.profile(x) - punch.shape().lowest() >= height;
    // bisection of the logarithm
    let (mut low, mut high) = (f64::MIN_POSITIVE.ln(), edge.ln());
    while high - low > 1e-3 {
        let middle = 0.5 * (low + high);
        if is_higher(middle.exp()) { high = middle } else { low = middle }
    }
    high.exp()
}

/// The force that Hertz's formula expects, on the compliance that the whole stack has for waves as long as the contact.
fn expected(kernel: &Kernel, punch: &Punch, half_length: f64) -> f64 {
    let with_punch = punch.material().map(|material| kernel.under_half_plane(&material));
    let kernel = with_punch.as_ref().unwrap_or(kernel);
    let unit = kernel.modulus() * kernel.length();
    let (profile, half_length) =
        (PunchProfile::new(punch, kernel.length(), 1.0, Twin::of(kernel.geometry())), half_length / kernel.length());
    let force = unit * formulas::force(kernel, &profile, half_length);
    if force.is_normal() && force > 0.0 {
        return force;
    }
    // where a wave as long would lift what bends: the faces alone
    unit * profile.first_row(half_length) * half_length / kernel.asymptote(0).limit
}
