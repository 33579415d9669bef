//! What pressures would do on a half-plane, with g∞ in place of the kernel: integrated in space, where that is smooth.
use std::f64::consts::{FRAC_PI_2, PI};

use faer::Mat;

use crate::contact::parts::equations::{Equations, POINTS};
use crate::numeric::dot;
use crate::numeric::quadrature::rule;

impl Equations<'_> {
    /// What a half-plane would do, in space.
    pub(super) fn add_half_plane(&self, contact: usize, limit: f64, block: &mut Mat<f64>) {
        let mut at = 0;
        for (index, interval) in self.of(contact) {
            let tests = interval.tests(self.count);
            let rows = self.rows(index);
            for (source, (other, from)) in self.of(contact).enumerate() {
                let column = source * self.count;
                let own = other == index;
                if own {
                    for (row, test) in tests.iter().enumerate() {
                        if let Some(m) = interval.orders(self.count).position(|order| order == *test) {
                            block[(at + row, column + m)] += limit * FRAC_PI_2;
                        }
                    }
                }
                if own && interval.is_central() {
                    continue;
                }
                let mut slopes = vec![0.0; self.count];
                for (theta, weight) in self.places() {
                    slopes.fill(0.0);
                    from.outside(interval.middle + interval.half * theta.cos(), self.count, own, &mut slopes);
                    for (row, test) in tests.iter().enumerate() {
                        let factor = limit * weight * (*test as f64 * theta).cos();
                        for (m, slope) in slopes.iter().enumerate() {
                            block[(at + row, column + m)] += factor * slope;
                        }
                    }
                }
            }
            if let Some([start, end]) = self.opening(index) {
                let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
                let mut slopes = vec![0.0; self.count];
                for (theta, weight) in rule(POINTS + self.count).on(0.0, PI) {
                    let x = middle + half * theta.cos();
                    for (source, (_, from)) in self.of(contact).enumerate() {
                        slopes.fill(0.0);
                        from.outside(x, self.count, false, &mut slopes);
                        for (m, slope) in slopes.iter().enumerate() {
                            block[(at + rows - 1, source * self.count + m)] +=
                                limit * weight * half * theta.sin() * slope;
                        }
                    }
                }
            }
            at += rows;
        }
    }

    /// The slope at x outside a contact on a half-plane with λμ₀C = 1.
    pub(super) fn half_plane(&self, contact: usize, coefficients: &[Vec<f64>], x: f64) -> f64 {
        let mut slopes = vec![0.0; self.count];
        let mut sum = 0.0;
        for (index, interval) in self.of(contact) {
            slopes.fill(0.0);
            interval.outside(x, self.count, false, &mut slopes);
            sum += dot(&slopes, &coefficients[index]);
        }
        sum
    }
}
