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

    /// At some wavenumbers: transforms of `count` pressures, into as many columns, and the tests, into others. What is
    /// returned is the first transform less that of a pressure of the same resultant, which differs from 1 by `beyond`.
    pub(super) fn waves(
        &self,
        zeta: &[f64],
        beyond: &[f64],
        mut transforms: MatMut<'_, f64>,
        mut tested: MatMut<'_, f64>,
    ) -> Vec<f64> {
        let count = transforms.ncols();
        let highest = self.orders(count).last().unwrap_or(1);
        let arguments: Vec<f64> = zeta.iter().map(|zeta| zeta * self.half).collect();
        let nodes = zeta.len();
        let mut table = vec![0.0; (highest + 1) * nodes];
        bessel::table(highest + 1, &arguments, &mut table);
        let phases: Vec<(f64, f64)> = zeta.iter().map(|zeta| (zeta * self.middle).sin_cos()).collect();
        let column = |order: usize| &table[order * nodes..(order + 1) * nodes];
        let phase = |order: usize, node: usize| {
            let (sin, cos) = phases[node];
            if order.is_multiple_of(2) { sin } else { cos }
        };
        for (m, order) in self.orders(count).enumerate() {
            let sign = if order.is_multiple_of(2) { alternating(order / 2) } else { alternating((order - 1) / 2) };
            let factor = self.images() * PI * sign * order as f64;
            for (node, (zeta, value)) in zeta.iter().zip(column(order)).enumerate() {
                transforms[(node, m)] = factor * value / zeta * phase(order, node);
            }
        }
        for (row, order) in self.tests(count).iter().enumerate() {
            let factor = PI * alternating(order / 2);
            for (node, value) in column(*order).iter().enumerate() {
                tested[(node, row)] = factor * value * phase(*order, node);
            }
        }
        let rest = |(node, (zeta, beyond)): (usize, (&f64, &f64))| {
            let transform_minus_one = bessel::jinc_minus_one_from(arguments[node], column(1)[node]);
            let turned = -2.0 * (0.5 * zeta * self.middle).sin().powi(2);
            self.resultant() * ((1.0 + transform_minus_one) * turned + transform_minus_one + beyond)
        };
        zeta.iter().zip(beyond).enumerate().map(rest).collect()
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
