//! Derivatives of the residuals with respect to the ends of the intervals, pressures given.
//!
//! Integrals over wavenumbers are differentiated exactly, as the middle of each interval moves and as its half-length grows: their
//! Bessel functions are those of the equations. What is found in space is smooth and takes little: differences serve.
use std::f64::consts::PI;

use faer::Mat;

use crate::contact::integrals::basis::TOGETHER;
use crate::contact::parts::equations::{Equations, System};
use crate::contact::parts::interval::{Motion, Table};
use crate::contact::parts::{ends, with_ends};

/// Differences are taken over this part of the intervals next to an end.
const DIFFERENCE: f64 = 1e-6;

/// What all pressures of a contact do at some wavenumbers, and what changes as its intervals move.
struct Fields<'a> {
    /// By the indices of intervals.
    tables: Vec<(usize, Table<'a>)>,
    tests: Mat<f64>,
    plain: Vec<f64>,
    remainder: Vec<f64>,
    /// For each motion of each interval of the contact: its column, and derivatives of `plain` and `remainder`.
    moved: Vec<(usize, [Vec<f64>; 2])>,
}

impl Fields<'_> {
    /// That of a given pressure.
    fn given(remainder: Vec<f64>) -> Self {
        Self { tables: Vec::new(), tests: Mat::new(), plain: Vec::new(), remainder, moved: Vec::new() }
    }
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
        let all = self.layout.zeta.len();
        for first in (0..all).step_by(TOGETHER) {
            let zeta = &self.layout.zeta[first..all.min(first + TOGETHER)];
            let beyond = self.beyond(zeta);
            let fields = |contact: usize| {
                let count = self.layout.own[contact].reach.saturating_sub(first).min(zeta.len());
                match self.problem.sides[contact].given() {
                    Some(given) => Fields::given(self.given(given, &zeta[..count])),
                    None => self.fields(contact, &zeta[..count], &beyond[..count], pressures),
                }
            };
            let fields: Vec<Fields> = (0..n).map(fields).collect();
            for contact in self.problem.unknown() {
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
                self.add_moved_tests(own, zeta, &seen, &mut sums[contact]);
            }
        }
        sums
    }

    /// What the pressures of a contact do at some wavenumbers.
    fn fields<'a>(&'a self, contact: usize, zeta: &'a [f64], beyond: &'a [f64], pressures: &[f64]) -> Fields<'a> {
        let tables = self.tables(contact, zeta, beyond);
        let (mut plain, mut remainder, mut moved) = (vec![0.0; zeta.len()], vec![0.0; zeta.len()], Vec::new());
        for (index, table) in &tables {
            let own = &pressures[index * self.count..(index + 1) * self.count];
            for (sum, field) in [&mut plain, &mut remainder].into_iter().zip(table.field(own)) {
                sum.iter_mut().zip(field).for_each(|(sum, value)| *sum += value);
            }
            for (k, motion) in Motion::both().into_iter().enumerate() {
                moved.push((2 * index + k, table.moved_field(own, motion)));
            }
        }
        Fields { tests: self.tests(contact, &tables, zeta), tables, plain, remainder, moved }
    }

    /// Adds what changes as the tests of a contact, and the gaps in it, move in what they see.
    fn add_moved_tests(&self, own: &Fields, zeta: &[f64], seen: &[f64], sums: &mut Mat<f64>) {
        let mut at = 0;
        for (index, table) in &own.tables {
            for (k, motion) in Motion::both().into_iter().enumerate() {
                for (row, value) in table.moved_tests(motion, seen).into_iter().enumerate() {
                    sums[(at + row, 2 * index + k)] += value;
                }
            }
            at += self.rows(*index);
            if let Some([from, to]) = self.opening(*index) {
                let sine = |x: f64| zeta.iter().zip(seen).map(|(zeta, seen)| (zeta * x).sin() * seen).sum::<f64>();
                let (from, to) = (sine(from), sine(to));
                let before = [(2 * index - 2, -from), (2 * index - 1, -from)];
                for (column, value) in before.into_iter().chain([(2 * index, to), (2 * index + 1, -to)]) {
                    sums[(at - 1, column)] += value;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use recede_layers::{Exponential, HalfPlane, Homogeneous, Plane};

    use crate::contact::integrals::layout::Layout;
    use crate::contact::parts::equations::Equations;
    use crate::contact::parts::interval::Interval;
    use crate::contact::parts::{Lengths, ends, in_equilibrium, spacings, with_ends};
    use crate::contact::problem::Problem;
    use crate::kernel::Kernel;
    use crate::scene::{Load, Punch, Top};
    use crate::stack::Stack;

    /// Residuals without their scales.
    fn residuals(equations: &Equations, pressures: &[f64]) -> Vec<f64> {
        let system = equations.system();
        system.residuals(pressures).iter().zip(&system.scales).map(|(residual, scale)| residual * scale).collect()
    }

    #[test]
    fn derivatives_are_those_of_the_residuals() {
        let graded = Exponential::new(0.7, 2.0, 0.3, 1.3).unwrap();
        let strip = Homogeneous::new(0.4, 1.0, 0.25).unwrap();
        let stack = Stack::builder(Plane::Strain).layer(strip).receding().layer(graded).receding();
        let stack = stack.layer(HalfPlane::new(0.5, 0.3).unwrap()).build().unwrap();
        let kernel = Kernel::new(&stack).unwrap();
        let cylinder = Top::from(Punch::parabola(10.0).unwrap());
        let load = Top::from(Load::uniform(0.6).unwrap());
        for punch in [&cylinder, &load] {
            let problem = Problem::new(&kernel, &[], punch, 0.02, 1e-10);
            let intervals: Vec<Interval> = [(0, [0.0, 0.8]), (1, [0.0, 0.9]), (1, [1.4, 2.0]), (2, [0.3, 1.7])]
                .into_iter()
                .filter(|(contact, _)| !problem.is_known(*contact))
                .map(|(contact, ends)| Interval::new(contact, ends))
                .collect();
            let count = 5;
            let Lengths { ends: reach, shortest } = Lengths::of(&problem, &intervals);
            let layout = Layout::without_tails(&kernel, &reach, &shortest, 1e-12, 0.0).unwrap();
            let equations =
                Equations { kernel: &kernel, problem: &problem, layout: &layout, intervals: &intervals, count };
            let some = |i: usize| (0..count).map(|m| [1.0, 0.3, -0.2, 0.1, 0.05][(m + i) % count]).collect();
            let pressures = in_equilibrium(&intervals, (0..intervals.len()).map(some).collect()).concat();
            let spacings = spacings(&intervals);
            let system = equations.system();
            let exact = equations.by_ends(&system, &pressures, &spacings).unwrap();
            let at = ends(&intervals);
            for by in 0..at.len() {
                let moved = |step: f64| {
                    let mut moved = at.clone();
                    moved[by] += step * spacings[by];
                    let moved = with_ends(&intervals, &moved).unwrap();
                    residuals(&Equations { intervals: &moved, ..equations }, &pressures)
                };
                let (there, before) = (moved(1e-4), moved(-1e-4));
                for row in 0..there.len() {
                    let expected = (there[row] - before[row]) / 2e-4 / system.scales[row];
                    let found = exact[(row, by)];
                    assert!(
                        (found - expected).abs() < 1e-5 * (1.0 + expected.abs()),
                        "{row}, {by}: {found} {expected}"
                    );
                }
            }
        }
    }
}
