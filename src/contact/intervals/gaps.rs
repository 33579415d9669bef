//! No pressure may be tension, and no gap penetrated, between the intervals of a contact and beyond them.
use std::f64::consts::{FRAC_PI_2, PI};

use crate::contact::integrals::layout::{FIELDS, Layout, negligible};
use crate::contact::intervals::Lengths;
use crate::contact::intervals::equations::Equations;
use crate::contact::intervals::newton::Level;
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::{COARSE, PER_MODE, PLACES, SAFETY};
use crate::numeric::quadrature::rule;

/// What the check found, per unit of P'.
pub(super) struct Check {
    /// Smallest pressure in the contacts, and smallest gap outside.
    pub(super) min_pressure: f64,
    pub(super) min_gap: f64,
    /// The tension of each contact about x = 0 for want of terms, as a part of its largest pressure there.
    pub(super) tensions: Vec<f64>,
}

/// Checks the Signorini conditions; `None` if a pressure or a gap is negative. `coarse` has fewer terms, and tells how far gaps are known.
pub(super) fn check(problem: &Problem, level: &Level, coarse: &Level, error: f64) -> Option<Check> {
    let count = problem.contacts();
    let [mut largest, mut smallest] = [vec![0.0f64; count], vec![0.0f64; count]];
    // about the middle, where pressures are said to be right to a part of what they are there
    let mut tensions = vec![0.0f64; count];
    for (interval, pressure) in level.support.0.iter().zip(&level.pressures) {
        let is_flat = problem.sides[interval.contact].is_flat();
        let pressure = if is_flat { pressure.clone() } else { pressure.regular() };
        let places = 2 * PER_MODE * pressure.terms.len();
        let (mut least, mut most) = (0.0f64, 0.0f64);
        for k in 1..places {
            let pressure = pressure.at(interval, PI * k as f64 / places as f64);
            (least, most) = (least.min(pressure), most.max(pressure));
        }
        let contact = interval.contact;
        (largest[contact], smallest[contact]) = (largest[contact].max(most), smallest[contact].min(least));
        if interval.is_central() {
            tensions[contact] = -least / most;
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
    let Lengths { ends, shortest } = Lengths::of(problem, &level.support);
    let span = problem.span(&ends);
    let layout = Layout::without_tails(problem.kernel, &ends, &shortest, negligible(FIELDS), span)?;
    for contact in problem.unknown() {
        let edge = problem.sides[contact].edge().unwrap_or(span);
        let places = |level: &Level| {
            let intervals = level.support.of(contact);
            let between = intervals.windows(2).map(|pair| [pair[0].to(), pair[1].from()]);
            let inwards = intervals.first().filter(|first| !first.is_central()).map(|first| [first.from(), 0.0]);
            let outwards = intervals.last().map(|last| [last.to(), span.min(edge)]);
            between.chain(inwards).chain(outwards).collect::<Vec<_>>()
        };
        let gaps = gaps(problem, level, &layout, contact, &places(level));
        let before = self::gaps(problem, coarse, &layout, contact, &places(coarse));
        for (gaps, before) in gaps.iter().zip(&before) {
            let widest = gaps.iter().fold(0.0, |widest: f64, (_, gap)| widest.max(gap.abs()));
            let known = gaps.iter().zip(before).fold(0.0, |most: f64, ((_, a), (_, b))| most.max((a - b).abs()));
            if gaps.iter().any(|(_, gap)| *gap < -(zero * widest + SAFETY * known)) {
                return None;
            }
            min_gap = gaps.iter().fold(min_gap, |least, (_, gap)| least.min(*gap));
        }
    }
    Some(Check { min_pressure, min_gap, tensions })
}

/// Places from one end of each gap to the other, dense next to both, and the gap there.
fn gaps(problem: &Problem, level: &Level, layout: &Layout, contact: usize, all: &[[f64; 2]]) -> Vec<Vec<(f64, f64)>> {
    let equations = Equations::new(problem, layout, &level.support, &level.counts);
    let waves = equations.response(contact, &level.pressures);
    let (limit, side) = (layout.own[contact].limit, &problem.sides[contact]);
    let (columns, amplitudes) = (&equations.columns[contact], equations.amplitudes(contact, &level.pressures));
    let of = |[from, to]: &[f64; 2]| {
        let place = |t: f64| from + (to - from) * (FRAC_PI_2 * t).sin().powi(2);
        let mut near = 0.0;
        let at = |k: usize| {
            let t = |k: usize| k as f64 / PLACES as f64;
            for (t, weight) in rule(12).on(t(k - 1), t(k)) {
                let slope: f64 = columns.slope(place(t), &amplitudes);
                near += weight * FRAC_PI_2 * (PI * t).sin() * (to - from) * limit * slope;
            }
            let x = place(t(k));
            let far = waves.iter().zip(&layout.zeta).map(|(wave, zeta)| {
                wave * 2.0 * (0.5 * zeta * (x + from)).sin() * (0.5 * zeta * (x - from)).sin() / zeta
            });
            (x, side.height(x) - side.height(*from) - near - far.sum::<f64>())
        };
        (1..=PLACES).map(at).collect()
    };
    all.iter().map(of).collect()
}
