//! The slopes of gaps that waves of pressures make, and how contacts and openings meet each other's waves.
use std::f64::consts::PI;
use std::ops::Range;

use crate::contact::integrals::samples::Samples;
use crate::contact::intervals::equations::{Equations, Sampled};
use crate::contact::intervals::waves::{AT_ONCE, Long};

impl Equations<'_> {
    /// The part, real or imaginary, of another contact's waves that makes a part of the slopes or pressures of a contact, with its sign: a pressure and the slope of a gap are a quarter of a
    /// wave apart. Where all is even a pressure has a real part alone, and a slope an imaginary one.
    fn shifted(&self, contact: usize, other: usize, part: usize) -> (usize, f64) {
        match (self.is_opened(contact), self.is_opened(other)) {
            (own, there) if own == there => (part, 1.0),
            _ if self.moves => (1 - part, 1.0 - 2.0 * part as f64),
            (is_opened, _) => (part, if is_opened { -1.0 } else { 1.0 }),
        }
    }

    fn is_opened(&self, contact: usize) -> bool {
        self.problem.is_opened(contact)
    }

    /// Weights of both parts of the waves of a contact, or of an opening as contacts meet these, as weights of the waves as they are.
    pub(super) fn met_by_contacts(&self, contact: usize, weights: [&[f64]; 2]) -> Vec<f64> {
        let count = weights[0].len();
        let mut all = vec![0.0; self.parts() * count];
        for (part, weights) in weights.into_iter().take(self.parts()).enumerate() {
            let (from, sign) = self.shifted(0, contact, part);
            all[from * count..].iter_mut().zip(weights).for_each(|(into, weight)| *into = sign * weight);
        }
        all
    }

    /// Hands out, block by block of wavenumbers, the columns of each contact, and the slopes of waves that pressures with each of some sets of amplitudes make
    /// outside contacts, weights included, what half-planes do left out: both parts of exp(iζx), one after the other.
    pub(super) fn responses(
        &self,
        sets: &[Vec<Vec<f64>>],
        mut each: impl FnMut([usize; 2], Range<usize>, &Sampled, &[f64]),
    ) {
        for (number, first) in (0..self.layout.zeta.len()).step_by(AT_ONCE).enumerate() {
            let sampled = self.sampled(number);
            for (set, amplitudes) in sets.iter().enumerate() {
                let of = |((waves, long), amplitudes): ((&Samples, &Long), &Vec<f64>)| {
                    let less = waves.combine(amplitudes);
                    let all = long.added_to(&less, amplitudes);
                    [less, all]
                };
                let fields: Vec<[Vec<f64>; 2]> =
                    sampled.waves.iter().zip(&sampled.long).zip(amplitudes).map(of).collect();
                for contact in self.problem.unknown() {
                    let response = self.response(contact, first, &fields);
                    let nodes = first..first + self.zeta(contact, first..first + AT_ONCE).len();
                    each([set, contact], nodes, &sampled, &response);
                }
            }
        }
    }

    /// The same of one contact, from a wavenumber on, from the waves of all pressures, first less what resultants and moments do.
    fn response(&self, contact: usize, first: usize, fields: &[[Vec<f64>; 2]]) -> Vec<f64> {
        let (parts, kernel) = (self.parts(), self.problem.kernel);
        let [less, all] = &fields[contact];
        let count = all.len() / parts;
        let mut response = vec![0.0; all.len()];
        for (other, pair) in kernel.neighbours(contact) {
            let there = fields[other][0].len() / parts;
            let weights = self.coupling(pair, first);
            for part in 0..parts {
                let sums = response[part * count..].iter_mut().take(count.min(there)).zip(weights).enumerate();
                match self.is_opened(contact) || self.is_opened(other) {
                    // neighbours have resultants and moments in common
                    false => sums.for_each(|(k, (sum, weight))| {
                        *sum += weight / PI * (less[part * count + k] - fields[other][0][part * there + k]);
                    }),
                    true => {
                        let (from, sign) = self.shifted(contact, other, part);
                        let from = from * there;
                        sums.for_each(|(k, (sum, weight))| *sum -= sign * weight / PI * fields[other][1][from + k]);
                    }
                }
            }
        }
        for (response, own) in response.chunks_mut(count.max(1)).zip(all.chunks(count.max(1))) {
            let sums = response.iter_mut().zip(own).zip(self.own(contact, first));
            sums.for_each(|((sum, own), weight)| *sum += weight / PI * own);
        }
        response
    }

    /// The columns of one contact as another one meets them through a coupling, if not less what resultants and moments do: of openings with that, and a quarter of a wave aside between a pressure
    /// and the slope of a gap.
    pub(super) fn met(&self, sampled: &Sampled, other: usize, contact: usize) -> Option<Samples> {
        let (waves, long, parts) = (&sampled.waves[other], &sampled.long[other], self.parts());
        if !self.is_opened(contact) && !self.is_opened(other) {
            return None;
        }
        let mut met = Samples::zeros(waves.rows(), waves.count()).clear_like(waves);
        let count = waves.rows() / parts;
        for column in waves.filled().flatten() {
            let told = long.places.iter().position(|place| *place == column).map(|told| long.values.column(told));
            for part in 0..parts {
                let (from, sign) = self.shifted(contact, other, part);
                let from = from * count;
                for (k, into) in met.column_mut(column)[part * count..(part + 1) * count].iter_mut().enumerate() {
                    let long = told.map_or(0.0, |told| told[from + k]);
                    *into = sign * (waves.column(column)[from + k] + long);
                }
            }
        }
        Some(met)
    }
}
