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
        let place = force.number().ln() / apart;
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
        Between::new(points?, place - first as f64)?.solution(force, tolerance)
    }
}

/// Solutions of one kind at neighbouring forces, and what each of them contributes to the one between.
struct Between<'a> {
    points: Vec<&'a Solution>,
    row: [f64; POINTS],
    /// The same without the first and the last one.
    fewer: [f64; POINTS],
}

impl<'a> Between<'a> {
    /// `None` if not all of them are of one kind.
    fn new(points: Vec<&'a Solution>, place: f64) -> Option<Self> {
        let kind = |solution: &Solution| -> Vec<(usize, usize)> {
            solution.contacts.iter().map(|contact| (contact.intervals.len(), contact.strips.len())).collect()
        };
        let own = kind(points[0]);
        if points.iter().any(|point| kind(point) != own) {
            return None;
        }
        let nodes: [f64; POINTS] = std::array::from_fn(|k| k as f64);
        let (mut row, mut fewer) = ([0.0; POINTS], [0.0; POINTS]);
        interpolation_row(&nodes, &barycentric_weights(&nodes), place, &mut row);
        let inner = &nodes[1..POINTS - 1];
        interpolation_row(inner, &barycentric_weights(inner), place, &mut fewer[1..POINTS - 1]);
        Some(Self { points, row, fewer })
    }

    /// A number between, and how well it is known for want of solutions.
    fn number(&self, of: impl Fn(&Solution) -> f64) -> [f64; 2] {
        let (mut sum, mut differ) = (0.0, 0.0);
        for (point, (part, fewer)) in self.points.iter().zip(self.row.iter().zip(&self.fewer)) {
            let value = of(point);
            sum += part * value;
            differ += (part - fewer) * value;
        }
        [sum, SAFETY * differ.abs()]
    }

    fn value(&self, of: impl Fn(&Solution) -> f64) -> f64 {
        self.points.iter().zip(&self.row).map(|(point, part)| part * of(point)).sum()
    }

    /// A number between with its error.
    fn known(&self, of: impl Fn(&Solution) -> f64, error: impl Fn(&Solution) -> f64) -> [f64; 2] {
        let [value, between] = self.number(of);
        let parts = self.points.iter().zip(&self.row).map(|(point, part)| (part * error(point)).abs());
        [value, between + parts.sum::<f64>()]
    }

    /// The solution between; `None` where it is not known to the tolerance.
    fn solution(&self, force: Force, tolerance: f64) -> Option<Solution> {
        let one = self.points[POINTS / 2];
        let [force, force_error] = match force.given() {
            Some(force) => [force, 0.0],
            None => self.known(|point| point.force, |point| point.force_error),
        };
        let contacts: Vec<Contact> = (0..one.contacts.len()).map(|i| self.contact(i)).collect();
        let relative = contacts.iter().flat_map(|contact| {
            let of = |interval: &Interval| {
                interval.left_error.max(interval.right_error) / (0.5 * (interval.right - interval.left))
            };
            let [middle, error] = contact.middle_pressure;
            let (pressure, is_known) = (error / middle, middle == 0.0 || middle.is_infinite());
            let lost = (contact.resultant / force - 1.0).abs();
            contact.intervals.iter().map(of).chain([if is_known { 0.0 } else { pressure }, lost]).collect::<Vec<_>>()
        });
        let worst = largest(relative.chain([force_error / force]));
        let is_known = worst <= tolerance;
        let punches = |k: usize| Carried {
            force: self.value(|point| point.punches[k].force),
            tilt: self.value(|point| point.punches[k].tilt),
            moment: self.value(|point| point.punches[k].moment),
        };
        is_known.then(|| Solution {
            stack: one.stack.clone(),
            contacts,
            force,
            force_error,
            controlled: one.controlled,
            punches: (0..one.punches.len()).map(punches).collect(),
            rotations: (0..one.rotations.len()).map(|k| self.value(|point| point.rotations[k])).collect(),
            min_pressure: self.value(|point| point.min_pressure).min(0.0),
            min_gap: self.value(|point| point.min_gap).min(0.0),
            stats: Stats { newton_steps: Vec::new(), interpolated: 0, factorisations: 0, ..one.stats.clone() },
            warnings: Vec::new(),
        })
    }

    fn contact(&self, i: usize) -> Contact {
        let one = &self.points[POINTS / 2].contacts[i];
        let interval = |k: usize| {
            let of = |point: &Solution| point.contacts[i].intervals[k];
            let left = self.known(|point| of(point).left, |point| of(point).left_error);
            Interval::new(left, self.known(|point| of(point).right, |point| of(point).right_error))
        };
        let middle = |point: &Solution| point.contacts[i].middle_pressure;
        let middle = match one.middle_pressure[0].is_finite() {
            true => self.known(|point| middle(point)[0], |point| middle(point)[1]),
            false => one.middle_pressure,
        };
        let strips: Vec<Strip> = (0..one.strips.len()).map(|k| self.strip(i, k)).collect();
        let intervals = (0..one.intervals.len()).map(interval).collect();
        Contact::new(one.interface, intervals, strips, one.about, middle, one.punches.clone())
    }

    fn strip(&self, i: usize, k: usize) -> Strip {
        let of = |point: &'a Solution| &point.contacts[i].strips[k];
        let series = |own: fn(&Strip) -> &Vec<f64>| -> Vec<f64> {
            let most = self.points.iter().map(|point| own(of(point)).len()).fold(0, usize::max);
            let mut sums = vec![0.0; most];
            for (point, part) in self.points.iter().zip(&self.row) {
                sums.iter_mut().zip(own(of(point))).for_each(|(sum, value)| *sum += part * value);
            }
            sums
        };
        let number = |own: &dyn Fn(&Strip) -> f64| self.value(|point| own(&point.contacts[i].strips[k]));
        let one = of(self.points[POINTS / 2]);
        Strip {
            at: number(&|strip| strip.at),
            extent: number(&|strip| strip.extent),
            coefficients: series(|strip| &strip.coefficients),
            skew: series(|strip| &strip.skew),
            corners: [0, 1].map(|side| number(&|strip| strip.corners[side])),
            tip: number(&|strip| strip.tip),
            tip_at: number(&|strip| strip.tip_at),
            form: one.form,
            is_round: one.is_round,
        }
    }
}
