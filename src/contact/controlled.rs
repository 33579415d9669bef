//! The force under which the contact of the punch has a prescribed half-length, or the punch has sunk by a prescribed depth.
//!
//! Both grow with the force: the logarithm of the force is found as a function of the logarithm of what is prescribed by the secant method, kept between
//! forces known to be too small and too large. A force at which the solver fails says nothing: another one is tried.
use std::f64::consts::LN_2;

use crate::contact::error::{ContactError, Controlled, NoSolution};
use crate::contact::problem::profile::Profile;
use crate::contact::problem::twin::Twin;
use crate::contact::quality::estimates::BEST;
use crate::contact::starts::formulas;
use crate::kernel::Kernel;
use crate::options::{Method, Options};
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

/// Presses a punch on a stack until what is prescribed is as large as wanted; `press` presses with a force, `measure` tells how large it is
/// then.
pub(crate) fn press_to<E: From<ContactError>>(
    kernel: &Kernel,
    top: &Top,
    (controlled, wanted): (Controlled, f64),
    options: &Options,
    press: impl Fn(f64) -> Result<Solution, ContactError>,
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
    let floor = if options.method == Method::Collocation { options.tolerance } else { BEST };
    let mut search =
        Search::new(wanted, MET * options.tolerance.max(floor), first_guess(kernel, punch, controlled, wanted));
    let mut all = Stats::default();
    for _ in 0..TRIALS {
        let force = search.trial.exp();
        if !force.is_normal() {
            return Err(unreachable(search.low.map(|known| known.value), search.above(edge)).into());
        }
        match press(force) {
            Ok(mut solution) => {
                all.newton_steps.append(&mut solution.stats.newton_steps);
                all.factorisations += solution.stats.factorisations;
                all.interpolated += solution.stats.interpolated;
                all.stopped.append(&mut solution.stats.stopped);
                if let Some(relative) = search.solved(&measure(&solution)?) {
                    let Stats { newton_steps, factorisations, interpolated, stopped, .. } = all;
                    let stats = Stats { newton_steps, factorisations, interpolated, stopped, ..solution.stats };
                    let force_error = search.slope * relative * solution.force;
                    return Ok(Solution { force_error, stats, ..solution });
                }
            }
            // so much that the punch is too small for it
            Err(ContactError::NoSolution(NoSolution::PunchTooSmall { .. })) => search.too_large(),
            Err(ContactError::NoSolution(failure)) => search.failed(failure),
            Err(error) => return Err(error.into()),
        }
        if search.is_narrow() {
            break;
        }
    }
    let (below, above) = (search.low.map(|known| known.value), search.above(edge));
    match search.failure {
        // it jumps from one to the other
        None if search.is_narrow() => Err(unreachable(below, above).into()),
        failure => {
            let cause = failure.map(Box::new);
            let punch = top.label(kernel.geometry());
            Err(ContactError::from(NoSolution::ForceNotFound { controlled, punch, wanted, below, above, cause }).into())
        }
    }
}

/// The punch, of which alone something else than the force can be prescribed.
fn even_punch(top: &Top, controlled: Controlled) -> Result<&Punch, ContactError> {
    let missing =
        if top.loads().is_some() { ContactError::LoadControlled(controlled) } else { ContactError::UnevenPunch };
    top.punch().filter(|punch| punch.is_even()).ok_or(missing)
}

/// A force that was solved for, and what was found.
#[derive(Clone, Copy)]
struct Known {
    /// ln P.
    trial: f64,
    /// The logarithm of what is wanted over what was found.
    missing: f64,
    value: f64,
}

/// The secant method for the logarithm of the force.
struct Search {
    wanted: f64,
    /// It is to be met to this, relative.
    enough: f64,
    /// ln P of the force to be tried.
    trial: f64,
    /// The derivative of ln P with respect to the logarithm of what is prescribed.
    slope: f64,
    last: Option<Known>,
    /// The largest force known to be too small, and the smallest found to be too large.
    low: Option<Known>,
    high: Option<Known>,
    /// ln P of the smallest force known to be too large, for the contact or for the punch.
    too_large: f64,
    /// How long [low, too_large] was when it was last halved.
    width: f64,
    /// Trials since then.
    since: usize,
    /// Why the solver failed last, unless a force was solved for afterwards; the first such ln P, and how many there were.
    failure: Option<NoSolution>,
    first_failed: f64,
    failures: usize,
}

impl Search {
    /// Begins with a guess of ln P, and of its slope.
    fn new(wanted: f64, enough: f64, (trial, slope): (f64, f64)) -> Self {
        Self {
            wanted,
            enough,
            trial,
            slope,
            last: None,
            low: None,
            high: None,
            too_large: f64::INFINITY,
            width: f64::INFINITY,
            since: 0,
            failure: None,
            first_failed: 0.0,
            failures: 0,
        }
    }

    /// ln P of the largest force known to be too small.
    fn too_small(&self) -> f64 {
        self.low.map_or(f64::NEG_INFINITY, |known| known.trial)
    }

    /// The least value found that is too large; the half-length of the punch, if it was too small for that force.
    fn above(&self, edge: Option<f64>) -> Option<f64> {
        self.high.map(|known| known.value).or(edge.filter(|_| self.too_large.is_finite()))
    }

    /// Whether the bracket of the force is as narrow as what is wanted is to be met, or as rounding.
    fn is_narrow(&self) -> bool {
        self.too_large - self.too_small() <= self.enough.max(f64::EPSILON * self.trial.abs())
    }

    /// Takes note of what was found at a force, and chooses the next one; the relative error of what is prescribed, if it is as large as
    /// wanted.
    fn solved(&mut self, found: &Measured) -> Option<f64> {
        let missing = (self.wanted / found.value).ln();
        let known = Known { trial: self.trial, missing, value: found.value };
        if let Some(last) = self.last
            && last.missing != missing
        {
            let secant = (known.trial - last.trial) / (last.missing - missing);
            self.slope = if secant.is_finite() && secant > 0.0 { secant } else { self.slope };
        }
        let error = found.error / found.value;
        if missing.abs() <= self.enough.max(MET * error) {
            return Some(error + missing.abs());
        }
        (self.failure, self.failures) = (None, 0);
        if missing > 0.0 && known.trial > self.too_small() {
            self.low = Some(known);
        } else if missing < 0.0 && known.trial < self.too_large {
            (self.high, self.too_large) = (Some(known), known.trial);
        }
        self.last = Some(known);
        let next = known.trial + (self.slope * missing).clamp(-LONGEST, LONGEST);
        let inside = self.too_small() < next && next < self.too_large;
        self.trial = if inside && !self.is_slow() { next } else { self.between(0.5) };
        None
    }

    /// Takes note of a force that is too large for the punch, and chooses a smaller one.
    fn too_large(&mut self) {
        self.too_large = self.too_large.min(self.trial);
        self.high = None;
        (self.failure, self.failures) = (None, 0);
        self.trial = self.between(0.5);
    }

    /// Whether secants have not halved the interval for two trials, as next to where the half-length jumps.
    fn is_slow(&mut self) -> bool {
        let width = self.too_large - self.too_small();
        if width.is_infinite() || width <= 0.5 * self.width {
            (self.width, self.since) = (width, 0);
        }
        self.since += 1;
        self.since > 2
    }

    /// A place in the interval, as far from its lower end as this part of it; a step beyond its only end if one is not known.
    fn between(&self, part: f64) -> f64 {
        match (self.too_small(), self.too_large) {
            (f64::NEG_INFINITY, high) => high - LONGEST,
            (low, f64::INFINITY) => low + LONGEST,
            (low, high) => low + part * (high - low),
        }
    }

    /// Takes note of a failure, and chooses another force: within the interval; on the way from what is known to what failed;
    /// or on either side of the first guess.
    fn failed(&mut self, failure: NoSolution) {
        if self.failures == 0 {
            self.first_failed = self.trial;
        }
        self.failure = Some(failure);
        self.failures += 1;
        let known = self.low.or(self.high).map(|known| known.trial);
        self.trial = match known {
            Some(_) if self.too_small().is_finite() && self.too_large.is_finite() => {
                self.between(scattered(self.failures))
            }
            Some(known) => known + scattered(self.failures) * (self.first_failed - known),
            None => {
                let side = if self.failures.is_multiple_of(2) { 1.0 } else { -1.0 };
                self.first_failed + side * LONGEST * scattered(self.failures.div_ceil(2))
            }
        };
    }
}

/// The points 1/2, 1/4, 3/4, 1/8, 5/8, ...: bits of a number from 1 on in reverse order, which fill (0, 1) evenly.
fn scattered(number: usize) -> f64 {
    (number as u64).reverse_bits() as f64 * (-64f64).exp2()
}

/// ln P to begin with, and its derivative with respect to the logarithm of what is prescribed.
fn first_guess(kernel: &Kernel, punch: &Punch, controlled: Controlled, wanted: f64) -> (f64, f64) {
    let expected = |half_length: f64| expected(kernel, punch, half_length).ln();
    match controlled {
        Controlled::HalfLength => {
            let trial = expected(wanted);
            let slope = (trial - expected(0.5 * wanted)) / LN_2;
            // the compliance that is expected may fall faster than any body's; by Hertz P is like a²
            (trial, if slope.is_finite() && slope > 0.0 { slope } else { 2.0 })
        }
        // by Hertz P is like δ but for a logarithm, and under a flat punch it is proportional to δ
        Controlled::Approach => {
            let trial = expected(length_at(punch, wanted));
            (if trial.is_finite() { trial } else { (kernel.modulus() * wanted).ln() }, 1.0)
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
        (Profile::new(punch, kernel.length(), 1.0, Twin::of(kernel.geometry())), half_length / kernel.length());
    let force = unit * formulas::force(kernel, &profile, half_length);
    if force.is_normal() && force > 0.0 {
        return force;
    }
    // where a wave as long would lift what bends: the faces alone
    unit * profile.first_row(half_length) * half_length / kernel.asymptote(0).limit
}
