//! One refinement level: half-lengths, pressures, and estimates of how far they are from the truth.
//!
//! An estimate is made in three steps: what the modes of a contact itself tell ([`Truncation`]: how its last modes fall, and
//! what sweeps have left), what strongly coupled contacts share of that, and what each contact is sensitive to of the errors
//! of the others ([`Propagation`]).
use crate::contact::problem::accuracy::{COARSE, MINOR, ROUNDING, SAFETY};
use std::cmp::Ordering;
use std::f64::consts::PI;

use crate::contact::ends::Converged;
use crate::contact::problem::Problem;
use crate::contact::problem::estimate::Estimate;
use crate::contact::problem::modes::{FINEST, Modes, beyond, beyond_late, order, weight};
use crate::contact::problem::profile::{Local, continued};
use crate::contact::problem::support::Support;
use crate::numeric;

/// No level is judged better than this.
pub(crate) const BEST: f64 = 5.0 * ROUNDING;

/// Half-lengths with larger relative errors are not known.
pub(crate) const UNKNOWN: f64 = 0.03;

/// The relative error of the half-length of a decaying contact, no end of which is found.
pub(crate) const ENDLESS: f64 = 1.0;

/// The error of a half-length is at least this part of the error of its pressure, whatever the last modes say.
const LEAST_LENGTH: f64 = 1e-3;

/// What the last terms of an alternating sum count if its partial sums are averaged six times, term by term.
pub(crate) const AVERAGED: [f64; 6] = [63.0 / 64.0, 57.0 / 64.0, 42.0 / 64.0, 22.0 / 64.0, 7.0 / 64.0, 1.0 / 64.0];

/// Half-lengths and pressures at one refinement level.
pub(crate) struct Level {
    pub(crate) support: Support,
    /// y_im of contact i, y_i0 = 1; under a punch that is not smooth continued by the asymptotic part.
    pub(crate) modes: Modes,
    /// The mode y_m, the same for all m, of the apex singularity of each contact; 0 where there is none.
    pub(crate) apexes: Vec<f64>,
    /// The number of modes that were found.
    pub(crate) counts: Vec<usize>,
    /// Σ y_m/(πj), p(0) a/(2 μ₀P'), per contact; infinite under a sharp tip.
    pub(crate) peaks: Vec<f64>,
    /// The pressures that errors are compared with, in the same measure.
    pub(crate) sizes: Vec<f64>,
    /// Whether sweeps have left less than the truncation error.
    pub(crate) swept: Vec<bool>,
    /// Relative errors.
    pub(crate) errors: Vec<Estimate>,
    /// The larger of both as far as more modes of the contact itself would make it smaller.
    pub(crate) own_errors: Vec<f64>,
    /// Part of the highest modes in the pressure of a contact.
    pub(crate) tails: Vec<f64>,
    /// Under a punch that is not smooth, or has corners, the higher half of the modes without the asymptotic part, the lower half
    /// being 0.
    pub(crate) remainders: Vec<Option<Vec<f64>>>,
}

impl Level {
    /// Errors are estimated from what the sweeps have changed, and from how fast the highest modes fall, less the modes of the
    /// asymptotic part under a punch that is not smooth: the latter are known, however slowly they fall. Parts of the kernels below
    /// `negligible` were left out.
    pub(crate) fn new(found: Converged, problem: &Problem, negligible: f64) -> Self {
        let counts: Vec<usize> = found.modes.iter().map(Vec::len).collect();
        let (half_lengths, n) = (&found.support.half_lengths, counts.len());
        let local = |i: usize| {
            let limit = problem.kernel.asymptote(i).limit;
            problem.sides[i].local(half_lengths[i], limit, (4 * FINEST).max(counts[i]))
        };
        let locals: Vec<Option<Local>> = (0..n).map(local).collect();
        let truncations: Vec<Truncation> =
            (0..n).map(|i| Truncation::new(&found, problem, i, locals[i].as_ref(), negligible)).collect();
        let (errors, own_errors) = Propagation::new(&found, problem, &truncations).errors();
        let Converged { support, mut modes, .. } = found;
        let mut apexes = vec![0.0; n];
        for (i, local) in locals.iter().enumerate() {
            let Some(local) = local else { continue };
            if problem.sides[i].is_sharp() {
                apexes[i] = local.modes[0];
            }
            continued(&mut modes[i], &local.modes);
        }
        let peaks = truncations.iter().map(|own| own.peak).collect();
        let sizes = truncations.iter().map(|own| own.size).collect();
        let swept = truncations.iter().map(|own| own.is_swept).collect();
        let tails = truncations.iter().map(|own| own.tail).collect();
        let remainders = truncations.into_iter().map(|own| own.remainder).collect();
        Self { support, modes, apexes, counts, peaks, sizes, swept, errors, own_errors, tails, remainders }
    }

    /// Where sweeps have not converged, nothing is known better than by how much half-lengths differ from half-lengths found with fewer modes.
    pub(crate) fn doubt(&mut self, coarse: &[f64]) {
        for (i, error) in self.errors.iter_mut().enumerate() {
            if self.swept[i] || self.support.decay(i).is_some() || error.length <= MINOR * COARSE {
                continue;
            }
            let change = (self.support.half_lengths[i] / coarse[i]).ln().abs();
            error.length = error.length.max(change);
            error.pressure = error.pressure.max(change);
            self.own_errors[i] = self.own_errors[i].max(change);
        }
    }

    /// The largest of the error estimates, but for half-lengths that are not known.
    pub(crate) fn worst_error(&self) -> f64 {
        let of_contact = |error: &Estimate| if error.length > UNKNOWN { error.pressure } else { error.worst() };
        numeric::largest(self.errors.iter().map(of_contact))
    }

    /// Whether more is known than on another level: more half-lengths, or all of them to more digits.
    pub(crate) fn is_better_than(&self, other: &Self) -> bool {
        let unknown = |level: &Self| level.errors.iter().filter(|error| error.length > UNKNOWN).count();
        match unknown(self).cmp(&unknown(other)) {
            Ordering::Equal => self.worst_error() < other.worst_error(),
            fewer => fewer == Ordering::Less,
        }
    }
}

/// What the modes of one contact tell of those that are missing.
struct Truncation {
    /// Σ y_m/(πj).
    peak: f64,
    /// The pressure that errors are compared with: that at x = 0, or a mean pressure where that is infinite, or where joined bodies
    /// may have none there.
    size: f64,
    error: Estimate,
    /// By how much more than the last modes the missing ones may change the half-length, and by how much at most.
    further: f64,
    most: f64,
    /// What is missing of the pressure, as neighbours are sensitive to it: not averaged.
    unaveraged: f64,
    /// What no modes can change.
    arithmetic: f64,
    is_swept: bool,
    tail: f64,
    remainder: Option<Vec<f64>>,
}

impl Truncation {
    fn new(found: &Converged, problem: &Problem, i: usize, local: Option<&Local>, negligible: f64) -> Self {
        let own = without(&found.modes[i], local);
        let (left, arithmetic) = (found.residuals[i], negligible + ROUNDING);
        let intensity = found.support.intensity(i);
        // where modes fall like a power, the terms of the pressure at x = 0 are averaged
        let averaged = !problem.kernel.asymptote(i).is_constant();
        let edge = problem.twin().edge() * (2.0 * problem.twin().norm - 1.0);
        let swept = weight(&own, found.solved[i]..own.len());
        let (beyond, fall) = beyond(&own);
        let beyond = beyond.max(beyond_late(&own));
        let peak =
            peak(&own, averaged) + local.map_or(0.0, |local| local.peak) - intensity.map_or(0.0, |q| edge * q / PI);
        // an infinite pressure is known, and others are compared with a mean pressure
        let mean = PI.recip();
        let size = match intensity {
            _ if peak.is_infinite() => mean,
            Some(_) => peak.abs().max(mean),
            None => peak.abs(),
        };
        // a half-length is sensitive to the square of what is missing, and no more than pressures are; but where a known load
        // falls slowly, only what it meets of the kernels falls fast, and strongly coupled contacts are no less sensitive
        let power = if local.is_some() || found.fully_solved[i] { 1 } else { 2 };
        let (further, most) = ((beyond / swept.max(f64::MIN_POSITIVE)).powi(power), beyond / (PI * size));
        let beyond_length = (found.corrections[i].abs() * further).min(most);
        let missing = if averaged {
            // an averaged sum is as good as the next one differs from it, and no worse than it differs from the plain one
            let [average, plain] = [true, false].map(|averaged| self::peak(&own, averaged));
            let change = (self::peak(&own[..own.len() * 3 / 4], true) - average).abs();
            (change * SAFETY * fall).min(beyond / PI + (average - plain).abs())
        } else {
            beyond / PI
        };
        // a pressure that is infinite cannot be missed
        let pressure = if peak.is_finite() { (missing + left.pressure / PI) / size } else { 0.0 };
        // the modes of a punch that is not smooth fall slowly, but it is known how
        let least = if local.is_some() { 0.0 } else { LEAST_LENGTH * pressure };
        // and of a frozen end, only what depends on it matters
        let decay = found.support.decay(i);
        let length = decay.map_or(beyond_length + left.length + least, |decay| decay.sensitivity) + arithmetic;
        let is_peak_swept = !peak.is_finite() || left.pressure < 0.1 * pressure * size * PI;
        let half = own.len() / 2;
        let mut truncation = Self {
            peak,
            size,
            error: Estimate::new(length, pressure + 3.0 * arithmetic),
            further,
            most,
            unaveraged: if averaged {
                largest(&own, own.len().saturating_sub(AVERAGED.len())) / PI
            } else {
                beyond / PI
            },
            arithmetic,
            is_swept: left.length < 0.1 * length && is_peak_swept,
            // compared with the mean pressure where there is hardly any in the middle
            tail: weight(&own, half..own.len()) / (PI * size).max(1.0),
            remainder: (local.is_some() || intensity.is_some())
                .then(|| [vec![0.0; half], own[half..].to_vec()].concat()),
        };
        if problem.is_known(i) {
            // nothing of it is unknown
            (truncation.error, truncation.tail, truncation.is_swept) = (Estimate::default(), 0.0, true);
        }
        truncation
    }
}

/// How the errors of each contact come about from the errors of all.
struct Propagation<'a> {
    found: &'a Converged,
    problem: &'a Problem<'a>,
    truncations: &'a [Truncation],
    /// What each contact's own modes miss.
    errors: Vec<Estimate>,
    /// Errors of the half-lengths themselves; a frozen end may be anywhere, and as the pressure decays, so does what depends on
    /// it.
    ends: Vec<f64>,
}

impl<'a> Propagation<'a> {
    fn new(found: &'a Converged, problem: &'a Problem<'a>, truncations: &'a [Truncation]) -> Self {
        let mut errors: Vec<Estimate> = truncations.iter().map(|own| own.error).collect();
        // strongly coupled contacts are sensitive to what each of them misses as they were to what it missed before
        let all: Vec<usize> = problem.unknown().collect();
        for run in all.chunk_by(|i, k| found.fully_solved[*i] && found.fully_solved[*k]) {
            let further = numeric::largest(run.iter().map(|i| truncations[*i].further));
            let most = numeric::largest(run.iter().map(|i| truncations[*i].most));
            for i in run.iter().filter(|_| run.len() > 1) {
                errors[*i].length = errors[*i].length.max((found.corrections[*i].abs() * further).min(most));
            }
        }
        let end = |(i, error): (usize, &Estimate)| found.support.decay(i).map_or(error.length, |decay| decay.length);
        let ends = errors.iter().enumerate().map(end).collect();
        Self { found, problem, truncations, errors, ends }
    }

    /// The errors of all contacts, and of each contact what more modes of its own would make smaller.
    fn errors(&self) -> (Vec<Estimate>, Vec<f64>) {
        let n = self.errors.len();
        let passed: Vec<f64> = (0..n).map(|i| self.ends[i].max(self.others(i, Self::length, &self.ends))).collect();
        let mut errors = self.errors.clone();
        let mut own_errors = Vec::with_capacity(n);
        for (i, error) in errors.iter_mut().enumerate() {
            error.pressure += SAFETY * self.pressure(i, i) * self.errors[i].length;
            // no modes help against rounding
            let arithmetic = self.truncations[i].arithmetic;
            own_errors.push((error.length - arithmetic).max(error.pressure - (3.0 + SAFETY) * arithmetic));
        }
        for (i, error) in errors.iter_mut().enumerate() {
            error.length += self.found.influences.rounding[i];
            error.pressure += self.rounding(i);
            if self.problem.is_known(i) {
                continue;
            }
            for k in [i.wrapping_sub(1), i + 1].into_iter().filter(|k| *k < n && !self.problem.is_known(*k)) {
                let neighbour = self.neighbour(i, k);
                error.pressure += neighbour;
                own_errors[k] = own_errors[k].max(neighbour);
            }
            error.pressure += SAFETY * self.others(i, Self::pressure, &passed);
            if self.found.support.decay(i).is_none() {
                error.pressure += SAFETY * self.pressure(i, i) * (passed[i] - self.ends[i]);
            }
            error.length += self.others(i, Self::length, &passed);
            if self.found.support.decay(i).is_some() {
                error.length = ENDLESS;
            }
            if self.found.support.intensity(i).is_some() {
                // the half-length is the half-width of the punch
                error.length = 0.0;
            }
        }
        (errors, own_errors)
    }

    /// The largest error that contact i has from an end of another one.
    fn others(&self, i: usize, sensitivity: impl Fn(&Self, usize, usize) -> f64, ends: &[f64]) -> f64 {
        numeric::largest((0..ends.len()).filter(|k| *k != i).map(|k| sensitivity(self, i, k) * ends[k]))
    }

    /// How sensitive half-length i is to half-length k.
    fn length(&self, i: usize, k: usize) -> f64 {
        if i == k { 1.0 } else { self.found.influences.lengths[(i, k)].min(1.0) }
    }

    /// How sensitive pressure i is to half-length k: no less than its half-length, unless that is not known at all.
    fn pressure(&self, i: usize, k: usize) -> f64 {
        let sensitivity = self.found.influences.peaks[(i, k)].min(1.0);
        let is_unknown = match i == k {
            true => self.errors[k].length > UNKNOWN,
            false => self.ends[k] > UNKNOWN || self.found.support.decay(k).is_some(),
        };
        if is_unknown { sensitivity } else { sensitivity.max(self.length(i, k)) }
    }

    /// What contact k misses of its pressure is a load on the other side of the laminate between it and contact i.
    fn neighbour(&self, i: usize, k: usize) -> f64 {
        let half_lengths = &self.found.support.half_lengths;
        let (kernel, other) = (self.problem.kernel, &self.truncations[k]);
        let last = 2.0 * self.found.modes[k].len() as f64 / half_lengths[k];
        let sensitivity = (kernel.coupling(i.min(k), last).abs() / kernel.asymptote(i).limit).min(1.0);
        sensitivity * other.unaveraged * half_lengths[i] / (half_lengths[k] * self.truncations[i].size)
    }

    /// What rounding does to pressure i comes by way of the half-lengths.
    fn rounding(&self, i: usize) -> f64 {
        let rounding = &self.found.influences.rounding;
        let peaks = self.found.influences.peaks.row(i).iter().zip(rounding);
        let by_lengths = peaks.map(|(sensitivity, rounding)| sensitivity.min(1.0) * rounding);
        SAFETY * by_lengths.fold(rounding[i].min(ROUNDING), f64::max)
    }
}

/// Modes less the modes of the asymptotic part.
fn without(modes: &[f64], local: Option<&Local>) -> Vec<f64> {
    let Some(local) = local else { return modes.to_vec() };
    modes.iter().zip(&local.modes).map(|(y, local)| y - local).collect()
}

/// The largest |y_m|/order from a mode on.
fn largest(modes: &[f64], from: usize) -> f64 {
    numeric::largest((from..modes.len()).map(|m| weight(modes, m..m + 1)))
}

/// p(0) a/(2 μ₀P'), Σ y_m/(πj). Next to a graded face the terms fall like ± j⁻⁴, alternating, since the pressure
/// has a logarithm at its ends: the last partial sums are averaged, which leaves little of what is missing.
fn peak(modes: &[f64], averaged: bool) -> f64 {
    let last = if averaged { modes.len().saturating_sub(AVERAGED.len()) } else { modes.len() };
    let terms = modes.iter().enumerate().map(|(m, y)| {
        let weight = m.checked_sub(last).map_or(1.0, |k| AVERAGED[k]);
        weight * y / order(m)
    });
    terms.sum::<f64>() / PI
}
