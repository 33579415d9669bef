//! How far a punch sinks, from the kernels.
//!
//! Where bodies touch the one above is as high as the one below. So a punch sinks by the sum of how far pressures move the faces of all contacts towards each other, averaged about
//! the middle of each contact, and of how much higher the punch is there than at its lowest point. Waves move the faces of a contact by λμ₀C of its bodies under equal pressures,
//! and by what neighbours that carry other pressures bend a laminate between them: of the latter only the differences of the means at both contacts are left in the sum. Where laminates
//! lie on each other the top face alone is averaged: pressures on it, and gaps that open below, move it.
use std::f64::consts::PI;
use std::ops::Range;

use super::{Kernel, Values};
use crate::numeric::means::MeanWindow;
use crate::numeric::quadrature::{self, LARGEST, rule};

/// What waves of the pressure of one contact add to the depth.
#[derive(Default)]
pub(crate) struct DepthWaves {
    /// Wavenumbers ζ.
    pub(crate) zeta: Vec<f64>,
    /// What ζ times the transform of the pressure less its resultant adds per unit of P' at each of them; below a closed interface, of the slope of a gap as the top face meets it.
    pub(crate) all: Vec<f64>,
    /// The same of ζ times the resultant, which all contacts have in common.
    pub(crate) resultant: Vec<f64>,
    /// The same of the odd transform less the moment, and of the moment, where nothing is even.
    pub(crate) odd: Vec<f64>,
    pub(crate) moment: Vec<f64>,
}

/// Means of waves over the windows of all contacts.
struct Means {
    /// Of each contact and wave.
    all: Vec<Vec<[f64; 2]>>,
    /// The contact with the widest window.
    widest: usize,
}

impl Kernel {
    /// The waves of each contact that add to the depth of a punch more than `negligible` of what the longest ones do; contacts reach as far as `ends` from the middle.
    pub(crate) fn depth(&self, windows: &[MeanWindow], ends: &[f64], negligible: f64) -> Vec<DepthWaves> {
        let seen: Vec<f64> = windows.iter().map(|window| window.last(negligible)).collect();
        // beyond its window a contact counts through couplings alone
        let reach = |contact: usize| {
            let through = self.sunk_by(contact).map(|(other, laminate)| {
                let half = windows[contact].half.min(windows[other].half);
                self.uncoupled(laminate, half, negligible).min(seen[other])
            });
            through.fold(if self.is_averaged(contact) { seen[contact] } else { 0.0 }, f64::max)
        };
        let reaches: Vec<f64> = (0..windows.len()).map(reach).collect();
        let (mut zeta, mut weights, mut stretches, mut from) = (Vec::new(), Vec::new(), Vec::new(), 0.0);
        loop {
            let counted = || (0..windows.len()).filter(|contact| from < reaches[*contact]);
            let Some(last) = counted().map(|contact| reaches[contact]).reduce(f64::min) else { break };
            let panel = self.panels.get(self.panels.partition_point(|panel| panel.to <= from));
            let to = panel.map_or(2.0 * from.max(1.0), |panel| panel.to).min(last);
            let farthest = counted().map(|contact| ends[contact]).fold(0.0, f64::max);
            let needed = quadrature::points(2.0 * farthest * (to - from), -negligible.log10());
            let parts = needed.div_ceil(LARGEST);
            let at = |k: usize| from + (to - from) * k as f64 / parts as f64;
            for [from, to] in (0..parts).map(|part| [at(part), at(part + 1)]) {
                let first = zeta.len();
                let points = rule(needed.div_ceil(parts)).on(from, to);
                points.for_each(|(wave, weight)| {
                    zeta.push(wave);
                    weights.push(weight * self.depth_measure(wave));
                });
                stretches.push(([from, to], first..zeta.len()));
            }
            from = to;
        }
        let is_round = self.geometry().is_axisymmetric();
        let mut means = Means { all: Vec::new(), widest: 0 };
        for (contact, window) in windows.iter().enumerate() {
            let above = contact.checked_sub(1).filter(|above| windows[*above] == *window);
            means.all.push(above.map_or_else(|| window.of_waves(is_round, &zeta), |above| means.all[above].clone()));
            if self.is_averaged(contact) && window.half >= windows[means.widest].half {
                means.widest = contact;
            }
        }
        let mut all: Vec<DepthWaves> = windows.iter().map(|_| DepthWaves::default()).collect();
        let mut values = Values::default();
        for ([from, to], nodes) in stretches {
            self.values(&zeta[nodes.clone()], [from, to], &mut values);
            for (contact, into) in all.iter_mut().enumerate().filter(|(contact, _)| from < reaches[*contact]) {
                into.zeta.extend(&zeta[nodes.clone()]);
                self.weigh(contact, &means, &values, (nodes.clone(), &weights), into);
            }
        }
        all
    }

    /// Whether the faces of a contact are averaged.
    fn is_averaged(&self, contact: usize) -> bool {
        contact <= self.lowest()
    }

    /// The other contacts whose faces a contact moves, with the numbers of their couplings.
    fn sunk_by(&self, contact: usize) -> impl Iterator<Item = (usize, usize)> {
        self.neighbours(contact).filter(|(other, _)| self.is_averaged(*other))
    }

    /// What a displacement has of a wave with the amplitude 1 of ζ times a transform.
    fn depth_measure(&self, wave: f64) -> f64 {
        if self.geometry().is_axisymmetric() { wave.recip() } else { (PI * wave * wave).recip() }
    }

    /// Adds the waves of a contact at some of all wavenumbers, which have these weights.
    fn weigh(
        &self,
        contact: usize,
        Means { all: means, widest }: &Means,
        values: &Values,
        (nodes, weights): (Range<usize>, &[f64]),
        into: &mut DepthWaves,
    ) {
        let first = nodes.start;
        let (own, common, kernel) =
            (&means[contact][first..], &means[*widest][first..], values.equal_pressure(contact));
        let coupled: Vec<(usize, &[f64])> =
            self.sunk_by(contact).map(|(other, laminate)| (other, values.coupling(laminate))).collect();
        if !self.is_averaged(contact) {
            for (k, weight) in weights[nodes].iter().enumerate() {
                let of = |(other, coupling): &(usize, &[f64])| means[*other][first + k].map(|mean| coupling[k] * mean);
                let [even, odd] = coupled.iter().map(of).fold([0.0; 2], |sum, own| [sum[0] + own[0], sum[1] + own[1]]);
                let whole: f64 = coupled.iter().map(|(_, coupling)| coupling[k]).sum();
                let [even, odd] = [weight * (whole + even), weight * odd];
                [&mut into.all, &mut into.resultant].into_iter().for_each(|all| all.push(even));
                [&mut into.odd, &mut into.moment].into_iter().for_each(|all| all.push(odd));
            }
            return;
        }
        // neighbours carry the same resultants and moments, which do nothing between them
        let bent = |k: usize, part: usize| {
            let of =
                |(other, coupling): &(usize, &[f64])| coupling[k] * (means[*other][first + k][part] - own[k][part]);
            coupled.iter().map(of).sum::<f64>()
        };
        for (k, weight) in weights[nodes].iter().enumerate() {
            // as far as the means are the same, equal resultants of all contacts do nothing but squeeze
            let squeezed = if contact == *widest { values.squeezed()[k] * (1.0 + common[k][0]) } else { 0.0 };
            let [even, odd] = own[k];
            into.all.push(weight * (kernel[k] * (1.0 + even) + bent(k, 0)));
            into.odd.push(weight * (kernel[k] * odd + bent(k, 1)));
            into.moment.push(weight * kernel[k] * odd);
            into.resultant.push(weight * (kernel[k] * (even - common[k][0]) + squeezed));
        }
    }
}
