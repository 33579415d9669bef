//! Contacts in any list of intervals: bodies that touch about the middle and again farther out, are apart about the middle, or touch anywhere where
//! nothing is even.
mod assemble;
mod changes;
mod closed;
mod columns;
mod depth;
mod derivatives;
mod equations;
mod errors;
mod gaps;
mod kept;
mod ledger;
mod left_out;
mod local;
mod newton;
mod pressure;
mod recontact;
mod responses;
mod short_waves;
mod sinking;
mod space;
mod steps;
mod support;
mod system;
mod tension;
#[cfg(test)]
mod tests;
mod topology;
mod unknowns;
mod waves;

use crate::contact::answer::Answer;
use crate::contact::integrals::layout::Lengths;
use crate::contact::integrals::tail::turning;
use crate::contact::problem::accuracy::{BEST, COARSE, ENDLESS, MINOR, ROUNDING, SAFETY};
use crate::contact::problem::iteration::Work;
use crate::contact::problem::profile::continued;
use crate::contact::problem::{Expected, Problem};
use crate::numeric::largest;
use crate::solution::{self, Contact, Opening, Solution, Stats, Strip, Warning, WarningCode};
use errors::Errors;
use gaps::Fault;
pub(super) use ledger::ledger;
use newton::{Approximation, converge};
use pressure::{Pressure, Tip};
pub(crate) use sinking::Sinking;
pub(super) use sinking::sinking;
pub(super) use support::Intervals;
use support::{ContactInterval, Parity};
pub(super) use topology::{Refused, solve};

/// Terms on each interval: the first number of them, and the last.
const COARSEST: usize = 12;
const FINEST: usize = 768;
/// From level to level the number of terms grows by a factor between these.
const LEAST_GROWTH: f64 = 1.5;
const MOST_GROWTH: f64 = 2.25;
/// Signs are looked at before there are more terms on an interval.
const MANY: usize = 64;
/// A layout serves lists whose ends differ by this much, relative.
const LAYOUT_SERVES: f64 = 0.1;

/// The list where contacts are expected; none where one is expected nowhere.
pub(super) fn of_formulas(problem: &Problem, expected: &[Expected]) -> Option<Intervals> {
    let of = |Expected { contact, punch, ends }: &Expected| {
        if problem.is_opened(*contact) {
            // what is even is solved for on x ≥ 0
            let is_there = !problem.is_even() || ends[1] > 0.0;
            return is_there.then(|| ContactInterval::opening(problem, *contact, *ends));
        }
        if problem.is_even() {
            let half = [ends[0].max(0.0), ends[1]];
            let corners = [half[0] == 0.0, true].map(|may| may && problem.sides[*contact].is_flat());
            return (ends[1] > 0.0)
                .then(|| ContactInterval::even(problem.twin(), *contact, half).with_corners(corners));
        }
        let corner = |side: f64| problem.corner(*contact, *punch, side);
        let corners = [corner(-1.0) == Some(ends[0]), corner(1.0) == Some(ends[1])];
        Some(ContactInterval::anywhere(*contact, *punch, *ends).with_corners(corners))
    };
    let start = Intervals(expected.iter().filter_map(of).collect());
    let is_there = |contact: usize| {
        let own = start.of(contact);
        !own.is_empty() && own.iter().all(|interval| interval.half.is_normal() && interval.middle.is_finite())
    };
    problem.unknown().filter(|contact| !problem.is_opened(*contact)).all(is_there).then_some(start)
}

/// The list on which contacts were found, in units of L; none where a contact has none.
pub(super) fn of_contacts(problem: &Problem, contacts: &[Contact]) -> Option<Intervals> {
    of_formulas(problem, &expected(problem, contacts)).map(|support| support.held(problem))
}

/// Where contacts and openings of a solution are, in units of L.
pub(super) fn of_solution(problem: &Problem, solution: &Solution) -> Vec<Expected> {
    let length = problem.kernel.length();
    let own = |contact: &Contact| contact.clone().scaled(length.recip(), 1.0).moved(-problem.origin);
    let contacts = problem.unknown().filter_map(|contact| solution.contacts.get(contact));
    let mut all = expected(problem, &contacts.map(own).collect::<Vec<_>>());
    for (number, own) in solution.closed.iter().enumerate() {
        let contact = problem.kernel.lowest() + 1 + number;
        let opening = |one: &Opening| {
            let ends = [one.left, one.right].map(|x| x / length - problem.origin);
            Expected { contact, punch: 0, ends }
        };
        all.extend(own.openings.iter().map(opening));
    }
    all
}

/// Where contacts were found, in units of L.
fn expected(problem: &Problem, contacts: &[Contact]) -> Vec<Expected> {
    let expected = problem.unknown().zip(contacts).flat_map(|(contact, own)| {
        let of = |(number, one): (usize, &solution::Interval)| {
            let punch = own.punches.get(number).copied().unwrap_or_default();
            let end = |side: f64, x: f64| {
                // units may have changed the last digit
                let corner = problem.corner(contact, punch, side);
                corner.filter(|corner| (corner - x).abs() < 1e-9 * (one.right - one.left)).unwrap_or(x)
            };
            Expected { contact, punch, ends: [end(-1.0, one.left), end(1.0, one.right)] }
        };
        let all: Vec<Expected> = own.intervals.iter().enumerate().map(of).collect();
        all.into_iter().filter(|one| !problem.is_even() || one.ends[1] > 0.0)
    });
    expected.collect()
}

/// As many terms as resolve waves so short that their compliance is the one of the layers at the faces of the contact alone.
fn resolving(problem: &Problem, interval: &ContactInterval) -> usize {
    let orders = 1.2 * interval.half * problem.kernel.governed_by_faces(interval.contact);
    (if interval.is_even() { 0.5 * orders } else { orders }) as usize
}

/// The same between the usual number of terms and four times as many, both times `finer`.
fn first_count(problem: &Problem, interval: &ContactInterval, finer: usize) -> usize {
    resolving(problem, interval).clamp(finer * COARSEST, finer * 4 * COARSEST).min(FINEST / 2)
}

/// Goes on from a first solution with more and more terms, though intervals that carry next to nothing may be left out. Signs are looked at once terms would be many, and in the end.
///
/// # Errors
/// What is wrong with the signs, if that is seen at the first look; nothing if there is no answer for another reason.
fn refine(problem: &Problem, first: Approximation, leaves_out: bool, work: &mut Work) -> Result<Answer, Option<Fault>> {
    let (mut is_seen, mut is_first, mut was_few, few) = (false, true, true, first.counts.clone());
    let tolerance = problem.tolerance.max(BEST);
    let enough = ROUNDING.max(MINOR * tolerance);
    let (mut last, mut best, mut stalls) = (first, None::<(Errors, Approximation)>, false);
    loop {
        let errors = Errors::of(&last, resolves(problem, &last));
        // kernels and ends of the first solution have few digits
        let is_rough = std::mem::take(&mut is_first) && tolerance < COARSE;
        let is_few = is_rough || last.counts == few && !errors.resolves;
        // more terms do not help against what is due to something else, nor against what steps have left
        let is_done = !is_few && errors.worst() <= tolerance.max(2.0 * errors.floor);
        let goes_on = errors.steps > errors.missing.max(SAFETY * enough);
        let mut counts = if goes_on { last.counts.clone() } else { grown(&last, &errors, tolerance) };
        last.support.equalise(&mut counts);
        let is_finest = !is_rough && !goes_on && counts == last.counts;
        // errors of few terms may be small by chance
        let is_better = std::mem::replace(&mut was_few, is_few || last.counts == few)
            || best.as_ref().is_none_or(|(best, _)| errors.worst() < best.worst());
        if is_better {
            best = Some((errors, last.clone()));
        }
        // one change may be small by chance
        if is_done || is_finest || !is_better && stalls {
            break;
        }
        stalls = !is_better;
        if !is_seen && counts.iter().any(|count| *count > MANY) {
            closed::check(problem, &last, COARSE, leaves_out).map_err(Some)?;
            is_seen = true;
            // no other start follows
            work.finish();
        }
        match converge(problem, last.support.clone(), Some(&last), &counts, enough, work) {
            Ok(level) => last = level,
            Err(_) => break,
        }
    }
    let (errors, level) = best.ok_or(None)?;
    answered(problem, level, errors, leaves_out, work)
}

/// The answer that a solution is with its errors, though intervals that carry next to nothing may be left out.
///
/// # Errors
/// What is wrong with its signs; nothing if it is not known well enough.
fn answered(
    problem: &Problem,
    mut level: Approximation,
    mut errors: Errors,
    leaves_out: bool,
    work: &Work,
) -> Result<Answer, Option<Fault>> {
    if problem.tolerance < COARSE {
        level.local = local::locals(problem, &level.support, &level.solved, |_| 4 * FINEST);
    }
    let middle = level.middle_pressures(&level.solved.pressures);
    for (k, error) in errors.pressures.iter_mut().enumerate() {
        *error += SAFETY * level.local[k].error / level.largest_pressure(level.support.0[k].contact, &middle);
    }
    // what still changes so much is not known to be near its limit, and a punch presses
    if !errors.are_known() || level.solved.forces.iter().any(|force| *force <= 0.0) {
        return Err(None);
    }
    let mut warnings = Vec::new();
    warnings.extend(precision(problem.tolerance, errors.worst(), level.counts.iter().copied().max().unwrap_or(0)));
    let signs = closed::check(problem, &level, errors.worst(), leaves_out).map_err(Some)?;
    errors.admit(&level, &signs);
    warnings.extend(signs.recontacts.iter().map(|recontact| recontact.warning(problem)));
    warnings.extend(problem.unknown().filter_map(|contact| errors.unknown_end(problem, &level.support, contact)));
    let of = |contact: usize| {
        let own = level.support.0.iter().zip(&level.counts).filter(|(interval, _)| interval.contact == contact);
        own.map(|(_, count)| *count).collect::<Vec<_>>()
    };
    let terms: Vec<Vec<usize>> = (0..problem.contacts()).map(of).collect();
    let stats = Stats {
        modes: terms.iter().map(|own| own.iter().copied().max().unwrap_or(1)).collect(),
        terms,
        newton_steps: work.steps.clone(),
        interpolated: work.interpolated,
        factorisations: work.factorisations,
        ..problem.kernel.stats()
    };
    let (contacts, closed) = (found(problem, &level, &errors), closed::found(problem, &level, &errors, &signs.closed));
    let closed = closed.ok_or(None)?;
    let (min_pressure, min_gap) = (signs.min_pressure, signs.min_gap);
    let force_error = if problem.prescribed.is_empty() { 0.0 } else { errors.force * level.solved.force };
    let force = [level.solved.force, force_error];
    Ok(Answer { contacts, closed, force, min_pressure, min_gap, rotations: level.solved.rotations, stats, warnings })
}

/// Whether terms resolve the layers at the faces of all contacts. Solutions with fewer terms do not tell their errors.
fn resolves(problem: &Problem, level: &Approximation) -> bool {
    level.support.0.iter().zip(&level.counts).all(|(interval, count)| *count >= resolving(problem, interval))
}

/// What is to be said of a tolerance that is not met, or beyond double precision.
fn precision(tolerance: f64, error: f64, terms: usize) -> Option<Warning> {
    if error > tolerance.max(BEST) {
        let message = format!(
            "the tolerance {tolerance:e} is not met with {terms} modes; the error estimates tell what was reached"
        );
        return Some(Warning::new(WarningCode::ToleranceNotMet, message));
    }
    let message = || {
        format!("a tolerance of {tolerance:e} is beyond double precision; the error estimates tell what was reached")
    };
    (tolerance < BEST).then(|| Warning::new(WarningCode::BeyondDoublePrecision, message()))
}

/// As many terms on each interval as are expected to meet a tolerance: errors are due to intervals as their last terms are large.
fn grown(level: &Approximation, errors: &Errors, tolerance: f64) -> Vec<usize> {
    let weights = level.last_terms();
    let heaviest = largest(weights.iter().copied());
    let grown = |(count, weight): (&usize, &f64)| {
        let error = if heaviest > 0.0 { errors.missing * weight / heaviest } else { errors.missing };
        if error < MINOR * tolerance {
            return *count;
        }
        let steps = (error / tolerance).ln() / -errors.fall.ln();
        let growth = LEAST_GROWTH.powf(steps.max(1.0)).min(MOST_GROWTH);
        ((growth * *count as f64) as usize).min(FINEST.max(*count))
    };
    level.counts.iter().zip(&weights).map(grown).collect()
}

impl Lengths {
    /// Of contacts with these numbers of terms; a prescribed traction has the lengths of the contact below.
    fn of(problem: &Problem, support: &Intervals, counts: &[usize], negligible: f64) -> Self {
        let (mut ends, mut shortest) = (Vec::new(), Vec::new());
        let (mut turned, mut exponentials) = (Vec::new(), Vec::new());
        let mut counts = counts.iter();
        for contact in 0..problem.contacts() {
            let intervals = support.of(contact);
            let reach = |interval: &ContactInterval| interval.to().max(-interval.from());
            ends.push(largest(intervals.iter().map(reach)));
            let least = intervals.iter().fold(f64::INFINITY, |least, interval| least.min(interval.half));
            let past =
                |(interval, count): (&ContactInterval, &usize)| turning(interval.order(count - 1) + 1) / interval.half;
            let past = largest(intervals.iter().zip(counts.by_ref()).map(past));
            // products of different intervals, or of one with its mirror image, oscillate as these are apart
            let is_one = intervals.len() < 2 && intervals.iter().all(|interval| interval.parity != Parity::Pair);
            let asymptote = problem.kernel.asymptote(contact);
            turned.push(match is_one {
                true => past,
                false if asymptote.is_constant() => f64::INFINITY,
                false => past.max(asymptote.exponentials_suffice(least, negligible)),
            });
            exponentials.push(if is_one { Vec::new() } else { asymptote.exponentials() });
            // nothing opens there
            shortest.push(if intervals.is_empty() && problem.is_opened(contact) { 1.0 } else { least });
        }
        for (i, side) in problem.sides.iter().enumerate() {
            if let Some(given) = side.given() {
                let all = shortest.iter().copied().fold(1.0, f64::min);
                let (end, least) = if problem.is_opened(i + 1) { (0.0, all) } else { (ends[i + 1], shortest[i + 1]) };
                (ends[i], shortest[i]) = (given.half_length.max(end), least);
            }
        }
        Self { ends, shortest, turned, exponentials }
    }

    /// Whether a layout that was made for contacts with these ends serves them.
    fn are_near(&self, about: &[f64]) -> bool {
        self.ends.iter().zip(about).all(|(a, b)| (a / b - 1.0).abs() < LAYOUT_SERVES)
    }
}

impl Approximation {
    /// The pressures in the middle of all intervals, per unit of P', without what sharp tips make, which is known.
    fn middle_pressures(&self, pressures: &[Pressure]) -> Vec<f64> {
        pressures.iter().enumerate().map(|(number, pressure)| self.middle_pressure(number, pressure)).collect()
    }

    /// The same of one interval.
    fn middle_pressure(&self, number: usize, pressure: &Pressure) -> f64 {
        let local = &self.local[number];
        let own = if local.terms.is_empty() { self.smooth(number, pressure) } else { pressure.clone() };
        let mut rest = Pressure { tip: Tip::default(), ..own };
        // of the pressure on a half-plane the sum of all terms is known
        rest.terms.iter_mut().zip(&local.terms).for_each(|(y, local)| *y -= local);
        rest.middle(&self.support.0[number]) + local.middle
    }

    /// The pressure of an interval in places from its right end inwards, to the middle of what is even, without what is singular at its ends. Next to a round edge that is much
    /// shorter than the interval terms do not tell the pressure in the middle, but what half-planes do there is known.
    fn inside(&self, problem: &Problem, number: usize, pressure: &Pressure) -> Vec<f64> {
        let interval = &self.support.0[number];
        let places = self.solved.pressures[number].places(interval);
        let mut inside = pressure.regular(interval).inside(interval, places);
        let is_told = interval.is_even() && !problem.sides[interval.contact].is_sharp();
        if let Some(middle) = inside.last_mut().filter(|_| is_told && !self.local[number].terms.is_empty()) {
            *middle = self.middle_pressure(number, pressure);
        }
        inside
    }

    /// How large the last third of the terms of each interval is, less what is known of them, and what averaging changes, as a part of the largest pressure of the contact.
    fn last_terms(&self) -> Vec<f64> {
        let middle = self.middle_pressures(&self.solved.pressures);
        let of = |((number, interval), pressure): ((usize, &ContactInterval), &Pressure)| {
            let smooth = self.smooth(number, pressure);
            let first = pressure.terms.len() - pressure.terms.len() / 3;
            let term = |(m, (y, smooth)): (usize, (&f64, &f64))| {
                let last = if m < first { 0.0 } else { (y - self.local[number].terms.get(m).unwrap_or(&0.0)).abs() };
                last.max((y - smooth).abs()) / interval.order(m) as f64
            };
            let sum: f64 = pressure.terms.iter().zip(&smooth.terms).enumerate().map(term).sum();
            interval.unit() * sum / self.largest_pressure(interval.contact, &middle)
        };
        self.support.0.iter().enumerate().zip(&self.solved.pressures).map(of).collect()
    }

    /// The largest of the pressures in the middle, or of the mean pressures, of the intervals of a contact.
    fn largest_pressure(&self, contact: usize, middle: &[f64]) -> f64 {
        let own = self.support.0.iter().enumerate().filter(|(_, interval)| interval.contact == contact);
        let of = |(number, interval): (usize, &ContactInterval)| {
            middle[number].abs().max(self.solved.pressures[number].mean(interval))
        };
        largest(own.map(of))
    }

    /// The pressure of an interval as it is given to the user: under a punch that is not smooth terms go on as on a half-plane, and next to a graded face the last partial sums are averaged.
    fn smooth(&self, number: usize, pressure: &Pressure) -> Pressure {
        let (interval, local) = (&self.support.0[number], &self.local[number].terms);
        if !local.is_empty() {
            let mut pressure = pressure.clone();
            continued(&mut pressure.terms, local);
            return pressure;
        }
        if self.graded[interval.contact] { pressure.averaged(interval) } else { pressure.clone() }
    }
}

/// What was found of each contact.
fn found(problem: &Problem, level: &Approximation, errors: &Errors) -> Vec<Contact> {
    let pressures = level.middle_pressures(&level.solved.pressures);
    let of = |contact: usize| {
        let first = level.support.0.partition_point(|interval| interval.contact < contact);
        let numbers = first..first + level.support.of(contact).len();
        let strip = |number: usize| {
            let interval = &level.support.0[number];
            level.smooth(number, &level.regular[number]).strip(interval)
        };
        let strips: Vec<Strip> = numbers.clone().map(strip).collect();
        let size = level.largest_pressure(contact, &pressures);
        let peak_error = size * largest(numbers.clone().map(|number| errors.pressures[number]));
        let ends = numbers.clone().map(|number| {
            let (interval, sizes) = (&level.support.0[number], level.support.0[number].sizes());
            let corner = |k: usize| problem.corner(contact, interval.punch, if k > 0 { 1.0 } else { -1.0 });
            let places = [interval.from(), interval.to()];
            // what is even begins at x = 0
            let is_corner = |k: usize| interval.corners[k] && (k > 0 || !interval.is_even());
            let places = [0, 1].map(|k| corner(k).filter(|_| is_corner(k)).unwrap_or(places[k]));
            let rounding = |k: usize| f64::EPSILON * places[k].abs();
            let error = |k: usize| match interval.corners[k] {
                true => 0.0,
                // of an end that is not found no more than all
                false if errors.ends[number][k] >= ENDLESS => sizes[k],
                false => errors.ends[number][k] * sizes[k] + rounding(k),
            };
            let [from, to] = [0, 1].map(|k| [places[k], error(k)]);
            solution::Interval::new(from, to)
        });
        let intervals: Vec<solution::Interval> = ends.collect();
        if level.support.of(contact).iter().all(|interval| interval.parity != Parity::None) {
            // the bodies may be apart about x = 0
            let peak = match &level.support.0[first] {
                first if !first.is_even() => [0.0; 2],
                _ if problem.sides[contact].is_sharp() => [f64::INFINITY, 0.0],
                _ => [pressures[first], peak_error],
            };
            return Contact::even(problem.interfaces[contact], &intervals, &strips, peak);
        }
        let force = |number: &usize| level.regular[*number].force(&level.support.0[*number]);
        let widest = numbers.clone().max_by(|a, b| force(a).total_cmp(&force(b)));
        let peak = widest.map_or(0.0, |widest| pressures[widest]);
        let numbers = level.support.of(contact).iter().map(|interval| interval.punch).collect();
        Contact::new(problem.interfaces[contact], intervals, strips, None, [peak, peak_error], numbers)
    };
    problem.unknown().filter(|contact| !problem.is_opened(*contact)).map(of).collect()
}
