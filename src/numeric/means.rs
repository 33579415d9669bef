//! Means over the middle of contacts: of waves, and of profiles.
//!
//! With the weights (1 − t²)ⁿ the mean of cos λx over |x| < a, t = x/a, is Γ(ν + 1) (2/z)^ν J_ν(z), z = λa, with ν = n + 1/2; the mean of
//! J₀(λr) over a disc is the same with ν = n + 1. Both fall so fast that a mean takes no part of waves that are short compared with the
//! contact, which singular pressures and graded faces are rich in, and needs no closed forms. Source: Abramowitz and Stegun 1964, 9.1.20.
use std::f64::consts::PI;

use super::bessel::{self, Kind, Wanted};
use super::quadrature;

/// The power n of the weights.
const FLAT: usize = 12;
/// The last term of a pressure on a half-plane of which the mean over its contact takes any part.
pub(crate) const FELT: usize = 2 * FLAT + 1;
/// Next to z = 0 the mean of a wave less 1 is the sum of this many terms of a series; without cancellation up to there.
const SERIES: f64 = 4.0;
const TERMS: i32 = 16;
/// Gauss points for the mean of a piece of a profile.
const NODES: usize = 48;
/// Windows are made the same where the binary logarithms of their half-lengths differ by less than this: a layer much thinner
/// than these bends so easily that errors of pressures move both of its faces by far more than they bring them together.
const ALIKE: f64 = 1.0;

/// An interval over which displacements are averaged, and its mirror image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MeanWindow {
    pub(crate) middle: f64,
    /// Half its length; the radius about an axis.
    pub(crate) half: f64,
}

impl MeanWindow {
    /// Whether another window lies inside.
    pub(crate) fn contains(&self, other: &Self) -> bool {
        (other.middle - self.middle).abs() + other.half <= self.half
    }

    /// The wavenumber beyond which a mean has less of a wave than that, since |J_ν(z)| hardly exceeds √(2/πz).
    pub(crate) fn last(&self, negligible: f64) -> f64 {
        let order = FLAT as f64 + 0.5;
        let largest = libm::tgamma(order + 1.0) / PI.sqrt();
        2.0 * (largest / negligible).powf((order + 0.5).recip()) / self.half
    }

    /// The means of waves exp(iλx): real parts less 1, and imaginary parts.
    pub(crate) fn of_waves(&self, is_round: bool, wavenumbers: &[f64]) -> Vec<[f64; 2]> {
        let arguments: Vec<f64> = wavenumbers.iter().map(|wavenumber| wavenumber * self.half).collect();
        let (count, first) = (arguments.len(), if is_round { FLAT + 1 } else { FLAT });
        let mut table = vec![0.0; (first + 1) * count];
        let kind = if is_round { Kind::Integer } else { Kind::Spherical };
        bessel::scaled_orders(first + 1, Wanted::ALL.of_kind(kind), &arguments, 1.0, count, &mut table);
        // Γ(ν + 1) (2/z)^ν J_ν, next to z = 0 as a series of q = −z²/4
        let less_one = |i: usize, z: f64| {
            let b = first as f64 + if is_round { 1.0 } else { 1.5 };
            if z < SERIES {
                let q = -0.25 * z * z;
                return (0..TERMS).rev().fold(0.0, |sum, k| q * (1.0 + sum) / (f64::from(k + 1) * (b + f64::from(k))));
            }
            let factor = |k: usize| if is_round { 2.0 * k as f64 / z } else { (2 * k + 1) as f64 / z };
            (1..=first).map(factor).product::<f64>() * table[first * count + i] - 1.0
        };
        let of = |(i, (z, wavenumber)): (usize, (&f64, &f64))| {
            let mean = less_one(i, *z);
            if self.middle == 0.0 {
                return [mean, 0.0];
            }
            // about another middle
            let (sin, cos) = (0.5 * wavenumber * self.middle).sin_cos();
            [mean - 2.0 * sin * sin * (1.0 + mean), 2.0 * sin * cos * (1.0 + mean)]
        };
        arguments.iter().zip(wavenumbers).enumerate().map(of).collect()
    }

    /// The mean of a profile; its pieces begin at these places.
    pub(crate) fn of_profile(&self, is_round: bool, profile: impl Fn(f64) -> f64, starts: &[f64]) -> f64 {
        let first = if is_round { 0.0 } else { -1.0 };
        let mut ends: Vec<f64> = starts.iter().map(|start| (start - self.middle) / self.half).collect();
        ends.retain(|t| *t > first && *t < 1.0);
        ends.extend([first, 1.0]);
        ends.sort_by(f64::total_cmp);
        let [mut sum, mut weights] = [0.0; 2];
        for (t, weight) in ends.windows(2).flat_map(|pair| quadrature::rule(NODES).on(pair[0], pair[1])) {
            let x = self.middle + self.half * t;
            let around = if is_round { x } else { 1.0 };
            let weight = weight * around * (1.0 - t * t).powi(FLAT as i32);
            sum += weight * profile(x);
            weights += weight;
        }
        sum / weights
    }

    /// Windows on contacts from the top down that touch between these ends: about the middle of the widest interval, or as far as the bodies touch about the same place as above.
    /// Those of neighbours that are nearly the same are made the same. Where no bodies touch it is the window above.
    pub(crate) fn on_contacts(contacts: &[Vec<[f64; 2]>]) -> Vec<Self> {
        let mut windows: Vec<Self> = Vec::with_capacity(contacts.len());
        for intervals in contacts {
            let about = windows.last().map(|above| above.middle);
            let touches = |own: &&[f64; 2]| about.is_some_and(|x| own[0] < x && x < own[1]);
            let widest = || intervals.iter().max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
            let window = match (intervals.iter().find(touches), about) {
                (Some(own), Some(middle)) => Self { middle, half: (own[1] - middle).min(middle - own[0]) },
                _ => {
                    let Some([left, right]) = widest() else {
                        windows.extend(windows.last().copied());
                        continue;
                    };
                    Self { middle: 0.5 * (left + right), half: 0.5 * (right - left) }
                }
            };
            windows.push(window);
        }
        Self::equalise(&mut windows);
        windows
    }

    fn equalise(windows: &mut [Self]) {
        for alike in windows.chunk_by_mut(|a, b| a.middle == b.middle && (a.half / b.half).log2().abs() < ALIKE) {
            let least = alike.iter().fold(f64::INFINITY, |least, window| least.min(window.half));
            alike.iter_mut().for_each(|window| window.half = least);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::quadrature::rule;
    use super::*;

    #[test]
    fn means_of_waves_are_integrals() {
        for is_round in [false, true] {
            let window = MeanWindow { middle: if is_round { 0.0 } else { 0.7 }, half: 0.5 };
            for wavenumber in [1e-3, 0.8, 7.9, 8.1, 40.0] {
                let [mut integral, mut weights] = [0.0; 2];
                for (t, weight) in rule(60).on(if is_round { 0.0 } else { -1.0 }, 1.0) {
                    let x = window.middle + window.half * t;
                    let z = wavenumber * x.abs();
                    let mut bessel = [0.0];
                    bessel::table(1, &[z], &mut bessel);
                    let (wave, around) = if is_round { (bessel[0], x.abs()) } else { (z.cos(), 1.0) };
                    let weight = weight * around * (1.0 - t * t).powi(FLAT as i32);
                    integral += weight * (wave - 1.0);
                    weights += weight;
                }
                let ([mean, _], expected) = (window.of_waves(is_round, &[wavenumber])[0], integral / weights);
                assert!((mean - expected).abs() < 1e-13, "{is_round} {wavenumber}: {mean} {expected}");
            }
        }
    }
}
