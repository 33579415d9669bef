//! No pressure may be tension, and no gap penetrated, between the parts of a contact and beyond them.
use crate::contact::problem::accuracy::{COARSE, PER_MODE, PLACES, SAFETY};
use std::f64::consts::{FRAC_PI_2, PI};

use crate::contact::integrals::layout::{FIELDS, Layout, negligible};
use crate::contact::parts::equations::Equations;
use crate::contact::parts::interval::Interval;
use crate::contact::parts::{Lengths, Level};
use crate::contact::problem::Problem;
use crate::numeric::quadrature::rule;

/// What the check found, per unit of P'.
pub(super) struct Check {
    /// Smallest pressure in the contacts, and smallest gap outside.
    pub(super) min_pressure: f64,
    pub(super) min_gap: f64,
    /// The tension of each contact about x = 0 for want of terms, as a part of its largest pressure there.
    pub(super) tensions: Vec<f64>,
}

/// Checks the Signorini conditions; `None` if a pressure or a gap is negative. `coarse` has fewer pressures, and tells how far gaps are known.
pub(super) fn check(problem: &Problem, level: &Level, coarse: &Level, error: f64) -> Option<Check> {
    let kernel = problem.kernel;
    let (intervals, coefficients) = (&level.intervals, &level.coefficients);
    let count = coefficients.first()?.len();
    let mut largest = vec![0.0f64; kernel.contacts()];
    let mut smallest = vec![0.0f64; kernel.contacts()];
    // about the middle, where pressures are said to be right to a part of what they are there
    let mut tensions = vec![0.0f64; kernel.contacts()];
    for (interval, coefficients) in intervals.iter().zip(coefficients) {
        let places = PER_MODE * count;
        let (mut least, mut most) = (0.0f64, 0.0f64);
        for k in 1..2 * places {
            let x = interval.middle + interval.half * (PI * k as f64 / (2 * places) as f64).cos();
            let pressure = interval.pressure(coefficients, x);
            (least, most) = (least.min(pressure), most.max(pressure));
            largest[interval.contact] = largest[interval.contact].max(pressure);
            smallest[interval.contact] = smallest[interval.contact].min(pressure);
        }
        if interval.is_central() {
            tensions[interval.contact] = -least / most;
        }
    }
    // more tension than that belongs to another root, however badly its ends are known: where intervals that ought to be apart meet, the
    // ends of the gap between them are no better known than that it is short
    if smallest.iter().zip(&largest).any(|(smallest, largest)| *smallest < -COARSE * largest) {
        return None;
    }
    let min_pressure = smallest.iter().copied().fold(0.0, f64::min);
    // less than an answer is wrong by counts as zero
    let zero = COARSE.max(error);
    let mut min_gap = 0.0f64;
    let Lengths { ends, shortest } = Lengths::of(problem, intervals);
    let span = problem.span(&ends);
    let layout = Layout::without_tails(kernel, &ends, &shortest, negligible(FIELDS), span)?;
    let equations = Equations { kernel, problem, layout: &layout, intervals, count };
    let before = Equations { intervals: &coarse.intervals, count: coarse.coefficients.first()?.len(), ..equations };
    for (i, (interval, same)) in intervals.iter().zip(&coarse.intervals).enumerate() {
        let next = intervals.get(i + 1).filter(|next| next.contact == interval.contact);
        let edge = problem.sides[interval.contact].edge().unwrap_or(span);
        let end = next.map_or(span.min(edge), Interval::from);
        let inwards = equations.is_apart(i).then(|| [interval.from(), 0.0, same.from(), 0.0]);
        let end_before = next.map_or(end, |_| coarse.intervals[i + 1].from());
        for [from, to, from_before, to_before] in
            inwards.into_iter().chain([[interval.to(), end, same.to(), end_before]])
        {
            let gaps = equations.gaps(interval.contact, coefficients, from, to, PLACES);
            let others = before.gaps(interval.contact, &coarse.coefficients, from_before, to_before, PLACES);
            let widest = gaps.iter().fold(0.0, |widest: f64, (_, gap)| widest.max(gap.abs()));
            let known = gaps.iter().zip(&others).fold(0.0, |most: f64, ((_, a), (_, b))| most.max((a - b).abs()));
            if gaps.iter().any(|(_, gap)| *gap < -(zero * widest + SAFETY * known)) {
                return None;
            }
            min_gap = gaps.iter().fold(min_gap, |least, (_, gap)| least.min(*gap));
        }
    }
    Some(Check { min_pressure, min_gap, tensions })
}

impl Equations<'_> {
    /// Places from one end of a gap to the other, dense next to both, and the gap there.
    pub(super) fn gaps(
        &self,
        contact: usize,
        coefficients: &[Vec<f64>],
        from: f64,
        to: f64,
        places: usize,
    ) -> Vec<(f64, f64)> {
        let waves = self.response(contact, coefficients);
        let (limit, side) = (self.layout.own[contact].limit, &self.problem.sides[contact]);
        let place = |t: f64| from + (to - from) * (FRAC_PI_2 * t).sin().powi(2);
        let mut near = 0.0;
        (1..=places)
            .map(|k| {
                let t = |k: usize| k as f64 / places as f64;
                for (t, weight) in rule(12).on(t(k - 1), t(k)) {
                    let x = place(t);
                    let slope: f64 = self.half_plane(contact, coefficients, x);
                    near += weight * FRAC_PI_2 * (PI * t).sin() * (to - from) * limit * slope;
                }
                let x = place(t(k));
                let far: f64 = waves
                    .iter()
                    .zip(&self.layout.zeta)
                    .map(|(wave, zeta)| {
                        wave * 2.0 * (0.5 * zeta * (x + from)).sin() * (0.5 * zeta * (x - from)).sin() / zeta
                    })
                    .sum();
                (x, side.height(x) - side.height(from) - near - far)
            })
            .collect()
    }
}
