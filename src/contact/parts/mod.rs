//! Contacts in several intervals: bodies that touch about the middle and again farther out, or are apart about the middle.
//!
//! The quadratic programme tells where bodies touch, roughly; Newton's method finds where exactly, with more and more
//! pressures on each interval until two numbers of them agree.
mod equations;
mod gaps;
mod patch;

use crate::contact::problem::accuracy::{ROUNDING, SAFETY};
use faer::Mat;
use faer::linalg::solvers::Solve;

use crate::contact::answer::{Answer, Found, stats};
use crate::contact::integrals::layout::{Layout, negligible};
use crate::contact::problem::Problem;
use crate::contact::programme::ActiveIntervals;
use crate::contact::quality::estimates::UNKNOWN;
use crate::kernel::Kernel;
use crate::numeric::largest;
use crate::solution::{Part, Solution, Stats, Strip};
use equations::Equations;
use patch::Patch;

/// Pressures on each interval: the first number of them, doubled until the tolerance is met, and the last.
const COARSEST: usize = 12;
const FINEST: usize = 96;
/// Multiplications at most, all starts together: some seconds. The hardest scene that is known to be solved needs two thirds of
/// it; with twice as many, scenes that are not solved take twice the time.
const MOST_OPERATIONS: f64 = 1.5e11;
/// An end moves by at most this part of the intervals next to it in one step.
const LONGEST_STEP: f64 = 0.4;
/// Derivatives are kept as long as steps, in units of those intervals, are shorter than this, and become so many times shorter.
const KEPT: f64 = 0.1;
/// Derivatives are differences over this part of the intervals next to an end.
const DIFFERENCE: f64 = 1e-6;
const SHORT: f64 = 1e-7;
/// Integrals serve ends that have moved by this part at most.
const SERVES: f64 = 0.02;

/// What Newton's method has done, all attempts together.
#[derive(Default)]
struct Work {
    /// Steps for each number of pressures.
    steps: Vec<usize>,
    /// Multiplications, about, see [`MOST_OPERATIONS`].
    operations: f64,
}

impl Work {
    /// Counts equations of a size, with integrals over so many wavenumbers; `None` if they are too many.
    fn spend(&mut self, size: usize, wavenumbers: usize, times: usize) -> Option<()> {
        self.operations += times as f64 * (wavenumbers + size) as f64 * (size * size) as f64;
        (self.operations <= MOST_OPERATIONS).then_some(())
    }
}

/// Ends and pressures for one number of pressures.
#[derive(Clone)]
struct Level {
    patches: Vec<Patch>,
    /// c_j of each patch, per unit of P'.
    coefficients: Vec<Vec<f64>>,
    /// Length of the last step, relative.
    last_step: f64,
    /// For each contact, what is left of its kernel where integrals end, relative, over the wavenumber there.
    left_out: Vec<f64>,
}

/// Presses a punch on a stack some contacts of which have several parts, about where `active` says; `None` if no
/// admissible answer was found, or the pressure under the punch is of another kind.
pub(super) fn solve(problem: &Problem, active: &[ActiveIntervals]) -> Option<Solution> {
    if problem.sides.iter().any(|side| side.is_flat() || side.is_sharp()) {
        return None;
    }
    let all = patches(problem, active, |active| active.intervals().to_vec())?;
    // the programme may see several intervals, far out, where there is one with next to no force
    let merged = patches(problem, active, ActiveIntervals::merged)?;
    let fewer = (merged != all).then_some(merged);
    let starts = [Some(all), fewer].into_iter().flatten();
    let mut work = Work::default();
    starts
        .flat_map(|patches| [false, true].map(|joint| (patches.clone(), joint)))
        .find_map(|(patches, joint)| solve_from(problem, patches, joint, &mut work))
}

/// The same from given intervals.
fn solve_from(problem: &Problem, patches: Vec<Patch>, joint: bool, work: &mut Work) -> Option<Solution> {
    let negligible = negligible(problem.tolerance);
    work.steps.clear();
    let mut before: Option<Level> = None;
    let mut best: Option<([Level; 2], Errors, usize)> = None;
    let mut count = COARSEST;
    while count <= FINEST {
        let start = before.as_ref().map_or(&patches, |before| &before.patches);
        let level = [true, false]
            .map(|together| Way { together, joint })
            .into_iter()
            .find_map(|way| converge(problem, start.clone(), count, negligible, way, work));
        let Some(level) = level else {
            // where neither few nor some will do, more will not
            if best.is_some() || count > COARSEST {
                break;
            }
            count *= 2;
            continue;
        };
        if let Some(before) = before.replace(level.clone()) {
            let errors = Errors::between(&level, &before);
            // more pressures do not help against what is due to something else
            let done = errors.worst() <= problem.tolerance.max(2.0 * errors.floor);
            if best.as_ref().is_none_or(|(_, best, _)| errors.worst() < best.worst()) {
                best = Some(([level, before], errors, count));
            }
            if done {
                break;
            }
        }
        count *= 2;
    }
    let ([level, coarse], mut errors, count) = best?;
    if errors.ends.iter().flatten().any(|error| error.is_nan() || *error > UNKNOWN) || errors.worst().is_nan() {
        return None;
    }
    let mut warnings = Vec::new();
    if errors.worst() > problem.tolerance {
        warnings.push(format!(
            "the tolerance {:e} is not met with {count} pressures on each interval of contacts in several parts; the error \
             estimates tell what was reached",
            problem.tolerance
        ));
    }
    let (min, tensions) = gaps::check(problem, &level, &coarse)?;
    // pressures in tension are wrong by that
    errors.peaks.iter_mut().zip(&tensions).for_each(|(error, tension)| *error = error.max(SAFETY * tension));
    let [min_pressure, min_gap] = min;
    let stats =
        Stats { modes: vec![count; problem.contacts()], newton_steps: work.steps.clone(), ..stats(problem.kernel) };
    let contacts = found(&level, &errors);
    Some(Answer { contacts, min_pressure, min_gap, stats, warnings }.into_solution(problem))
}

/// Intervals to begin with, none where the pressure is given; `None` if a contact has none, or one that does not end.
fn patches(
    problem: &Problem,
    active: &[ActiveIntervals],
    intervals: impl Fn(&ActiveIntervals) -> Vec<[f64; 2]>,
) -> Option<Vec<Patch>> {
    let mut patches = Vec::new();
    for (contact, active) in active.iter().enumerate().skip(usize::from(problem.top().given().is_some())) {
        let parts = intervals(active);
        if parts.is_empty() || parts.iter().any(|part| part[1].is_infinite()) {
            return None;
        }
        patches.extend(parts.iter().map(|part| Patch::new(contact, *part)));
    }
    Some(patches)
}

/// The innermost interval of each contact.
fn first_of_each(patches: &[Patch]) -> impl Iterator<Item = usize> {
    (0..patches.len()).filter(|i| i.checked_sub(1).is_none_or(|before| patches[before].contact != patches[*i].contact))
}

/// Where intervals end, from the middle outwards.
fn ends(patches: &[Patch]) -> Vec<f64> {
    let own = |patch: &Patch| if patch.is_central() { vec![patch.to()] } else { vec![patch.from(), patch.to()] };
    patches.iter().flat_map(own).collect()
}

/// Intervals like others, with other ends; `None` if they are none.
fn with_ends(patches: &[Patch], ends: &[f64]) -> Option<Vec<Patch>> {
    let mut next = 0;
    let mut moved = Vec::with_capacity(patches.len());
    for patch in patches {
        let from = if patch.is_central() { 0.0 } else { ends[next] };
        next += usize::from(!patch.is_central());
        let to = ends[next];
        next += 1;
        if !to.is_finite() || to <= from || from <= 0.0 && !patch.is_central() {
            return None;
        }
        moved.push(Patch::new(patch.contact, [from, to]));
    }
    let apart = |pair: &[Patch]| pair[0].contact != pair[1].contact || pair[0].to() < pair[1].from();
    moved.windows(2).all(apart).then_some(moved)
}

/// The shorter of the intervals that meet in each end.
fn rooms(patches: &[Patch]) -> Vec<f64> {
    let mut rooms = Vec::new();
    for (i, patch) in patches.iter().enumerate() {
        let whole = patch.to() - patch.from();
        let same = |other: &&Patch| other.contact == patch.contact;
        if !patch.is_central() {
            let before = i.checked_sub(1).and_then(|before| patches.get(before)).filter(same);
            // what is left of x = 0 is a mirror image
            rooms.push(whole.min(patch.from() - before.map_or(0.0, Patch::to)));
        }
        rooms.push(patches.get(i + 1).filter(same).map_or(whole, |after| whole.min(after.from() - patch.to())));
    }
    rooms
}

/// How far each contact reaches, and half of its shortest interval; a given pressure is felt by the contact below only.
fn lengths(problem: &Problem, patches: &[Patch]) -> [Vec<f64>; 2] {
    let of = |i: usize| patches.iter().filter(move |patch| patch.contact == i);
    let ends = (0..problem.contacts()).map(|i| of(i).map(Patch::to).fold(0.0, f64::max));
    let shortest = (0..problem.contacts()).map(|i| of(i).map(|patch| patch.half).fold(f64::INFINITY, f64::min));
    let (mut ends, mut shortest): (Vec<f64>, Vec<f64>) = (ends.collect(), shortest.collect());
    if let Some(given) = problem.top().given() {
        (ends[0], shortest[0]) = (given.half_length.max(ends[1]), shortest[1]);
    }
    [ends, shortest]
}

/// How Newton's method goes on after a step.
#[derive(Clone, Copy)]
struct Way {
    /// Long steps of the ends are shortened all together, or each alone.
    together: bool,
    /// Pressures take their part of the step, or are solved for anew at the new ends.
    ///
    /// Where a layer without weight spans the gap between two intervals, there are ends nearby for which no pressures are in
    /// equilibrium: residuals as functions of the ends alone have poles there, so that pressures have to move with the ends. Where
    /// an interval carries next to nothing, that may lead to other roots, and pressures are better solved for anew.
    joint: bool,
}

/// Newton's method for the ends and the pressures; `None` if it is lost.
fn converge(
    problem: &Problem,
    mut patches: Vec<Patch>,
    count: usize,
    negligible: f64,
    way: Way,
    work: &mut Work,
) -> Option<Level> {
    let kernel = problem.kernel;
    let mut layout: Option<(Layout, Vec<f64>)> = None;
    let mut kept: Option<Mat<f64>> = None;
    let mut pressures: Option<Vec<f64>> = None;
    let mut last = f64::INFINITY;
    let mut limit = LONGEST_STEP;
    let mut moved_by: Vec<f64> = Vec::new();
    work.steps.push(0);
    for _ in 0..FINEST {
        let [reach, shortest] = lengths(problem, &patches);
        let serves = |about: &Vec<f64>| reach.iter().zip(about).all(|(a, b)| (a / b - 1.0).abs() < SERVES);
        let (waves, about) = match layout.take().filter(|(_, about)| serves(about)) {
            Some(kept) => kept,
            None => (Layout::without_tails(kernel, &reach, &shortest, negligible, 0.0)?, reach),
        };
        let system = |patches: &[Patch]| Equations { kernel, problem, layout: &waves, patches, count }.system();
        work.spend(patches.len() * count, waves.zeta.len(), 1)?;
        let here = system(&patches);
        *work.steps.last_mut()? += 1;
        let (at, rooms) = (ends(&patches), rooms(&patches));
        // to begin with, the pressures that go with these ends
        let mut own = match pressures.take() {
            Some(own) => own,
            None => here.pressures()?,
        };
        let residuals = here.residuals(&own);
        let derivatives = match kept.take() {
            Some(kept) => kept,
            None => {
                work.spend(patches.len() * count, waves.zeta.len(), at.len())?;
                let residuals_at = |ends: &[f64]| Some(system(&with_ends(&patches, ends)?).residuals(&own));
                derivatives(&at, &rooms, &residuals, residuals_at)?
            }
        };
        let (change, step) = newton_step(&here.matrix, &derivatives, &residuals)?;
        let longest = step.iter().fold(0.0, |longest: f64, step| longest.max(step.abs()));
        let shorten = if way.together { (LONGEST_STEP / longest).min(1.0) } else { 1.0 };
        own.iter_mut().zip(&change).for_each(|(own, change)| *own += shorten * change);
        if longest < ROUNDING || last < SHORT && longest > 0.5 * last {
            let left_out =
                (0..kernel.contacts()).map(|i| left_out(kernel, &waves, i, shortest[i], negligible)).collect();
            let coefficients = in_equilibrium(&patches, own.chunks_exact(count).map(<[f64]>::to_vec).collect());
            return Some(Level { patches, coefficients, last_step: longest, left_out });
        }
        kept = (longest < KEPT * last && longest < KEPT).then_some(derivatives);
        last = longest;
        // an end where the pressure is next to nothing is known badly, and does not hold up the others; steps back and
        // forth grow shorter
        let back = moved_by.iter().zip(&step).map(|(before, step)| before * step).sum::<f64>() < 0.0;
        limit = if back && !way.together { 0.5 * limit } else { (1.5 * limit).min(LONGEST_STEP) };
        moved_by = step.iter().map(|step| (shorten * step).clamp(-limit, limit)).collect();
        let moved: Vec<f64> =
            at.iter().zip(&moved_by).zip(&rooms).map(|((end, step), room)| end + step * room).collect();
        patches = with_ends(&patches, &moved)?;
        pressures = way.joint.then_some(own);
        layout = Some((waves, about));
    }
    None
}

/// The pressures with exactly the resultant of the force in each contact: the ends have moved since they were found.
fn in_equilibrium(patches: &[Patch], mut coefficients: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let pairs = || patches.iter().enumerate();
    let resultants: Vec<f64> = pairs()
        .map(|(_, patch)| {
            let own = pairs().filter(|(_, other)| other.contact == patch.contact);
            own.map(|(k, other)| coefficients[k][0] * other.resultant()).sum()
        })
        .collect();
    for (own, resultant) in coefficients.iter_mut().zip(resultants) {
        own.iter_mut().for_each(|c| *c /= resultant);
    }
    coefficients
}

/// Derivatives of the residuals with respect to the ends, in units of the intervals next to each of them.
fn derivatives(
    ends: &[f64],
    rooms: &[f64],
    residuals: &[f64],
    residuals_at: impl Fn(&[f64]) -> Option<Vec<f64>>,
) -> Option<Mat<f64>> {
    let mut derivatives = Mat::zeros(residuals.len(), ends.len());
    for by in 0..ends.len() {
        let mut moved = ends.to_vec();
        moved[by] += DIFFERENCE * rooms[by];
        for (row, (there, here)) in residuals_at(&moved)?.iter().zip(residuals).enumerate() {
            derivatives[(row, by)] = (there - here) / DIFFERENCE;
        }
    }
    Some(derivatives)
}

/// Changes of the pressures, and steps of the ends in units of the intervals next to each of them; `None` if they are no numbers.
fn newton_step(matrix: &Mat<f64>, derivatives: &Mat<f64>, residuals: &[f64]) -> Option<(Vec<f64>, Vec<f64>)> {
    let (size, ends) = (matrix.ncols(), derivatives.ncols());
    let all = Mat::from_fn(size + ends, size + ends, |row, column| match column.checked_sub(size) {
        None => matrix[(row, column)],
        Some(by) => derivatives[(row, by)],
    });
    let right = Mat::from_fn(residuals.len(), 1, |row, _| -residuals[row]);
    let found = all.partial_piv_lu().solve(&right);
    let (change, step) = found.col_as_slice(0).split_at(size);
    found.col_as_slice(0).iter().all(|value| value.is_finite()).then(|| (change.to_vec(), step.to_vec()))
}

/// What is left of the kernel of a contact where its integrals end, relative to its limit, over the wavenumber there.
fn left_out(kernel: &Kernel, layout: &Layout, i: usize, shortest: f64, negligible: f64) -> f64 {
    let end = layout.zeta[..layout.own[i].reach].last().copied().unwrap_or(0.0);
    if kernel.vanishes(i, shortest, negligible) <= end {
        return 0.0;
    }
    (kernel.unit_excess(i, end) / kernel.far(i).limit).abs() / end
}

/// By how much two levels differ.
struct Errors {
    /// Of the ends of each patch, relative.
    ends: Vec<[f64; 2]>,
    /// Of p(0) of each contact, relative.
    peaks: Vec<f64>,
    /// The most that is due to something else than the number of pressures.
    floor: f64,
}

impl Errors {
    fn between(level: &Level, before: &Level) -> Self {
        let change = |new: f64, old: f64| if new == 0.0 { 0.0 } else { SAFETY * (new / old - 1.0).abs() };
        // short waves are felt where a patch is short
        let rest = |patch: &Patch| level.last_step + 10.0 * ROUNDING + level.left_out[patch.contact] / patch.half;
        let ends = level.patches.iter().zip(&before.patches).map(|(new, old)| {
            let rest = rest(new);
            [change(new.from(), old.from()) + rest, change(new.to(), old.to()) + rest]
        });
        let peaks = level.peaks().zip(before.peaks()).zip(first_of_each(&level.patches));
        let peaks = peaks.map(|((new, old), i)| {
            // none where the bodies are apart
            if new == 0.0 { 0.0 } else { change(new, old) + rest(&level.patches[i]) }
        });
        let peaks = peaks.collect();
        let floor = largest(level.patches.iter().map(rest));
        Self { ends: ends.collect(), peaks, floor }
    }

    fn worst(&self) -> f64 {
        largest(self.ends.iter().flatten().chain(&self.peaks).copied())
    }
}

impl Level {
    /// p(0) of each contact, per unit of P'.
    fn peaks(&self) -> impl Iterator<Item = f64> {
        first_of_each(&self.patches).map(|i| self.patches[i].pressure(&self.coefficients[i], 0.0))
    }
}

/// What was found of each contact.
fn found(level: &Level, errors: &Errors) -> Vec<Found> {
    let mut contacts: Vec<(usize, Found)> = Vec::new();
    let all = level.patches.iter().zip(&level.coefficients).zip(&errors.ends);
    let mut peaks = level.peaks().zip(&errors.peaks);
    for ((patch, coefficients), [from_error, to_error]) in all {
        let (from, to) = (patch.from(), patch.to());
        let interval = Part { from, from_error: from_error * from, to, to_error: to_error * to };
        let strip = if patch.is_central() {
            Strip::series(patch.half, coefficients.clone())
        } else {
            let every_other = |first: usize| coefficients.iter().skip(first).step_by(2).copied().collect();
            Strip { at: patch.middle, skew: every_other(1), ..Strip::series(patch.half, every_other(0)) }
        };
        match contacts.last_mut().filter(|(contact, _)| *contact == patch.contact) {
            None => {
                let (peak, error) = peaks.next().unwrap_or((0.0, &0.0));
                let peak_error = error * peak.abs();
                let own = Found { intervals: vec![interval], peak, peak_error, strips: vec![strip] };
                contacts.push((patch.contact, own));
            }
            Some((_, found)) => {
                found.intervals.push(interval);
                found.strips.push(strip);
            }
        }
    }
    contacts.into_iter().map(|(_, found)| found).collect()
}
