//! The punch as the contact equations see it: tests of its slope, per unit of P'.
//!
//! All that is asked of a profile are the Chebyshev coefficients of its slope over the contact, and how they change with
//! its half-length. Powers of |x| have closed forms, a circle is analytic, and pieces are integrated one by one.
use std::f64::consts::{FRAC_PI_2, PI};

use crate::contact::error::{ContactError, NoSolution};
use crate::contact::problem::accuracy::ROUNDING;
use crate::contact::problem::modes::order;
use crate::contact::problem::twin::Twin;
use crate::numeric::quadrature::rule;
use crate::scene::{Piece, Punch, Shape};

/// A contact that covers this part of the punch's half-width counts as having reached the edge, where the slope of a
/// circle is infinite.
const NEARLY: f64 = 0.999;
/// Most oscillations of a test function, as a phase, that one Gauss rule is asked to integrate.
const PHASE: f64 = 150.0;
/// Gauss points besides those that the oscillation takes.
const SPARE: f64 = 14.0;

/// The profile of a punch pressed with a force, in the units of the kernel.
pub(crate) struct Profile<'a> {
    punch: &'a Punch,
    pub(super) shape: Shape<'a>,
    /// Length L in the units of the scene.
    pub(super) length: f64,
    /// P'.
    pub(super) force: f64,
    twin: Twin,
}

/// What a half-plane of the material at the face does under the punch, all rows but the first fulfilled: the pressure
/// that has the singularities of the profile.
pub(crate) struct Local {
    /// Its modes y_m.
    pub(crate) modes: Vec<f64>,
    /// Σ y_m/(πj) over all of them, the pressure at x = 0; infinite at a sharp apex.
    pub(crate) peak: f64,
}

/// The right-hand side, per unit of P': the punch's slope against the tests of its contact.
pub(crate) struct Slopes {
    /// ± ∫ f'(as) T_k(s)/√(1 − s²) ds.
    pub(crate) value: Vec<f64>,
    /// Its derivative with respect to ln a.
    pub(crate) slope: Vec<f64>,
    /// a.
    pub(crate) half_length: f64,
    twin: Twin,
}

impl Slopes {
    /// The row of mode `m`.
    pub(crate) fn load(&self, m: usize) -> f64 {
        self.twin.load(m) * self.value[m] / self.half_length
    }

    /// Its derivative with respect to ln a.
    pub(crate) fn load_slope(&self, m: usize) -> f64 {
        self.twin.load(m) * (self.slope[m] - self.value[m]) / self.half_length
    }
}

impl<'a> Profile<'a> {
    /// A punch in units of L, pressed with P'.
    pub(crate) fn new(punch: &'a Punch, length: f64, force: f64, twin: Twin) -> Self {
        Self { punch, shape: punch.shape(), length, force, twin }
    }

    /// Half-length of the contact, in units of L, if the punch has sharp corners.
    pub(crate) fn flat(&self) -> Option<f64> {
        if let Shape::Flat(edge) = self.shape { Some(edge / self.length) } else { None }
    }

    /// Whether modes fall fast: the profile is analytic, and what it presses on takes no part in that.
    pub(crate) fn is_smooth(&self) -> bool {
        self.shape.is_smooth()
    }

    /// Whether the pressure is infinite at the apex.
    pub(crate) fn is_sharp(&self) -> bool {
        self.punch.is_sharp()
    }

    /// Whether the profile is a parabola.
    pub(crate) fn is_parabola(&self) -> bool {
        matches!(&self.shape, Shape::Powers { terms, .. } if terms.iter().all(|(exponent, _)| *exponent == 2.0))
    }

    /// RP'/L of the parabola that presses as hard on a contact of this half-length, or at its apex; `None` if the profile is
    /// like none.
    pub(crate) fn as_parabola(&self, half_length: f64) -> Option<f64> {
        if !self.is_parabola() && !matches!(self.shape, Shape::Circle(_)) {
            return None;
        }
        if half_length == 0.0 || self.is_parabola() {
            return Some(self.force / (self.length * self.shape.curvature(0.0)));
        }
        Some(self.twin.parabola_row() * half_length / self.first_row(half_length))
    }

    /// Half-length at which the punch ends, in units of L.
    pub(crate) fn edge(&self) -> Option<f64> {
        self.shape.edge().map(|limit| limit / self.length)
    }

    /// The last place at which the profile falls, in units of L; 0 if it does so nowhere.
    pub(crate) fn last_fall(&self) -> f64 {
        self.shape.last_fall() / self.length
    }

    /// The error to report if a contact has grown to `half_length` and that is the edge of the punch.
    pub(crate) fn too_small(&self, half_length: f64) -> Option<ContactError> {
        let edge = self.shape.edge().filter(|_| self.flat().is_none())?;
        (half_length * self.length > NEARLY * edge)
            .then(|| NoSolution::PunchTooSmall { punch: self.punch.label(self.twin.geometry()), edge }.into())
    }

    /// The half-length at which a step from `before` to `after` ends: a contact covers more than the flat part of the
    /// punch, and less than all of it.
    pub(crate) fn within(&self, before: f64, after: f64) -> f64 {
        let flat = self.shape.flat() / self.length;
        match self.edge() {
            Some(edge) if after >= edge => 0.5 * (edge + before),
            _ if after <= flat => 0.5 * (flat + before),
            _ => after,
        }
    }

    /// Height above the apex at x (both in units of L), per unit of P'.
    pub(crate) fn height(&self, x: f64) -> f64 {
        self.shape.height(x * self.length) / (self.length * self.force)
    }

    /// Slope at x (in units of L), per unit of P'.
    pub(crate) fn slope(&self, x: f64) -> f64 {
        self.shape.slope(x * self.length) / self.force
    }

    /// ∫ f'(as) s/√(1 − s²) ds / P'.
    pub(crate) fn first_row(&self, half_length: f64) -> f64 {
        self.slopes(half_length, 1).value[0]
    }

    /// (−1)^m ∫ f'(as) T_k(s)/√(1 − s²) ds / P' for k = 2m + 1 and `rows` values of m, with derivatives with respect to
    /// ln a.
    pub(crate) fn slopes(&self, half_length: f64, rows: usize) -> Slopes {
        let twin = self.twin;
        let mut slopes = Slopes { value: vec![0.0; rows], slope: vec![0.0; rows], half_length, twin };
        if twin == Twin::Round {
            self.round_rows(half_length, &mut slopes);
            return slopes;
        }
        match &self.shape {
            Shape::Powers { length, terms, .. } => {
                for (exponent, coefficient) in terms {
                    let amplitude = self.amplitude(half_length, *length, *exponent, *coefficient);
                    power_rows(exponent - 1.0, amplitude, &mut slopes);
                }
            }
            Shape::Circle(_) => self.analytic_rows(half_length, &mut slopes),
            Shape::Flat(_) => {}
            Shape::Pieces { pieces, .. } => {
                let phase = 2.0 * rows as f64;
                for (theta, weight) in self.places(pieces, half_length, phase) {
                    self.add_place(theta, 2.0 * weight, half_length, rows, &mut slopes);
                }
            }
        }
        slopes
    }

    /// The pressure of a half-plane with λμ₀C = `limit` under a punch that is not smooth.
    pub(crate) fn local(&self, half_length: f64, limit: f64, modes: usize) -> Option<Local> {
        if self.shape.is_smooth() {
            return None;
        }
        let slopes = self.slopes(half_length, modes);
        if self.twin == Twin::Round {
            let mode = |m: usize| slopes.load(m) / self.twin.diagonal(limit, m, half_length);
            // p(0) = (2/πg∞) ∫ A'(t)/t dt
            let peak = self.round_apex(half_length) * 2.0 * half_length.powi(2) / (3.0 * PI * PI * limit);
            return Some(Local { modes: (0..modes).map(mode).collect(), peak });
        }
        let value = slopes.value;
        let factor = half_length / limit;
        let modes = value.iter().enumerate().map(|(m, value)| factor * order(m) * value).collect();
        Some(Local { modes, peak: factor / PI * self.apex(half_length) })
    }

    /// ∫ f'(a cos θ)/cos θ dθ from 0 to π/2, over P': the sum of all rows.
    fn apex(&self, half_length: f64) -> f64 {
        match &self.shape {
            Shape::Powers { length, terms, .. } => {
                let term = |(exponent, coefficient): &(f64, f64)| {
                    let power = exponent - 1.0;
                    let amplitude = self.amplitude(half_length, *length, *exponent, *coefficient);
                    if amplitude == 0.0 { 0.0 } else { amplitude * wallis(power + 1.0) * (power + 1.0) / power }
                };
                terms.iter().map(term).sum()
            }
            Shape::Circle(_) => self.slopes(half_length, 1024).value.iter().sum(),
            Shape::Flat(_) => 0.0,
            Shape::Pieces { pieces, .. } => {
                // with x = a/cosh u the integral of f' is taken over u
                // slopes at x = a/cosh u are nothing beyond
                let nothing = -2.0 * ROUNDING.ln();
                let farthest = |start: f64| (half_length * self.length / start).acosh().min(nothing);
                let mut ends: Vec<f64> = covered(pieces, half_length * self.length).map(farthest).collect();
                ends.push(0.0);
                let pieces = ends.windows(2).map(|pair| {
                    let parts = (pair[0] - pair[1]).ceil().max(1.0);
                    let step = (pair[0] - pair[1]) / parts;
                    let part = |k: f64| {
                        let places = rule(SPARE as usize).on(pair[1] + step * k, pair[1] + step * (k + 1.0));
                        places.map(|(u, weight)| weight * self.slope(half_length / u.cosh())).sum::<f64>()
                    };
                    (0..parts as usize).map(|k| part(k as f64)).sum::<f64>()
                });
                pieces.sum()
            }
        }
    }

    /// Slope of a power of |x| at x = a, over P'.
    pub(super) fn amplitude(&self, half_length: f64, length: f64, exponent: f64, coefficient: f64) -> f64 {
        let s = half_length * self.length / length;
        coefficient * exponent / length * s.powf(exponent - 1.0) / self.force
    }

    /// The rows of a profile that is analytic up to its edge, by Gauss-Chebyshev quadrature.
    fn analytic_rows(&self, half_length: f64, slopes: &mut Slopes) {
        // Chebyshev coefficients fall like ρ^(−k)
        let digits = self.edge().map_or(0.0, |limit| {
            let ratio = (limit / half_length).max(1.0 + 1e-9);
            20.0 / (ratio + (ratio * ratio - 1.0).sqrt()).ln()
        });
        let rows = slopes.value.len().min(2 + (0.5 * digits.min(20_000.0)) as usize);
        let points = rows + 4 + digits.min(20_000.0) as usize;
        for q in 0..points {
            // the other half of the 2·points nodes is the mirror image
            let theta = PI * (q as f64 + 0.5) / (2 * points) as f64;
            self.add_place(theta, PI / points as f64, half_length, rows, slopes);
        }
    }

    /// Adds what the slope at x = a cos θ contributes to the first `rows` rows.
    fn add_place(&self, theta: f64, weight: f64, half_length: f64, rows: usize, slopes: &mut Slopes) {
        let s = theta.cos();
        let x = half_length * s * self.length;
        let weight = weight / self.force;
        let (value, slope) = (weight * self.shape.slope(x), weight * x * self.shape.curvature(x));
        // −cos(3θ), cos(5θ), ... from cos θ
        let turn = 2.0 * (2.0 * theta).cos();
        let (mut before, mut test) = (-s, s);
        for (row, derivative) in slopes.value.iter_mut().zip(&mut slopes.slope).take(rows) {
            *row += value * test;
            *derivative += slope * test;
            (before, test) = (test, -turn * test - before);
        }
    }

    /// Places θ from 0 to π/2 and weights that integrate, piece by piece, what oscillates like cos(phase · θ).
    fn places(&self, pieces: &[Piece], half_length: f64, phase: f64) -> impl Iterator<Item = (f64, f64)> {
        let angle = |start: f64| (start / (half_length * self.length)).acos();
        let mut ends: Vec<f64> = covered(pieces, half_length * self.length).map(angle).collect();
        ends.push(0.0);
        let ends: Vec<(f64, f64)> = ends.windows(2).map(|pair| (pair[1], pair[0])).collect();
        ends.into_iter().flat_map(move |(from, to)| {
            let parts = (phase * (to - from) / PHASE).ceil().max(1.0);
            let step = (to - from) / parts;
            let points = rule((0.5 * phase * step + SPARE) as usize);
            (0..parts as usize).flat_map(move |part| {
                let from = from + step * part as f64;
                points.on(from, from + step).collect::<Vec<_>>()
            })
        })
    }
}

/// Where the pieces begin that a contact covers.
pub(super) fn covered(pieces: &[Piece], half_length: f64) -> impl Iterator<Item = f64> {
    pieces.iter().map(|piece| piece.start).take_while(move |start| *start < half_length)
}

/// The rows of amplitude · |s|^power sign(s): ∫ cos^ν θ cos kθ dθ from 0 to π/2 is a product of gamma functions.
fn power_rows(power: f64, amplitude: f64, slopes: &mut Slopes) {
    let mut value = 2.0 * amplitude * wallis(power + 1.0);
    for (m, (row, slope)) in slopes.value.iter_mut().zip(&mut slopes.slope).enumerate() {
        *row += value;
        *slope += power * value;
        let k = order(m);
        value *= (k - power) / (k + power + 2.0);
    }
}

/// ∫ cos^n θ dθ from 0 to π/2.
pub(super) fn wallis(n: f64) -> f64 {
    FRAC_PI_2.sqrt() * std::f64::consts::FRAC_1_SQRT_2 * libm::tgamma(0.5 * n + 0.5) / libm::tgamma(0.5 * n + 1.0)
}

/// Continues modes by the modes of the local pressure, tapered to nothing at their end, so that the sum of all converges fast
/// wherever the pressure is smooth.
pub(crate) fn continued(modes: &mut Vec<f64>, local: &[f64]) {
    let from = modes.len();
    for (m, y) in local.iter().enumerate().skip(from) {
        // a smooth step from 1 to 0
        let t = (m - from) as f64 / (local.len() - from) as f64;
        let step = if t == 0.0 { 1.0 } else { 0.5 * libm::erfc(3.5 * (2.0 * t - 1.0) / (4.0 * t * (1.0 - t)).sqrt()) };
        modes.push(step * y);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::problem::modes::alternating;

    fn unit(punch: &Punch) -> Profile<'_> {
        Profile::new(punch, 1.0, 1.0, Twin::Plane)
    }

    /// The rows by a rule of very many points.
    fn brute(punch: &Punch, half_length: f64, rows: usize) -> Vec<f64> {
        let points = 1_000_000;
        let mut sums = vec![0.0; rows];
        for q in 0..points {
            let theta = FRAC_PI_2 * (q as f64 + 0.5) / f64::from(points);
            let slope = punch.slope(half_length * theta.cos()) * PI / f64::from(points);
            for (m, sum) in sums.iter_mut().enumerate() {
                *sum += alternating(m) * slope * (order(m) * theta).cos();
            }
        }
        sums
    }

    #[test]
    fn rows_are_integrals_of_the_slope() {
        for punch in [
            Punch::cylinder(2.0).unwrap(),
            Punch::parabola(2.0).unwrap(),
            Punch::wedge(0.3).unwrap(),
            Punch::power(2.7, 1.3, 0.1).unwrap(),
            Punch::polynomial(1.3, &[0.1, -0.02, 0.1]).unwrap(),
            Punch::rounded_flat(0.8, 3.0).unwrap(),
            Punch::table(&[(0.0, 0.1), (0.3, 0.2), (0.9, 0.5), (1.5, 1.9)]).unwrap(),
        ] {
            let found = unit(&punch).slopes(1.2, 9);
            for (found, expected) in found.value.iter().zip(brute(&punch, 1.2, 9)) {
                assert!((found - expected).abs() < 1e-9, "{punch}: {found} {expected}");
            }
            let step = 1e-6;
            let [more, less] = [step, -step].map(|step: f64| unit(&punch).slopes(1.2 * step.exp(), 9));
            for ((slope, more), less) in found.slope.iter().zip(more.value).zip(less.value) {
                assert!((slope - (more - less) / (2.0 * step)).abs() < 1e-7, "{punch}");
            }
        }
    }

    #[test]
    fn all_rows_together_are_the_pressure_at_the_tip() {
        for punch in [
            Punch::cylinder(2.0).unwrap(),
            Punch::power(3.5, 1.3, 0.1).unwrap(),
            Punch::rounded_flat(0.4, 3.0).unwrap(),
            Punch::table(&[(0.0, 0.1), (0.3, 0.2), (0.9, 0.5), (1.5, 1.9)]).unwrap(),
        ] {
            let indentation = unit(&punch);
            let sum: f64 = indentation.slopes(1.2, 4000).value.iter().sum();
            assert!((sum / indentation.apex(1.2) - 1.0).abs() < 1e-6, "{punch}: {sum} {}", indentation.apex(1.2));
        }
        let wedge = Punch::wedge(1.0).unwrap();
        assert_eq!(unit(&wedge).apex(1.0), f64::INFINITY);
    }

    #[test]
    fn long_series_stay_exact() {
        // a flat punch whose corners are so far out that they hardly round it: ± 2 sin(kθ_c)/k dominates
        let punch = Punch::rounded_flat(1.0, 1.0).unwrap();
        let rows = unit(&punch).slopes(2.0, 2000).value;
        let corner = 0.5f64.acos();
        for m in [0, 10, 500, 1999] {
            let k = order(m);
            // ∫ (2 cos θ − 1) cos kθ dθ from 0 to θ_c, twice
            let sinc = |n: f64| if n == 0.0 { corner } else { (n * corner).sin() / n };
            let exact = 2.0 * (sinc(k - 1.0) + sinc(k + 1.0) - sinc(k));
            assert!((alternating(m) * rows[m] - exact).abs() < 1e-13, "{m}: {} {exact}", rows[m]);
        }
    }
}
