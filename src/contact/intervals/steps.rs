//! What pressures say of ends, and the steps that ends take.
use crate::contact::intervals::pressure::Pressure;
use crate::contact::intervals::support::{ContactInterval, Intervals};
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::{COARSE, MINOR};

/// Most of the way to the next interval that an end goes in one step.
const MOST_OUT: f64 = 0.4;
/// An end that would take a longer step, in half-lengths, from next to no singularity need not be known.
pub(super) const SHORT: f64 = 0.1;

/// What the pressure says of one end.
pub(super) struct Look {
    /// The intensity of the singular pressure there, with the sign in which the pressure there is positive.
    pub(super) q: f64,
    /// The step outwards, in half-lengths.
    pub(super) step: f64,
    /// Weaker singularities count as none.
    weak: f64,
}

impl Look {
    /// Whether next to nothing depends on the end, however long this step of it.
    pub(super) fn is_weak(&self, step: f64) -> bool {
        self.q.abs() < self.weak && step.abs() > SHORT
    }
}

/// Takes steps, none longer than allowed; `None` if intervals vanish. An end that reaches the corner of a flat punch stays there, one that leaves it
/// does not.
pub(super) fn moved(problem: &Problem, support: &Intervals, steps: &[f64]) -> Option<Intervals> {
    let mut corners: Vec<[bool; 2]> = support.0.iter().map(|interval| interval.corners).collect();
    let mut limited = Vec::with_capacity(steps.len());
    for (end, step) in support.ends().into_iter().zip(steps) {
        if *step == 0.0 {
            limited.push(0.0);
            continue;
        }
        let interval = &support.0[end.interval];
        let outwards = (step * interval.half).min(MOST_OUT * support.gap(end));
        let place = support.place(end);
        // next to the tip of a wedge the intensity changes as the square root of the distance from there: Newton's method for that root
        let beyond = problem.tip(interval.contact, interval.punch).map_or(0.0, |(at, _)| end.side * (place - at));
        let outwards = if (-2.0 * beyond..0.0).contains(&outwards) {
            outwards * (1.0 + 0.25 * outwards / beyond)
        } else {
            outwards
        };
        let side = &problem.sides[interval.contact];
        let after = place + end.side * outwards;
        let at_corner = &mut corners[end.interval][usize::from(end.side > 0.0)];
        limited.push(match problem.placed(interval.contact, interval.punch) {
            Some(punch) => {
                let corner = punch.corner(end.side).filter(|corner| end.side * (after - corner) >= 0.0);
                *at_corner = corner.is_some();
                end.side * (corner.unwrap_or_else(|| punch.within(place, after)) - place)
            }
            None if end.side > 0.0 => side.within(place, after) - place,
            None => outwards,
        });
    }
    let mut moved = support.moved(&limited);
    moved.0.iter_mut().zip(corners).for_each(|(interval, corners)| interval.corners = corners);
    moved.0.iter().all(|interval| interval.half > 0.0 && interval.half.is_finite()).then_some(moved)
}

/// What pressures say of all ends; those at corners are where they are unless bodies pull there, where nothing is even.
pub(super) fn looks(support: &Intervals, pressures: &[Pressure]) -> Vec<Look> {
    let of = |(interval, pressure): (&ContactInterval, &Pressure)| -> Vec<Look> {
        // an end with a weaker singularity need not be known, nor one with a weaker one than terms of the pressure tell
        let weak = 1e-7f64.max((MINOR * pressure.missing(interval)).min(COARSE)) * pressure.size(interval);
        let signed = |(side, q): (&f64, &f64)| (*side, interval.sign(*side) * q);
        let of = |(side, q): (f64, f64)| match interval.is_corner(side) && (q >= 0.0 || interval.is_even()) {
            true => Look { q: 0.0, step: 0.0, weak },
            false => Look { q, step: pressure.step(interval, side, q), weak },
        };
        interval.sides().iter().zip(&pressure.singular).map(signed).map(of).collect()
    };
    support.0.iter().zip(pressures).flat_map(of).collect()
}
