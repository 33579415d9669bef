//! The ends of all intervals at which no pressure is singular.
//!
//! The sign of the intensity q says which way an end has to go: inwards where it is negative, for the contact is too long there. Next to the
//! end the pressure is unit (κφ + q/φ), of an end farther out by w q/κ.
use std::f64::consts::PI;

use crate::contact::ends::broyden::Secants;
use crate::contact::integrals::layout::{Layout, negligible};
use crate::contact::intervals::columns::Pressure;
use crate::contact::intervals::equations::Equations;
use crate::contact::intervals::support::{End, Support};
use crate::contact::intervals::{Lengths, Work};
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::PER_MODE;
use crate::contact::problem::iteration::Progress;

/// Most of the way to the next interval, and of its own length, that an end goes in one step.
const MOST_OUT: f64 = 0.4;
const MOST_IN: f64 = 0.9;
/// The longest step outwards, in half-lengths.
const FARTHEST: f64 = 0.3;
/// Where the pressure is negative up to so far from an end, in half-lengths, it says where the contact ends.
const TENSION: f64 = 0.13;
/// Steps at most.
const MOST_STEPS: usize = 40;
/// Steps that are shorter, in half-lengths, are Newton's.
const SHORT: f64 = 0.1;
/// An end with a weaker singularity, in units of the mean pressure, need not be known.
const WEAK: f64 = 1e-9;

/// Ends and pressures for one number of terms.
#[derive(Clone)]
pub(super) struct Level {
    pub(super) support: Support,
    /// Terms of each interval.
    pub(super) counts: Vec<usize>,
    /// Of each contact.
    pub(super) pressures: Vec<Pressure>,
    /// The last step of each end, in half-lengths.
    pub(super) steps: Vec<f64>,
    /// For each contact, what is left of its kernel where integrals end, relative, over the wavenumber there.
    pub(super) left_out: Vec<f64>,
}

/// What the pressure says of one end.
struct Look {
    q: f64,
    /// The step outwards, in half-lengths.
    step: f64,
}

/// Moves ends until no pressure is singular; `None` if that does not converge.
pub(super) fn converge(
    problem: &Problem,
    mut support: Support,
    counts: &[usize],
    enough: f64,
    work: &mut Work,
) -> Option<Level> {
    let negligible = negligible(problem.tolerance);
    let mut kept: Option<(Layout, Vec<f64>)> = None;
    let mut progress = Progress::default();
    let mut secants = Secants::default();
    let mut limits = Limits::default();
    work.steps.push(0);
    loop {
        let lengths = Lengths::of(problem, &support);
        let (layout, about) = match kept.take().filter(|(_, about)| lengths.are_near(about)) {
            Some(kept) => kept,
            None => {
                let Lengths { ends, shortest } = &lengths;
                (Layout::without_tails(problem.kernel, ends, shortest, negligible, 0.0)?, ends.clone())
            }
        };
        let terms: usize = counts.iter().sum();
        work.spend(terms, layout.zeta.len())?;
        *work.steps.last_mut()? += 1;
        let pressures = Equations::new(problem, &layout, &support, counts).solve()?;
        let looks = looks(&support, counts, &pressures);
        let mut steps: Vec<f64> = looks.iter().map(|look| look.step).collect();
        let size =
            |(look, step): (&Look, &f64)| if look.q.abs() < WEAK && step.abs() > SHORT { 0.0 } else { step.abs() };
        let longest = looks.iter().zip(&steps).map(size).fold(0.0, f64::max);
        if longest < enough || progress.is_rounding(longest, 1e-7) {
            let left_out = |i: usize| super::left_out(problem.kernel, &layout, i, lengths.shortest[i], negligible);
            let left_out = (0..problem.contacts()).map(left_out).collect();
            return Some(Level { support, counts: counts.to_vec(), pressures, steps, left_out });
        }
        if !progress.goes_on(longest) || work.steps.last() > Some(&MOST_STEPS) {
            return None;
        }
        if longest < SHORT {
            secants.improve(&Vec::new(), &mut Vec::new(), &mut steps);
        } else {
            secants = Secants::default();
        }
        for (look, step) in looks.iter().zip(&mut steps) {
            if look.q.abs() < WEAK && step.abs() > SHORT {
                *step = 0.0;
            }
        }
        limits.limit(&mut steps);
        support = moved(problem, &support, &steps)?;
        kept = Some((layout, about));
    }
}

/// How far each end may move, in half-lengths: steps back and forth grow shorter.
#[derive(Default)]
struct Limits {
    before: Vec<f64>,
    limits: Vec<f64>,
}

impl Limits {
    fn limit(&mut self, steps: &mut [f64]) {
        self.limits.resize(steps.len(), 1.0);
        self.before.resize(steps.len(), 0.0);
        for ((step, limit), before) in steps.iter_mut().zip(&mut self.limits).zip(&mut self.before) {
            *limit = if *step * *before < 0.0 { 0.5 * before.abs() } else { (2.0 * *limit).min(1.0) };
            *step = step.clamp(-*limit, *limit);
            *before = *step;
        }
    }
}

/// Takes steps, none longer than allowed; `None` if intervals vanish.
fn moved(problem: &Problem, support: &Support, steps: &[f64]) -> Option<Support> {
    let limited = support.ends().into_iter().zip(steps).map(|(end, step)| {
        let interval = &support.0[end.interval];
        let outwards = (step * interval.half).clamp(-MOST_IN * interval.half, interval.half);
        let outwards = outwards.min(MOST_OUT * support.gap(end));
        let place = support.place(end);
        let side = &problem.sides[interval.contact];
        if end.side > 0.0 { side.within(place, place + outwards) - place } else { outwards }
    });
    let moved = support.moved(&limited.collect::<Vec<_>>());
    moved.0.iter().all(|interval| interval.half > 0.0 && interval.half.is_finite()).then_some(moved)
}

/// What pressures say of all ends.
fn looks(support: &Support, counts: &[usize], pressures: &[Pressure]) -> Vec<Look> {
    let ends = support.ends();
    let mut looks = Vec::with_capacity(ends.len());
    let (mut contact, mut at) = (usize::MAX, 0);
    let mut first = 0;
    for (number, end) in ends.iter().enumerate() {
        let interval = &support.0[end.interval];
        if interval.contact != contact {
            (contact, at, first) = (interval.contact, 0, 0);
        }
        let terms = &pressures[contact].terms[first..first + counts[end.interval]];
        let q = pressures[contact].singular[at];
        let sides = interval.sides().len();
        let own_first = at - usize::from(sides == 2 && end.side > 0.0);
        let singular = &pressures[contact].singular[own_first..own_first + sides];
        looks.push(Look { q, step: step(support, *end, terms, singular, q) });
        at += 1;
        if ends.get(number + 1).is_none_or(|next| next.interval != end.interval) {
            first += counts[end.interval];
        }
    }
    looks
}

/// The step of an end outwards, in half-lengths.
fn step(support: &Support, end: End, terms: &[f64], singular: &[f64], q: f64) -> f64 {
    let interval = &support.0[end.interval];
    let sign = |m: usize| if end.side > 0.0 || interval.order(m) % 2 == 1 { 1.0 } else { -1.0 };
    // the last terms, which truncation changes most, do not count
    let smooth = |m: usize| (-12.0 * (m as f64 / terms.len() as f64).powi(4)).exp();
    let kappa: f64 = terms.iter().enumerate().map(|(m, y)| smooth(m) * sign(m) * y).sum();
    if q > 0.0 {
        return if kappa > 0.0 { ((1.0 + 2.0 * q / kappa).sqrt() - 1.0).min(FARTHEST) } else { FARTHEST };
    }
    // how far from the end the pressure is negative, seen from its largest value
    let places = PER_MODE * interval.order(terms.len() - 1);
    let angle = |k: usize| {
        let phi = PI * (k as f64 + 0.5) / places as f64;
        if end.side > 0.0 { phi } else { PI - phi }
    };
    let all: Vec<f64> = (0..places).map(|k| pressure(interval.order(1) - 1, terms, singular, angle(k))).collect();
    let last = if interval.is_central() { places / 2 } else { places - 1 };
    let largest = (0..=last).max_by(|a, b| all[*a].total_cmp(&all[*b])).unwrap_or(0);
    let zero = all[..largest].iter().rposition(|p| *p < 0.0);
    let newton = if kappa > 0.0 { q / kappa } else { f64::NEG_INFINITY };
    let distance = match zero {
        Some(zero) => {
            let part = all[zero] / (all[zero] - all[zero + 1]);
            let phi = PI * (zero as f64 + 0.5 + part) / places as f64;
            1.0 - phi.cos()
        }
        None if newton.is_finite() => -0.5 * newton,
        None => 1.0 - (PI * 0.5 / places as f64).cos(),
    };
    if distance > TENSION || kappa <= 0.0 { -distance.min(MOST_IN) } else { newton.max(-2.2 * distance) }
}

/// The pressure at an angle φ, over the unit of the interval: orders of terms are 1, 1 + by, ...
pub(super) fn pressure(by: usize, terms: &[f64], singular: &[f64], phi: f64) -> f64 {
    let regular = |(m, y): (usize, &f64)| {
        let order = (1 + m * by) as f64;
        y / order * (order * phi).sin()
    };
    let (sin, cos) = phi.sin_cos();
    let at_ends = match singular {
        [q] => *q,
        [left, right] => 0.5 * (left * (1.0 - cos) + right * (1.0 + cos)),
        _ => 0.0,
    };
    terms.iter().enumerate().map(regular).sum::<f64>() + at_ends / sin
}
