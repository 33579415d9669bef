//! Derivatives of the residuals with respect to the ends of the intervals, pressures given.
//!
//! Integrals over wavenumbers are differentiated exactly, as the middle of each interval moves and as its half-length grows: their
//! Bessel functions are those of the equations. What is found in space is smooth and takes little: differences serve.
use std::f64::consts::PI;

use faer::Mat;

use crate::contact::parts::equations::{Equations, System, Waves};
use crate::contact::parts::interval::{Motion, Table};
use crate::contact::parts::{ends, with_ends};
use crate::numeric::dot;

/// Differences are taken over this part of the intervals next to an end.
const DIFFERENCE: f64 = 1e-6;
/// Both motions of an interval have a column each.
const MOTIONS: [Motion; 2] = [Motion::Shift, Motion::Growth];

/// What all pressures of a contact do at some wavenumbers, and what changes as its intervals move.
struct Fields {
    tests: Mat<f64>,
    plain: Vec<f64>,
    remainder: Vec<f64>,
    /// For each motion of each interval of the contact: its column, and derivatives of `plain` and `remainder`.
    moved: Vec<(usize, [Vec<f64>; 2])>,
}

impl Equations<'_> {
    /// Derivatives of the residuals in the order of the system, with respect to the ends, in units of `spacings`; `None` if two
    /// intervals nearly touch.
    pub(super) fn by_ends(&self, system: &System, pressures: &[f64], spacings: &[f64]) -> Option<Mat<f64>> {
        let here = self.in_space(pressures);
        let at = ends(self.intervals);
        let mut in_space = Mat::zeros(here.len(), at.len());
        for (by, spacing) in spacings.iter().enumerate() {
            let mut moved = at.clone();
            moved[by] += DIFFERENCE * spacing;
            let intervals = with_ends(self.intervals, &moved)?;
            let there = Equations { intervals: &intervals, ..*self }.in_space(pressures);
            for (row, (there, here)) in there.iter().zip(&here).enumerate() {
                in_space[(row, by)] = (there - here) / DIFFERENCE;
            }
        }
        let of_tests: Vec<Mat<f64>> = self.by_motions(pressures).iter().map(|m| self.of_ends(m, spacings)).collect();
        Some(self.in_order(system, &of_tests, &in_space))
    }

    /// Derivatives with respect to ends from those with respect to motions: an end moves by the sum or the difference of both.
    fn of_ends(&self, by_motions: &Mat<f64>, spacings: &[f64]) -> Mat<f64> {
        let mut columns = Vec::new();
        for (index, interval) in self.intervals.iter().enumerate() {
            if interval.is_central() {
                columns.push((index, [0.0, 1.0]));
            } else {
                columns.extend([(index, [0.5, -0.5]), (index, [0.5, 0.5])]);
            }
        }
        Mat::from_fn(by_motions.nrows(), columns.len(), |row, column| {
            let (index, [shift, growth]) = columns[column];
            let motions = shift * by_motions[(row, 2 * index)] + growth * by_motions[(row, 2 * index + 1)];
            motions * spacings[column]
        })
    }

    /// Derivatives of the integrals over wavenumbers, for the tests of each contact.
    fn by_motions(&self, pressures: &[f64]) -> Vec<Mat<f64>> {
        let n = self.contacts();
        let mut sums: Vec<Mat<f64>> =
            (0..n).map(|contact| Mat::zeros(self.rows_of(contact), 2 * self.intervals.len())).collect();
        for nodes in self.stretches() {
            let first = nodes.start;
            let fields: Vec<Fields> =
                (0..n).map(|contact| self.fields(contact, self.within(contact, nodes.clone()), pressures)).collect();
            for contact in self.first()..n {
                let own = &fields[contact];
                let scaled = |weights: &[f64], field: &[f64], sign: f64, into: &mut [f64]| {
                    let terms = weights.iter().skip(first).zip(&self.layout.zeta[first..]).zip(field);
                    for (into, ((weight, zeta), value)) in into.iter_mut().zip(terms) {
                        *into += sign * weight * zeta / PI * value;
                    }
                };
                // what the tests of this contact see
                let mut seen = vec![0.0; own.tests.nrows()];
                let mut moved = Mat::zeros(own.tests.nrows(), 2 * self.intervals.len());
                scaled(&self.layout.own[contact].unit.plain, &own.plain, 1.0, &mut seen);
                for (column, [plain, _]) in &own.moved {
                    scaled(&self.layout.own[contact].unit.plain, plain, 1.0, moved.col_as_slice_mut(*column));
                }
                for (other, weights) in self.neighbours(contact) {
                    scaled(&weights.plain, &own.remainder, 1.0, &mut seen);
                    scaled(&weights.plain, &fields[other].remainder, -1.0, &mut seen);
                    for (sign, fields) in [(1.0, own), (-1.0, &fields[other])] {
                        for (column, [_, remainder]) in &fields.moved {
                            scaled(&weights.plain, remainder, sign, moved.col_as_slice_mut(*column));
                        }
                    }
                }
                sums[contact] += own.tests.transpose() * &moved;
                self.add_moved_tests(contact, self.within(contact, nodes.clone()), &seen, &mut sums[contact]);
            }
        }
        sums
    }

    /// What the pressures of a contact do at some wavenumbers.
    fn fields(&self, contact: usize, nodes: std::ops::Range<usize>, pressures: &[f64]) -> Fields {
        let zeta = &self.layout.zeta[nodes.clone()];
        if contact < self.first() {
            let remainder = self.given(nodes.start, zeta.len());
            return Fields { tests: Mat::new(), plain: Vec::new(), remainder, moved: Vec::new() };
        }
        let waves = self.waves(contact, nodes);
        let own = &pressures[self.places_of(contact)];
        let (plain, remainder) = (waves.field(own, false), waves.field(own, true));
        let beyond = self.beyond(zeta);
        let mut moved = Vec::new();
        for (index, interval) in self.of(contact) {
            let table = Table::new(interval, self.count, zeta, &beyond);
            let own = &pressures[index * self.count..(index + 1) * self.count];
            for (k, motion) in MOTIONS.into_iter().enumerate() {
                moved.push((2 * index + k, table.moved_transform(own, motion)));
            }
        }
        let Waves { tests, .. } = waves;
        Fields { tests, plain, remainder, moved }
    }

    /// Adds what changes as the tests of a contact, and the gaps in it, move in a field.
    fn add_moved_tests(&self, contact: usize, nodes: std::ops::Range<usize>, seen: &[f64], sums: &mut Mat<f64>) {
        let zeta = &self.layout.zeta[nodes];
        let beyond = self.beyond(zeta);
        let mut at = 0;
        for (index, interval) in self.of(contact) {
            let table = Table::new(interval, self.count, zeta, &beyond);
            for (k, motion) in MOTIONS.into_iter().enumerate() {
                for (row, value) in table.moved_tests(motion, seen).into_iter().enumerate() {
                    sums[(at + row, 2 * index + k)] += value;
                }
            }
            if let Some([from, to]) = self.opening(index) {
                let row = at + self.rows(index) - 1;
                let sine = |x: f64| {
                    let sines: Vec<f64> = zeta.iter().map(|zeta| (zeta * x).sin()).collect();
                    dot(&sines, seen)
                };
                let (from, to) = (sine(from), sine(to));
                for (column, value) in
                    [(2 * index - 2, -from), (2 * index - 1, -from), (2 * index, to), (2 * index + 1, -to)]
                {
                    sums[(row, column)] += value;
                }
            }
            at += self.rows(index);
        }
    }
}
