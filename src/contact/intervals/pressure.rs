//! The pressure of one interval, and what it says of its ends; of an opening the slope of the gap, and the gap in place of the pressure where its size and its sign matter.
use std::f64::consts::PI;

use num_complex::Complex64;

use crate::contact::intervals::support::ContactInterval;
use crate::contact::problem::accuracy::{COARSE, MINOR};
use crate::contact::problem::modes::alternating;
use crate::contact::problem::twin::Twin;
use crate::solution::{Strip, tip_coefficient};

/// What the last terms of an alternating sum count if its partial sums are averaged six times, term by term.
const AVERAGED: [f64; 6] = [63.0 / 64.0, 57.0 / 64.0, 42.0 / 64.0, 22.0 / 64.0, 7.0 / 64.0, 1.0 / 64.0];
/// Where the pressure is negative up to so far from an end, in half-lengths, it says where the contact ends.
const TENSION: f64 = 0.13;
/// The longest steps of an end outwards and inwards, in half-lengths.
pub(super) const FARTHEST: f64 = 0.3;
const MOST_IN: f64 = 0.9;

/// Amplitudes y_j of terms, and q of singular pressures at the ends that are no mirror images, and what a sharp tip makes, whose terms do not fall.
#[derive(Clone, Debug, Default)]
pub(super) struct Pressure {
    pub(super) terms: Vec<f64>,
    pub(super) singular: Vec<f64>,
    pub(super) tip: Tip,
}

/// The pressure that a half-plane has under a sharp tip: terms 2 y sin jθ.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tip {
    /// y; 0 where there is no tip.
    pub(super) strength: f64,
    /// cos θ, where it is, in half-lengths from the middle.
    pub(super) at: f64,
}

impl Tip {
    /// The amplitude y_j of its term number m on an interval.
    pub(super) fn term(self, interval: &ContactInterval, m: usize) -> f64 {
        let order = interval.order(m);
        match (self.strength, interval.twin) {
            (0.0, _) => 0.0,
            (strength, Twin::Plane) => strength * order as f64 * tip_coefficient(self.at, order),
            (strength, Twin::Round) => alternating(m) * order as f64 * Twin::Round.tip_mode(m, strength),
        }
    }

    /// What all its terms do to the slope of a half-plane beside the interval, Σ y_j zʲ/j, where Joukowski's map of the place is (z + 1/z)/2, |z| < 1: y_j/j = 2 y sin jα/j with
    /// cos α = t makes 2 y arctan(z sin α/(1 − z cos α)).
    pub(super) fn slope(self, z: Complex64) -> Complex64 {
        2.0 * self.strength * (z * self.sine() / (1.0 - z * self.at)).atan()
    }

    /// By how much they close a gap at s = (z + 1/z)/2, but for a constant: the integral of this slope over s.
    pub(super) fn closed(self, s: f64, z: f64) -> f64 {
        let sine = self.sine();
        self.strength * (2.0 * (s - self.at) * (z * sine / (1.0 - z * self.at)).atan() - sine * (z.abs().ln() + 1.0))
    }

    fn sine(self) -> f64 {
        ((1.0 - self.at) * (1.0 + self.at)).sqrt()
    }
}

impl Pressure {
    /// The same as a pressure of a solution, per unit of P', without the mirror image.
    pub(super) fn strip(&self, interval: &ContactInterval) -> Strip {
        let terms = self.terms.iter().enumerate();
        let mut all: Vec<f64> = terms.map(|(m, y)| interval.unit() * y / interval.order(m) as f64).collect();
        let singular = match self.singular[..] {
            [q] => [if interval.opens { -q } else { q }, q],
            [left, right] => [left, right],
            _ => [0.0; 2],
        };
        let corners = singular.map(|q| interval.unit() / interval.twin.norm * q);
        let (tip, tip_at) = (interval.unit() * self.tip.strength, self.tip.at);
        if interval.is_even() && !interval.opens {
            let is_round = interval.twin == Twin::Round;
            // Jacobi polynomials are 1 in the middle
            all.iter_mut().enumerate().filter(|_| is_round).for_each(|(m, term)| *term *= alternating(m));
            return Strip { corners, tip, tip_at, is_round, ..Strip::series(interval.half, all) };
        }
        let of_orders = |is_odd: bool| {
            let orders = all.iter().enumerate().filter(|(m, _)| (interval.order(*m) % 2 == 1) == is_odd);
            orders.map(|(_, y)| *y).collect()
        };
        let series = Strip::series(interval.half, of_orders(true));
        Strip { at: interval.middle, skew: of_orders(false), corners, tip, tip_at, ..series }
    }

    /// The pressure, or the gap over the half-length, at angles πk/places, k = 1, 2, ..., from the right end inwards; of what is even, on the right half.
    pub(super) fn inside(&self, interval: &ContactInterval, places: usize) -> Vec<f64> {
        let (strip, last) = (self.strip(interval), if interval.is_even() { places / 2 } else { places - 1 });
        let at = |phi: f64| if interval.opens { strip.integral_to(phi) } else { strip.pressure(interval.place(phi)) };
        (1..=last).map(|k| at(PI * k as f64 / places as f64)).collect()
    }

    /// How large the last third of its terms is, as a part of all.
    pub(super) fn missing(&self, interval: &ContactInterval) -> f64 {
        let sum = |first: usize| {
            let terms = self.terms.iter().enumerate().skip(first);
            terms.map(|(m, y)| y.abs() / interval.order(m) as f64).sum::<f64>()
        };
        sum(self.terms.len() - self.terms.len() / 3) / sum(0)
    }

    /// In how many places, all angles together, it is looked at.
    pub(super) fn places(&self, interval: &ContactInterval) -> usize {
        // the highest mode is seen at three places of each of its arches
        3 * interval.order(self.terms.len() - 1)
    }

    /// The gap of an opening over its half-length at an angle: the integral of its slope from the left end.
    pub(super) fn gap(&self, interval: &ContactInterval, phi: f64) -> f64 {
        self.strip(interval).integral_to(phi)
    }

    /// How large its terms are: about 1 of a pressure.
    pub(super) fn size(&self, interval: &ContactInterval) -> f64 {
        let terms = self.terms.iter().enumerate().map(|(m, y)| y.abs() / interval.order(m) as f64);
        if interval.opens { terms.sum() } else { 1.0 }
    }

    /// The pressure in the middle of the interval, per unit of P'; of an opening the gap over the half-length.
    pub(super) fn middle(&self, interval: &ContactInterval) -> f64 {
        if interval.opens {
            return self.gap(interval, 0.5 * PI);
        }
        self.strip(interval).pressure(interval.middle)
    }

    /// The resultant on the interval and its mirror image; of an opening the gap in the middle, over its half-length.
    pub(super) fn force(&self, interval: &ContactInterval) -> f64 {
        if interval.opens {
            return self.middle(interval);
        }
        let of_ends: f64 = self.singular.iter().sum();
        self.terms[0] + self.tip.term(interval, 0) + if self.singular.len() == 1 { 2.0 * of_ends } else { of_ends }
    }

    /// Its mean over the interval: with this tension is compared, since pressures next to tips and corners are as large as one looks closely.
    pub(super) fn mean(&self, interval: &ContactInterval) -> f64 {
        if interval.opens { self.middle(interval) } else { interval.twin.mean * interval.unit() * self.force(interval) }
    }

    /// The same with no singularity at an end that is found: what is left of it is rounding.
    pub(super) fn regular(&self, interval: &ContactInterval) -> Self {
        let at_corner = |(side, q): (&f64, &f64)| if interval.is_corner(*side) { *q } else { 0.0 };
        Self { singular: interval.sides().iter().zip(&self.singular).map(at_corner).collect(), ..self.clone() }
    }

    /// The same pressure on an interval with other ends, to first order in how far these are, without what is singular there: where bodies touch, the
    /// terms of −Σ y_j cos jφ (δm + δw cos φ)/(w sin φ), the change of p at a fixed x.
    pub(super) fn on(&self, before: &ContactInterval, after: &ContactInterval) -> Self {
        let [middle, half] = [after.middle - before.middle, after.half - before.half].map(|moved| moved / after.half);
        let (twin, highest) = (before.twin, before.order(self.terms.len()));
        let mut cosines = vec![0.0; highest + 2];
        for (m, y) in self.terms.iter().enumerate() {
            let (j, y) = (before.order(m), twin.scale(m) * y);
            cosines[j] += middle * y;
            cosines[j + 1] += 0.5 * half * y;
            cosines[j - 1] += 0.5 * half * y;
        }
        // (1 − cos nφ)/sin φ for even n, or (cos φ − cos nφ)/sin φ for odd n, is twice the sum of sin kφ, k = n − 1, n − 3, ...
        (0..highest).rev().for_each(|n| cosines[n] += cosines[n + 2]);
        let mut moved = self.clone();
        let unit = before.unit() / after.unit();
        for (m, y) in moved.terms.iter_mut().enumerate() {
            let k = before.order(m);
            let of_all = 2.0 * (k as f64 + twin.shift) * cosines[k + 1] / twin.scale(m);
            *y = unit * (*y - twin.shift * half * *y + of_all);
        }
        moved
    }

    /// Next to a graded face the pressure has a logarithm at its ends, and terms fall like a power: as far as they alternate about the middle, what is
    /// even as well as what is odd, the last partial sums are averaged, which leaves little of what is missing.
    pub(super) fn averaged(&self, interval: &ContactInterval) -> Self {
        let mut averaged = self.clone();
        let kinds = if interval.is_even() { 1 } else { 2 };
        for (k, y) in averaged.terms.iter_mut().rev().enumerate() {
            *y *= AVERAGED.iter().rev().nth(k / kinds).unwrap_or(&1.0);
        }
        averaged
    }

    /// The step of an end outwards, in half-lengths: the sign of the intensity q, in which the pressure there is positive, says which way, and next to the end that is unit (κφ + q/φ), as of an end
    /// farther out by q/κ.
    pub(super) fn step(&self, interval: &ContactInterval, side: f64, q: f64) -> f64 {
        let sign = |m: usize| if side > 0.0 || interval.order(m) % 2 == 1 { 1.0 } else { -1.0 };
        // the last terms, which truncation changes most, do not count
        let smooth = |m: usize| (-12.0 * (m as f64 / self.terms.len() as f64).powi(4)).exp();
        let term = |(m, y): (usize, &f64)| smooth(m) * sign(m) * interval.at_end(m) * y;
        let regular: f64 = self.terms.iter().enumerate().map(term).sum();
        let [near, far] = [1.0 - side * self.tip.at, 1.0 + side * self.tip.at];
        // (1 − cos φ)/(2 sin φ) of the other end is φ/4 here
        let other = match self.singular[..] {
            [left, right] => 0.25 * if side > 0.0 { left } else { right },
            _ => 0.0,
        };
        let tip = interval.twin.norm * self.tip.strength * (far / near).sqrt();
        let kappa = interval.sign(side) * (regular + tip + other);
        if q > 0.0 {
            // beyond where bodies pull they have parted: an end out there may follow pressures next to nothing to anywhere
            let is_long = kappa <= 0.0 || q > MINOR * kappa;
            let parted = is_long.then(|| self.zero(interval, side, COARSE * self.mean(interval))).flatten();
            if let Some(distance) = parted {
                return -distance.min(MOST_IN);
            }
            return if kappa > 0.0 { ((1.0 + 2.0 * q / kappa).sqrt() - 1.0).min(FARTHEST) } else { FARTHEST };
        }
        let newton = if kappa > 0.0 { q / kappa } else { f64::NEG_INFINITY };
        // so short a step ends about where the pressure is zero
        if newton > -MINOR {
            return newton;
        }
        let distance = self.zero(interval, side, 0.0).unwrap_or_else(|| match newton.is_finite() {
            true => -0.5 * newton,
            false => 1.0 - (0.5 * PI / self.places(interval) as f64).cos(),
        });
        if distance > TENSION || kappa <= 0.0 { -distance.min(MOST_IN) } else { newton.max(-2.2 * distance) }
    }

    /// How far from an end bodies pull by more than `least`, seen from the largest pressure, in half-lengths.
    fn zero(&self, interval: &ContactInterval, side: f64, least: f64) -> Option<f64> {
        let places = self.places(interval);
        let angle = |k: f64| PI * (k + 0.5) / places as f64;
        let phi = |k: f64| if side > 0.0 { angle(k) } else { PI - angle(k) };
        let last = if interval.is_even() { places / 2 } else { places - 1 };
        let strip = self.strip(interval);
        let at = |k: usize| interval.sign(side) * strip.pressure(interval.place(phi(k as f64)));
        let all: Vec<f64> = (0..=last).map(at).collect();
        let largest = (0..=last).max_by(|a, b| all[*a].total_cmp(&all[*b]))?;
        let last = all[..largest].iter().rposition(|p| *p < -least)?;
        let zero = (last..largest).take_while(|k| all[*k] < 0.0).last()?;
        let part = all[zero] / (all[zero] - all[zero + 1]);
        Some(1.0 - angle(zero as f64 + part).cos())
    }
}
