//! Solutions under very many forces: found at fixed forces, and interpolated between them.
//!
//! All that is told of contacts under one punch is a smooth function of the force as long as their intervals are as many and bodies part nowhere else. So
//! solutions are found at forces that are evenly spaced in their logarithm, each one when it is first needed and like any other solution: no number depends on which
//! forces came before, or on who asked. Between them a polynomial tells each end and each coefficient of the pressures, and a polynomial through fewer of them how
//! well. Where that is not good enough, or the solutions nearby are of different kinds, a force is solved for by itself.
use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use crate::contact::error::ContactError;
use crate::contact::problem::accuracy::{BEST, SAFETY};
use crate::numeric::chebyshev::{barycentric_weights, interpolation_row};
use crate::numeric::largest;
use crate::scene::{Force, Top};
use crate::solution::{Carried, Contact, Interval, Solution, Stats, Strip};

/// Forces that are solved for are this far apart, in their logarithm. Twice as far: half as many are solved for, and every other scene with thin layers misses ten digits between them.
const APART: f64 = 0.1;
/// Solutions that a polynomial goes through; two fewer tell how well.
const POINTS: usize = 12;
/// They are found to this part of the tolerance, since the polynomial makes errors larger.
const PART: f64 = 0.1;

/// The solutions of one stack, for each punch, or loads, and tolerance, under forces or with something else prescribed, by the name of the latter.
#[derive(Debug, Default)]
pub(crate) struct Curves {
    all: Mutex<Vec<(Key, Arc<Curve>)>>,
}

type Key = (Top, u64, &'static str);

/// Solutions at the forces or depths exp(k [`APART`]), or at half-lengths half as far apart; none where there is none, or one with a warning.
#[derive(Debug, Default)]
struct Curve {
    points: Mutex<HashMap<i64, Arc<OnceLock<Option<Solution>>>>>,
}

impl Curves {
    /// Presses punches or loads with a force, or so that something else is as prescribed, to a tolerance; `press` presses to any tolerance with any force.
    pub(crate) fn press(
        &self,
        top: &Top,
        tolerance: f64,
        force: Force,
        press: impl Fn(f64, Force) -> Result<Solution, ContactError>,
    ) -> Result<Solution, ContactError> {
        let between = self.curve((top.clone(), tolerance.to_bits(), force.field())).between(tolerance, force, &press);
        between.map_or_else(|| press(tolerance, force), Ok)
    }

    /// How many numbers the solutions have that were found.
    pub(crate) fn stored_numbers(&self) -> usize {
        let all = self.all.lock().unwrap_or_else(PoisonError::into_inner);
        let of = |solution: &Solution| -> usize {
            let strips = solution.contacts.iter().flat_map(|contact| &contact.strips);
            strips.map(|strip| strip.coefficients.len() + strip.skew.len()).sum()
        };
        let of = |(_, curve): &(Key, Arc<Curve>)| -> usize {
            let points = curve.points.lock().unwrap_or_else(PoisonError::into_inner);
            points.values().filter_map(|point| point.get()?.as_ref().map(of)).sum()
        };
        all.iter().map(of).sum()
    }

    fn curve(&self, key: Key) -> Arc<Curve> {
        let mut all = self.all.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, curve)) = all.iter().rev().find(|(own, _)| *own == key) {
            return curve.clone();
        }
        let curve = Arc::<Curve>::default();
        all.push((key, curve.clone()));
        curve
    }
}

impl Curve {
    /// The solution under a force; `None` where it has to be solved for.
    fn between(
        &self,
        tolerance: f64,
        force: Force,
        press: impl Fn(f64, Force) -> Result<Solution, ContactError>,
    ) -> Option<Solution> {
        // a force grows about as the square of a half-length
        let apart = if let Force::ForHalfLength(_) = force { 0.5 * APART } else { APART };
        let place = force.number()?.ln() / apart;
        let first = place.floor() as i64 - (POINTS / 2 - 1) as i64;
        let slots: Vec<Arc<OnceLock<Option<Solution>>>> = {
            let mut points = self.points.lock().unwrap_or_else(PoisonError::into_inner);
            (first..).take(POINTS).map(|k| points.entry(k).or_default().clone()).collect()
        };
        let solve = |k: i64| {
            let solution = press((PART * tolerance).max(BEST), force.with((apart * k as f64).exp())).ok();
            solution.filter(|solution| solution.warnings.is_empty())
        };
        // those farthest away tell first where a curve ends
        let mut order: Vec<usize> = (0..POINTS).collect();
        order.sort_by_key(|k| k.min(&(POINTS - 1 - k)).to_owned());
        for k in order {
            slots[k].get_or_init(|| solve(first + k as i64)).as_ref()?;
        }
        let points: Option<Vec<&Solution>> = slots.iter().map(|slot| slot.get()?.as_ref()).collect();
        interpolated(&points?, place - first as f64, force, tolerance)
    }
}

/// The numbers of a solution that change with the force: some alone, others with their errors.
fn numbers(solution: &mut Solution) -> (Vec<&mut f64>, Vec<[&mut f64; 2]>) {
    let Solution { contacts, punches, rotations, force, force_error, min_pressure, min_gap, .. } = solution;
    let (mut alone, mut known) = (vec![min_pressure, min_gap], vec![[force, force_error]]);
    alone.extend(rotations);
    for Carried { force, tilt, moment } in punches {
        alone.extend([force, tilt, moment]);
    }
    for Contact { intervals, strips, middle_pressure: [middle, error], .. } in contacts {
        known.push([middle, error]);
        for Interval { left, left_error, right, right_error, .. } in intervals {
            known.extend([[left, left_error], [right, right_error]]);
        }
        for Strip { at, extent, coefficients, skew, corners, tip, tip_at, .. } in strips {
            alone.extend([at, extent, tip, tip_at]);
            alone.extend(corners.iter_mut().chain(coefficients).chain(skew));
        }
    }
    (alone, known)
}

/// Makes the series of all solutions as long as the longest; `None` if the solutions are not of one kind.
fn alike(points: &[&Solution]) -> Option<Vec<Solution>> {
    let kind = |solution: &Solution| -> Vec<[usize; 2]> {
        solution.contacts.iter().map(|contact| [contact.intervals.len(), contact.strips.len()]).collect()
    };
    if points.iter().any(|point| kind(point) != kind(points[0])) {
        return None;
    }
    let mut all: Vec<Solution> = points.iter().map(|point| (*point).clone()).collect();
    for (i, k) in
        (0..points[0].contacts.len()).flat_map(|i| (0..points[0].contacts[i].strips.len()).map(move |k| (i, k)))
    {
        let longest = |series: fn(&Strip) -> &Vec<f64>| {
            points.iter().map(|point| series(&point.contacts[i].strips[k]).len()).fold(0, usize::max)
        };
        let [terms, odd] = [longest(|strip| &strip.coefficients), longest(|strip| &strip.skew)];
        for own in &mut all {
            let strip = &mut own.contacts[i].strips[k];
            strip.coefficients.resize(terms, 0.0);
            strip.skew.resize(odd, 0.0);
        }
    }
    Some(all)
}

/// The solution at a place between others at 0, 1, 2, ...; `None` where it is not known to the tolerance.
fn interpolated(points: &[&Solution], place: f64, force: Force, tolerance: f64) -> Option<Solution> {
    let mut all = alike(points)?;
    let nodes: [f64; POINTS] = std::array::from_fn(|k| k as f64);
    let (mut row, mut fewer) = ([0.0; POINTS], [0.0; POINTS]);
    interpolation_row(&nodes, &barycentric_weights(&nodes), place, &mut row);
    let inner = &nodes[1..POINTS - 1];
    interpolation_row(inner, &barycentric_weights(inner), place, &mut fewer[1..POINTS - 1]);
    let mut between = all[POINTS / 2].clone();
    let parts: Vec<_> = all.iter_mut().map(numbers).collect();
    let (alone, known) = numbers(&mut between);
    for (k, into) in alone.into_iter().enumerate() {
        *into = parts.iter().zip(&row).map(|((alone, _), part)| part * *alone[k]).sum();
    }
    for (k, [value, error]) in known.into_iter().enumerate().filter(|(_, [value, _])| value.is_finite()) {
        let (mut sum, mut differ, mut errors) = (0.0, 0.0, 0.0);
        for ((_, known), (part, fewer)) in parts.iter().zip(row.iter().zip(&fewer)) {
            sum += part * *known[k][0];
            differ += (part - fewer) * *known[k][0];
            errors += (part * *known[k][1]).abs();
        }
        (*value, *error) = (sum, SAFETY * differ.abs() + errors);
    }
    if let Some(force) = force.given() {
        (between.force, between.force_error) = (force, 0.0);
    }
    let stats = Stats { newton_steps: Vec::new(), interpolated: 0, factorisations: 0, ..between.stats };
    let (min_pressure, min_gap) = (between.min_pressure.min(0.0), between.min_gap.min(0.0));
    let with_forces = |own: Contact| {
        Contact::new(own.interface, own.intervals, own.strips, own.about, own.middle_pressure, own.punches)
    };
    let contacts = between.contacts.into_iter().map(with_forces).collect();
    let between = Solution { contacts, min_pressure, min_gap, stats, ..between };
    let relative = between.contacts.iter().flat_map(|contact| {
        let of = |interval: &Interval| {
            interval.left_error.max(interval.right_error) / (0.5 * (interval.right - interval.left))
        };
        let [middle, error] = contact.middle_pressure;
        let is_known = middle == 0.0 || middle.is_infinite();
        let lost = (contact.resultant / between.force - 1.0).abs();
        let others = [if is_known { 0.0 } else { error / middle }, lost];
        contact.intervals.iter().map(of).chain(others).collect::<Vec<_>>()
    });
    let worst = largest(relative.chain([between.force_error / between.force]));
    (worst <= tolerance).then_some(between)
}
