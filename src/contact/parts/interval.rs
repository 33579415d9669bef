//! Pressures and tests on one of the intervals in which two bodies touch.
//!
//! On |x − m| < w, x = m + w cos φ, and on its mirror image the pressure is Σ c_j sin jφ. Its transform is a sum of
//! 2πj c_j J_j(ζw)/ζ times cos ζm for odd j and sin ζm for even j; about the middle, m = 0, there are only odd j and
//! one image. The tests T_k(s)/√(1 − s²), s = (x − m)/w, turn sin ζx into π J_k(ζw) times cos ζm or sin ζm.
use std::f64::consts::{FRAC_PI_2, PI};

use faer::MatMut;

use crate::contact::problem::modes::alternating;
use crate::numeric::bessel;

/// One interval of |x| in which the bodies of a contact touch.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Interval {
    pub(super) contact: usize,
    /// Where its middle is: 0, or that of the image at x > 0.
    pub(super) middle: f64,
    /// Half of its length.
    pub(super) half: f64,
}

impl Interval {
    pub(super) fn new(contact: usize, [from, to]: [f64; 2]) -> Self {
        if from == 0.0 {
            Self { contact, middle: 0.0, half: to }
        } else {
            Self { contact, middle: 0.5 * (from + to), half: 0.5 * (to - from) }
        }
    }

    pub(super) fn is_central(&self) -> bool {
        self.middle == 0.0
    }

    pub(super) fn from(&self) -> f64 {
        if self.is_central() { 0.0 } else { self.middle - self.half }
    }

    pub(super) fn to(&self) -> f64 {
        self.middle + self.half
    }

    fn images(&self) -> f64 {
        if self.is_central() { 1.0 } else { 2.0 }
    }

    /// Orders j of `count` pressures.
    pub(super) fn orders(&self, count: usize) -> impl Iterator<Item = usize> + use<> {
        let step = if self.is_central() { 2 } else { 1 };
        (0..count).map(move |m| step * m + 1)
    }

    /// Orders k of the tests that go with them, the first of which tells how far its ends are from right.
    pub(super) fn tests(&self, count: usize) -> Vec<usize> {
        if self.is_central() { self.orders(count).collect() } else { (0..=count).collect() }
    }

    /// The resultant of sin φ; all others have none.
    pub(super) fn resultant(&self) -> f64 {
        self.images() * self.half * FRAC_PI_2
    }

    /// Adds to `slopes` what `count` pressures make of that of a half-plane with λμ₀C = 1 at x: those on the mirror image,
    /// and unless x is on the interval itself (`own`) those on the interval.
    pub(super) fn outside(&self, x: f64, count: usize, own: bool, slopes: &mut [f64]) {
        let near = (x - self.middle) / self.half;
        let far = (-x - self.middle) / self.half;
        let mut add = |s: f64, sign: f64| {
            // s − √(s² − 1) with the sign of s
            let inside = s.signum() / (s.abs() + (s * s - 1.0).max(0.0).sqrt());
            for (slope, order) in slopes.iter_mut().zip(self.orders(count)) {
                *slope += sign * inside.powi(order as i32);
            }
        };
        if !own {
            add(near, 1.0);
        }
        if !self.is_central() {
            add(far, -1.0);
        }
    }

    /// Σ c_j sin jφ at x, 0 outside the interval; nothing of the mirror image.
    pub(super) fn pressure(&self, coefficients: &[f64], x: f64) -> f64 {
        let s = (x - self.middle) / self.half;
        if s.abs() >= 1.0 {
            return 0.0;
        }
        let phi = s.acos();
        self.orders(coefficients.len()).zip(coefficients).map(|(order, c)| c * (order as f64 * phi).sin()).sum()
    }
}

/// A way in which an interval moves.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Motion {
    /// Its middle moves.
    Shift,
    /// Its half-length grows.
    Growth,
}

impl Motion {
    pub(super) fn both() -> [Self; 2] {
        [Self::Shift, Self::Growth]
    }
}

/// Bessel functions and phases of an interval at some wavenumbers.
pub(super) struct Table<'a> {
    interval: &'a Interval,
    count: usize,
    zeta: &'a [f64],
    /// By how much the transform of the pressure that all are compared with, of the resultant 1, is less than 1.
    beyond: &'a [f64],
    /// ζw
    arguments: Vec<f64>,
    /// J_j(ζw), order by order.
    bessel: Vec<f64>,
    /// sin ζm and cos ζm.
    phases: Vec<(f64, f64)>,
}

impl<'a> Table<'a> {
    /// For `count` pressures.
    pub(super) fn new(interval: &'a Interval, count: usize, zeta: &'a [f64], beyond: &'a [f64]) -> Self {
        let highest = interval.orders(count).last().unwrap_or(1);
        let arguments: Vec<f64> = zeta.iter().map(|zeta| zeta * interval.half).collect();
        // one order more for derivatives
        let mut bessel = vec![0.0; (highest + 2) * zeta.len()];
        bessel::table(highest + 2, &arguments, &mut bessel);
        let phases = zeta.iter().map(|zeta| (zeta * interval.middle).sin_cos()).collect();
        Self { interval, count, zeta, beyond, arguments, bessel, phases }
    }

    fn bessel(&self, order: usize) -> &[f64] {
        &self.bessel[order * self.zeta.len()..(order + 1) * self.zeta.len()]
    }

    /// The phase of the waves of an order: sin ζm for even ones, cos ζm for odd ones.
    fn phase(&self, order: usize, node: usize) -> f64 {
        let (sin, cos) = self.phases[node];
        if order.is_multiple_of(2) { sin } else { cos }
    }

    /// What the transform of a pressure is besides ζ^(-1) J_j(ζw) and the phase.
    fn factor(&self, order: usize) -> f64 {
        let sign = if order.is_multiple_of(2) { alternating(order / 2) } else { alternating((order - 1) / 2) };
        self.interval.images() * PI * sign * order as f64
    }

    /// Transforms of the pressures, into as many columns.
    pub(super) fn transforms(&self, mut into: MatMut<'_, f64>) {
        for (m, order) in self.interval.orders(self.count).enumerate() {
            let factor = self.factor(order);
            for (node, (zeta, value)) in self.zeta.iter().zip(self.bessel(order)).enumerate() {
                into[(node, m)] = factor * value / zeta * self.phase(order, node);
            }
        }
    }

    /// The tests, into as many columns.
    pub(super) fn tests(&self, mut into: MatMut<'_, f64>) {
        for (row, order) in self.interval.tests(self.count).into_iter().enumerate() {
            let factor = PI * alternating(order / 2);
            for (node, value) in self.bessel(order).iter().enumerate() {
                into[(node, row)] = factor * value * self.phase(order, node);
            }
        }
    }

    /// The first transform less that of the pressure that all are compared with, of the same resultant.
    pub(super) fn first_remainder(&self) -> Vec<f64> {
        let rest = |(node, beyond): (usize, &f64)| {
            let (jinc_minus_one, turned) = (self.jinc_minus_one(node), self.turned(node));
            self.interval.resultant() * ((1.0 + jinc_minus_one) * turned + jinc_minus_one + beyond)
        };
        self.beyond.iter().enumerate().map(rest).collect()
    }

    fn jinc_minus_one(&self, node: usize) -> f64 {
        bessel::jinc_minus_one_from(self.arguments[node], self.bessel(1)[node])
    }

    /// cos ζm − 1
    fn turned(&self, node: usize) -> f64 {
        -2.0 * (0.5 * self.zeta[node] * self.interval.middle).sin().powi(2)
    }

    /// What the pressures do together: their transform, and what that is less their resultant.
    pub(super) fn field(&self, pressures: &[f64]) -> [Vec<f64>; 2] {
        let mut remainder = vec![0.0; self.zeta.len()];
        let add = |order: usize, pressure: f64, sum: &mut [f64]| {
            let factor = self.factor(order) * pressure;
            for (node, (sum, value)) in sum.iter_mut().zip(self.bessel(order)).enumerate() {
                *sum += factor * value / self.zeta[node] * self.phase(order, node);
            }
        };
        for (order, pressure) in self.interval.orders(self.count).zip(pressures).skip(1) {
            add(order, *pressure, &mut remainder);
        }
        let mut plain = remainder.clone();
        add(1, pressures[0], &mut plain);
        remainder.iter_mut().zip(self.first_remainder()).for_each(|(sum, value)| *sum += pressures[0] * value);
        [plain, remainder]
    }

    /// The derivative of J_j(ζw) times its phase, over ζ, as the interval moves.
    fn derivative(&self, order: usize, motion: Motion) -> Vec<f64> {
        let is_even = order.is_multiple_of(2);
        let (own, next) = (self.bessel(order), self.bessel(order + 1));
        let pairs = self.bessel(order.saturating_sub(1)).iter().zip(next);
        let phases = self.phases.iter().map(|(sin, cos)| if is_even { *sin } else { *cos });
        match motion {
            Motion::Growth if order == 0 => next.iter().zip(phases).map(|(next, phase)| -next * phase).collect(),
            Motion::Growth => pairs.zip(phases).map(|((before, next), phase)| 0.5 * (before - next) * phase).collect(),
            Motion::Shift if is_even => own.iter().zip(&self.phases).map(|(own, (_, cos))| own * cos).collect(),
            Motion::Shift => own.iter().zip(&self.phases).map(|(own, (sin, _))| -own * sin).collect(),
        }
    }

    /// The derivatives of [`Self::field`].
    pub(super) fn moved_field(&self, pressures: &[f64], motion: Motion) -> [Vec<f64>; 2] {
        let add = |order: usize, pressure: f64, sum: &mut [f64]| {
            let factor = self.factor(order) * pressure;
            sum.iter_mut().zip(self.derivative(order, motion)).for_each(|(sum, value)| *sum += factor * value);
        };
        let mut remainder = vec![0.0; self.zeta.len()];
        for (order, pressure) in self.interval.orders(self.count).zip(pressures).skip(1) {
            add(order, *pressure, &mut remainder);
        }
        let mut plain = remainder.clone();
        add(1, pressures[0], &mut plain);
        match motion {
            Motion::Shift => remainder.clone_from(&plain),
            Motion::Growth => {
                // (J_0 − J_2) cos ζm − 1 + what is beyond, without cancellation: J_0 = 2J_1/z − J_2
                let growing = self.interval.images() * FRAC_PI_2 * pressures[0];
                let second = self.bessel(2);
                for (node, sum) in remainder.iter_mut().enumerate() {
                    let (_, cos) = self.phases[node];
                    let even = self.jinc_minus_one(node) - 2.0 * second[node];
                    *sum += growing * (even * cos + self.turned(node) + self.beyond[node]);
                }
            }
        }
        [plain, remainder]
    }

    /// The derivatives of the tests times a field, summed.
    pub(super) fn moved_tests(&self, motion: Motion, field: &[f64]) -> Vec<f64> {
        let tested = |order: usize| {
            let terms = self.derivative(order, motion).into_iter().zip(self.zeta).zip(field);
            PI * alternating(order / 2) * terms.map(|((value, zeta), field)| value * zeta * field).sum::<f64>()
        };
        self.interval.tests(self.count).into_iter().map(tested).collect()
    }
}
