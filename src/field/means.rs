//! Means of displacements over the middle of contacts, from their transforms.
//!
//! With the weights (1 − t²)ⁿ the mean of cos λx over |x| < a, t = x/a, is Γ(ν + 1) (2/z)^ν J_ν(z), z = λa, with ν = n + 1/2; the mean of
//! J₀(λr) over a disc is the same with ν = n + 1. Both fall so fast that a mean takes no part of waves that are short compared with the
//! contact, which singular pressures and graded faces are rich in, and needs no closed forms. Source: Abramowitz and Stegun 1964, 9.1.20.
use std::f64::consts::PI;

use recede_layers::{Isotropic, State, Wave};

use super::Field;
use super::body::LoadedBody;
use super::error::FieldError;
use super::sum::{Symmetry, load};
use super::surface::Surface;
use super::waves::{self, CutOff, WavePanel};
use crate::numeric::bessel::{self, Kind, Wanted};
use crate::system::Unresolved;

/// The power n of the weights.
pub(crate) const FLAT: usize = 12;
/// A mean has less than 1e-12 of a wave beyond the wavenumber LAST/a: it is left out.
const LAST: f64 = 80.0;
/// Next to z = 0 the mean of a wave less 1 is the sum of this many terms of a series; without cancellation up to there.
const SERIES: f64 = 4.0;
const TERMS: i32 = 16;

/// An interval over which displacements are averaged, and its mirror image.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MeanWindow {
    pub(crate) middle: f64,
    /// Half its length; the radius about an axis.
    pub(crate) half: f64,
}

impl MeanWindow {
    /// The means of waves less 1, with the weights (1 − t²)ⁿ and with t² times these.
    fn of_waves(&self, is_round: bool, wavenumbers: &[f64]) -> Vec<[f64; 2]> {
        let arguments: Vec<f64> = wavenumbers.iter().map(|wavenumber| wavenumber * self.half).collect();
        let (count, first) = (arguments.len(), if is_round { FLAT + 1 } else { FLAT });
        let mut table = vec![0.0; (first + 2) * count];
        let kind = if is_round { Kind::Integer } else { Kind::Spherical };
        bessel::scaled_orders(first + 2, Wanted::ALL.of_kind(kind), &arguments, 1.0, count, &mut table);
        // Γ(ν + 1) (2/z)^ν J_ν, next to z = 0 as a series of q = −z²/4
        let less_one = |i: usize, order: usize, z: f64| {
            let b = order as f64 + if is_round { 1.0 } else { 1.5 };
            if z < SERIES {
                let q = -0.25 * z * z;
                return (0..TERMS).rev().fold(0.0, |sum, k| q * (1.0 + sum) / (f64::from(k + 1) * (b + f64::from(k))));
            }
            let factor = |k: usize| if is_round { 2.0 * k as f64 / z } else { (2 * k + 1) as f64 / z };
            (1..=order).map(factor).product::<f64>() * table[order * count + i] - 1.0
        };
        // ∫ t² w is the difference of two such integrals
        let share = if is_round { FLAT as f64 + 2.0 } else { 2.0 * FLAT as f64 + 3.0 };
        let of = |(i, (z, wavenumber)): (usize, (&f64, &f64))| {
            let [mean, next] = [0, 1].map(|more| less_one(i, first + more, *z));
            // cos λx about another middle
            let sin = (0.5 * wavenumber * self.middle).sin();
            let less = 2.0 * sin * sin;
            [mean, share * mean - (share - 1.0) * next].map(|mean| mean - less * (1.0 + mean))
        };
        arguments.iter().zip(wavenumbers).enumerate().map(of).collect()
    }
}

impl Field {
    /// The sum over all contacts of the mean by which the face above is higher than the face below, twice, with each set of weights. `punch`
    /// is the material of an elastic punch, which is the body above the first contact; rigid bodies do not move.
    pub(crate) fn apart(&self, windows: &[MeanWindow], punch: Option<&Isotropic>) -> Result<[f64; 2], FieldError> {
        let (ends, panels) = self.mean_panels(windows)?;
        let flattening = punch.and_then(|punch| {
            let surface = Surface::of_half_plane(punch.material(self.geometry.plane()), self.modulus)?;
            Some(surface.transformed(1.0, 0.0)[4])
        });
        let is_round = self.geometry.is_axisymmetric();
        let mut sums = [0.0; 2];
        // for each body the measure of the longest waves
        let mut longest = vec![0.0; self.bodies.len()];
        for panel in &panels {
            let waves = self.waves(panel, &ends);
            let of = |window: &MeanWindow| window.of_waves(is_round, &waves.wavenumbers);
            let means: Vec<Vec<[f64; 2]>> = windows.iter().map(of).collect();
            for (q, (wavenumber, weight)) in waves.wavenumbers.iter().zip(&waves.weights).enumerate() {
                let measure = weight * if is_round { *wavenumber } else { PI.recip() };
                // of two faces, each with its contact: that they move together does not cancel
                let mut add =
                    |measure: f64, (upper, above): (f64, Option<usize>), (lower, below): (f64, Option<usize>)| {
                        let factor = measure / (wavenumber * self.modulus);
                        let mean = |contact: Option<usize>| contact.map_or([0.0; 2], |contact| means[contact][q]);
                        for (sum, (above, below)) in sums.iter_mut().zip(mean(above).into_iter().zip(mean(below))) {
                            *sum += factor * ((lower - upper) + lower * below - upper * above);
                        }
                    };
                if let Some(flattening) = flattening {
                    add(measure, (flattening * waves.transforms[0][q].value.re, Some(0)), (0.0, None));
                }
                let bodies = self.bodies.iter().zip(&mut longest);
                for (body, longest) in
                    bodies.filter(|(body, _)| body.contacts().any(|contact| *wavenumber <= ends[contact].end))
                {
                    let own = measure + std::mem::take(longest);
                    // a laminate of unlike layers that is squeezed bends so much in long waves that its faces move by more digits than they come together by
                    let reach = body.contacts().map(|contact| windows[contact].half).fold(0.0, f64::max);
                    if body.bottom.is_some() && wavenumber * reach < waves::LONG {
                        *longest = own;
                        continue;
                    }
                    let transform = |contact: usize| Symmetry::Even.of(&waves.transforms[contact][q]);
                    let [top, bottom] = self.face_displacements(body, *wavenumber, transform)?;
                    let below = body.bottom.map(|_| body.contact + 1);
                    add(own, (top, Some(body.contact)), (bottom, below));
                }
            }
        }
        Ok(sums)
    }

    /// For each contact the wavenumber beyond which no mean has a part of its pressure, and panels up to the largest of these.
    fn mean_panels(&self, windows: &[MeanWindow]) -> Result<(Vec<CutOff>, Vec<WavePanel>), FieldError> {
        let own = |i: usize| LAST / windows[i].half;
        let extent = |i: usize, k: usize| windows[i].middle + windows[i].half + self.length(k);
        let cut_off = |end: f64, extent: f64| CutOff { end, extent, own: extent };
        let mut ends: Vec<CutOff> = (0..windows.len()).map(|i| cut_off(own(i), extent(i, i))).collect();
        let mut cut_offs = ends.clone();
        for body in self.bodies.iter().filter(|body| body.bottom.is_some()) {
            let (i, k) = (body.contact, body.contact + 1);
            let last = &self.layers[body.layers.end - 1];
            let through = self.distance(last, last.thickness.unwrap_or(0.0), true);
            for (pressed, seen) in [(i, k), (k, i)] {
                let end = own(seen).min(waves::FULL.exponent / through);
                ends[pressed].end = ends[pressed].end.max(end);
                cut_offs.push(cut_off(end, extent(seen, pressed)));
            }
        }
        let farthest = cut_offs.iter().fold(0.0, |farthest: f64, cut_off| farthest.max(cut_off.extent));
        let panels = waves::panels(&cut_offs, self.origin(0.0), &waves::FULL);
        Ok((ends, panels.ok_or(FieldError::TooFar(farthest))?))
    }

    /// λμ₀V on the top face of a body, and on its bottom face, 0 if that is not loaded.
    fn face_displacements(
        &self,
        body: &LoadedBody,
        wavenumber: f64,
        transform: impl Fn(usize) -> [f64; 2],
    ) -> Result<[f64; 2], FieldError> {
        let wave = Wave { wavenumber, modulus: self.modulus, plane: self.geometry.plane() };
        let mut depths = vec![Vec::new(); body.layers.len()];
        depths[0].push(0.0);
        if let Some(last) = depths.last_mut().filter(|_| body.bottom.is_some()) {
            last.extend(self.layers[body.layers.end - 1].thickness);
        }
        let states =
            body.states(&wave, &depths, &load(body, wavenumber, transform)).ok_or(Unresolved { wavenumber })?;
        let of = |state: Option<&State>| state.map_or(0.0, |state| state[1]);
        let bottom = states.last().and_then(|states| states.last()).filter(|_| body.bottom.is_some());
        Ok([of(states.first().and_then(|states| states.first())), of(bottom)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::quadrature::rule;

    #[test]
    fn means_of_waves_are_integrals() {
        for is_round in [false, true] {
            let window = MeanWindow { middle: if is_round { 0.0 } else { 0.7 }, half: 0.5 };
            for wavenumber in [1e-3, 0.8, 7.9, 8.1, 40.0] {
                let [mut integrals, mut weights] = [[0.0; 2]; 2];
                for (t, weight) in rule(60).on(if is_round { 0.0 } else { -1.0 }, 1.0) {
                    let x = window.middle + window.half * t;
                    let z = wavenumber * x.abs();
                    let mut bessel = [0.0];
                    bessel::table(1, &[z], &mut bessel);
                    let (wave, around) = if is_round { (bessel[0], x.abs()) } else { (z.cos(), 1.0) };
                    let weight = weight * around * (1.0 - t * t).powi(FLAT as i32);
                    for (k, weight) in [weight, weight * t * t].into_iter().enumerate() {
                        integrals[k] += weight * (wave - 1.0);
                        weights[k] += weight;
                    }
                }
                let means = window.of_waves(is_round, &[wavenumber])[0];
                for (k, mean) in means.into_iter().enumerate() {
                    let expected = integrals[k] / weights[k];
                    assert!((mean - expected).abs() < 1e-13, "{is_round} {wavenumber} {k}: {mean} {expected}");
                }
            }
        }
    }
}
