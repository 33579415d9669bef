//! How far a punch sinks, from the kernels.
//!
//! Where bodies touch the one above is as high as the one below. So a punch sinks by the sum of how far pressures move the faces of all contacts towards each other, averaged about
//! the middle of each contact, and of how much higher the punch is there than at its lowest point. Waves move the faces of a contact by λμ₀C of its bodies under equal pressures,
//! and by what neighbours that carry other pressures bend a laminate between them: of the latter only the differences of the means at both contacts are left in the sum.
use std::f64::consts::PI;

use super::{Kernel, Values};
use crate::numeric::means::MeanWindow;
use crate::numeric::quadrature::{self, LARGEST, rule};

/// What waves of the pressure of one contact add to the depth.
pub(crate) struct DepthWaves<'a> {
    pub(crate) contact: usize,
    /// Wavenumbers ζ.
    pub(crate) zeta: &'a [f64],
    /// What ζ times the transform of the pressure less its resultant adds per unit of P' at each of them, by each mean.
    pub(crate) all: Vec<Vec<f64>>,
    /// The same of ζ times the resultant, which all contacts have in common.
    pub(crate) resultant: Vec<Vec<f64>>,
    /// The same of the odd transform less the moment, and of the moment, where nothing is even.
    pub(crate) odd: Vec<Vec<f64>>,
    pub(crate) moment: Vec<Vec<f64>>,
}

impl Kernel {
    /// Hands out, stretch by stretch, the waves of all contacts that add to the depth of a punch more than `negligible` of what the longest ones do. Depths are the first of the means over windows, or both, and
    /// contacts reach as far as `ends` from the middle.
    pub(crate) fn depth(
        &self,
        windows: &[MeanWindow],
        ends: &[f64],
        (negligible, count): (f64, usize),
        mut each: impl FnMut(&DepthWaves),
    ) {
        let seen: Vec<f64> = windows.iter().map(|window| window.last(negligible)).collect();
        // beyond its window a contact counts through couplings alone
        let reach = |contact: usize| {
            let through = self.neighbours(contact).map(|(other, laminate)| {
                let half = windows[contact].half.min(windows[other].half);
                self.uncoupled(laminate, half, negligible).min(seen[other])
            });
            through.fold(seen[contact], f64::max)
        };
        let reaches: Vec<f64> = (0..windows.len()).map(reach).collect();
        let (mut from, mut values) = (0.0, Values::default());
        loop {
            let counted: Vec<usize> = (0..windows.len()).filter(|contact| from < reaches[*contact]).collect();
            let Some(last) = counted.iter().map(|contact| reaches[*contact]).reduce(f64::min) else { return };
            let panel = self.panels.get(self.panels.partition_point(|panel| panel.to <= from));
            let to = panel.map_or(2.0 * from.max(1.0), |panel| panel.to).min(last);
            let farthest = counted.iter().map(|contact| ends[*contact]).fold(0.0, f64::max);
            let needed = quadrature::points(2.0 * farthest * (to - from), -negligible.log10());
            let parts = needed.div_ceil(LARGEST);
            let at = |k: usize| from + (to - from) * k as f64 / parts as f64;
            for [from, to] in (0..parts).map(|part| [at(part), at(part + 1)]) {
                let (zeta, weights): (Vec<f64>, Vec<f64>) = rule(needed.div_ceil(parts)).on(from, to).unzip();
                self.values(&zeta, [from, to], &mut values);
                self.weigh(windows, (&counted, count), &values, [&zeta, &weights], &mut each);
            }
            from = to;
        }
    }

    /// Hands out the same at some wavenumbers with weights.
    fn weigh(
        &self,
        windows: &[MeanWindow],
        (counted, count): (&[usize], usize),
        values: &Values,
        [zeta, weights]: [&[f64]; 2],
        each: &mut impl FnMut(&DepthWaves),
    ) {
        let is_round = self.geometry().is_axisymmetric();
        let measure = |wave: f64| if is_round { wave.recip() } else { (PI * wave * wave).recip() };
        let measures: Vec<f64> = zeta.iter().zip(weights).map(|(wave, weight)| weight * measure(*wave)).collect();
        let mut means: Vec<Vec<[[f64; 2]; 2]>> = Vec::with_capacity(windows.len());
        for (contact, window) in windows.iter().enumerate() {
            let above = contact.checked_sub(1).filter(|above| windows[*above] == *window);
            means.push(above.map_or_else(|| window.of_waves(is_round, zeta), |above| means[above].clone()));
        }
        let widest = (0..windows.len()).max_by(|a, b| windows[*a].half.total_cmp(&windows[*b].half)).unwrap_or(0);
        let nodes = || 0..zeta.len();
        for contact in counted.iter().copied() {
            let (own, common, kernel) = (&means[contact], &means[widest], values.equal_pressure(contact));
            // neighbours carry the same resultants and moments, which do nothing between them
            let bent = |k: usize, part: usize, mean: usize| {
                let of = |(other, laminate): (usize, usize)| {
                    values.coupling(laminate)[k] * (means[other][k][part][mean] - own[k][part][mean])
                };
                self.neighbours(contact).map(of).sum::<f64>()
            };
            let all = (0..count).map(|mean| {
                let equal = |k: usize| kernel[k] * (1.0 + own[k][0][mean]);
                nodes().map(|k| measures[k] * (equal(k) + bent(k, 0, mean))).collect::<Vec<f64>>()
            });
            let moment = (0..count).map(|mean| nodes().map(|k| measures[k] * kernel[k] * own[k][1][mean]).collect());
            let odd = (0..count).map(|mean| {
                nodes().map(|k| measures[k] * (kernel[k] * own[k][1][mean] + bent(k, 1, mean))).collect::<Vec<f64>>()
            });
            let resultant = (0..count).map(|mean| {
                // as far as the means are the same, equal resultants of all contacts do nothing but squeeze
                let squeezed =
                    |k: usize| if contact == widest { values.squeezed()[k] * (1.0 + common[k][0][mean]) } else { 0.0 };
                let differ = |k: usize| kernel[k] * (own[k][0][mean] - common[k][0][mean]);
                nodes().map(|k| measures[k] * (differ(k) + squeezed(k))).collect::<Vec<f64>>()
            });
            let (all, resultant, odd, moment) = (all.collect(), resultant.collect(), odd.collect(), moment.collect());
            each(&DepthWaves { contact, zeta, all, resultant, odd, moment });
        }
    }
}
