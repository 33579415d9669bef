//! The contact equations on given intervals, and how far their ends are from right.
//!
//! The slopes that all pressures make of the gap, F_i(x) = (1/π) ∫ (unit p̂_i + ...) sin ζx dζ, are tested on every
//! interval. What the kernels have in common with half-planes, g∞, is integrated in space: on its own interval sin jφ
//! makes g∞ T_j(s), elsewhere g∞ ρ^j with ρ = s ∓ √(s² − 1). Half-lengths that are not right show in the first test of
//! each interval, and in gaps between intervals that do not close.
use std::f64::consts::PI;
use std::ops::Range;

use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef};

use crate::contact::integrals::basis::TOGETHER;
use crate::contact::integrals::layout::Layout;
use crate::contact::integrals::tail::Weights;
use crate::contact::parts::interval::{Interval, Table};
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::PER_MODE;
use crate::contact::problem::load::Given;
use crate::kernel::Kernel;
use crate::numeric::dot;

/// Points of integrals over an interval, besides those of each pressure.
pub(super) const POINTS: usize = 48;

/// The equations of some intervals, in the order of contacts and outwards.
pub(super) struct Equations<'a> {
    pub(super) kernel: &'a Kernel,
    pub(super) problem: &'a Problem<'a>,
    pub(super) layout: &'a Layout,
    pub(super) intervals: &'a [Interval],
    /// Pressures on each interval.
    pub(super) count: usize,
}

/// The equations at given ends, linear in the pressures: one for each pressure and one for each end.
pub(super) struct System {
    pub(super) matrix: Mat<f64>,
    right: Vec<f64>,
    /// The largest entry of each row before it was scaled to 1.
    pub(super) scales: Vec<f64>,
}

impl System {
    /// The pressures that fulfil all equations but those for the ends; `None` if there are none in double precision.
    pub(super) fn pressures(&self) -> Option<Vec<f64>> {
        let size = self.matrix.ncols();
        let right = Mat::from_fn(size, 1, |row, _| self.right[row]);
        let found = self.matrix.subrows(0, size).partial_piv_lu().solve(&right);
        let all = found.col_as_slice(0);
        all.iter().all(|value| value.is_finite()).then(|| all.to_vec())
    }

    /// What pressures leave of the equations.
    pub(super) fn residuals(&self, pressures: &[f64]) -> Vec<f64> {
        let all = Mat::from_fn(pressures.len(), 1, |row, _| pressures[row]);
        let found = &self.matrix * &all;
        self.right.iter().enumerate().map(|(row, right)| found[(row, 0)] - right).collect()
    }
}

/// One of the equations, in a list of those that determine pressures at prescribed ends, and then those that determine the ends.
#[derive(Clone, Copy)]
enum Row {
    /// A test of an interval, or the closing of the gap before it, and its place among those of its contact.
    Test {
        contact: usize,
        index: usize,
        row: usize,
        at: usize,
    },
    Equilibrium {
        contact: usize,
    },
}

/// What all pressures do to all tests.
struct Blocks {
    /// For each contact, those of itself and of its neighbours.
    blocks: Vec<Vec<(usize, Mat<f64>)>>,
    /// What given pressures on neighbours do to each contact.
    loads: Vec<Vec<f64>>,
}

/// What is known of one contact at all wavenumbers: pressures by columns, and tests.
struct Waves {
    transforms: Mat<f64>,
    /// The first transform of each interval less that of a given pressure of the same resultant: only the first have one.
    remainders: Vec<Vec<f64>>,
    tests: Mat<f64>,
}

impl Waves {
    /// The transform of all pressures together, or what that is less their resultant.
    fn field(&self, pressures: &[f64], less_resultants: bool) -> Vec<f64> {
        let mut sum = vec![0.0; self.transforms.nrows()];
        for (column, pressure) in pressures.iter().enumerate() {
            let values = self.column(column, less_resultants);
            sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += pressure * value);
        }
        sum
    }

    /// One column of the transforms, or of what they are less resultants.
    fn column(&self, column: usize, less_resultants: bool) -> &[f64] {
        let count = (self.transforms.ncols() / self.remainders.len().max(1)).max(1);
        if less_resultants && column.is_multiple_of(count) {
            &self.remainders[column / count]
        } else {
            self.transforms.col_as_slice(column)
        }
    }
}

impl Equations<'_> {
    pub(super) fn contacts(&self) -> usize {
        self.kernel.contacts()
    }

    /// The intervals of one contact.
    pub(super) fn of(&self, contact: usize) -> impl Iterator<Item = (usize, &Interval)> {
        self.intervals.iter().enumerate().filter(move |(_, interval)| interval.contact == contact)
    }

    /// The gap that ends where an interval begins.
    pub(super) fn opening(&self, index: usize) -> Option<[f64; 2]> {
        let interval = &self.intervals[index];
        let before = self.intervals.get(index.checked_sub(1)?)?;
        (before.contact == interval.contact).then(|| [before.to(), interval.from()])
    }

    /// Whether an interval is the innermost of its contact and off the middle: there the bodies are apart about x = 0.
    pub(super) fn is_apart(&self, index: usize) -> bool {
        !self.intervals[index].is_central() && self.opening(index).is_none()
    }

    /// Tests of an interval: their orders, and whether a gap is to be closed besides.
    pub(super) fn rows(&self, index: usize) -> usize {
        self.intervals[index].tests(self.count).len() + usize::from(self.opening(index).is_some())
    }

    /// The equations, each scaled to its largest entry.
    pub(super) fn system(&self) -> System {
        let Blocks { blocks, loads } = self.blocks();
        let rows = self.list();
        let size = self.intervals.len() * self.count;
        let mut matrix = Mat::zeros(rows.len(), size);
        let mut right = vec![1.0; rows.len()];
        for (place, row) in rows.into_iter().enumerate() {
            match row {
                Row::Test { contact, index, row, at } => {
                    for (other, block) in &blocks[contact] {
                        let first = self.places_of(*other).start;
                        for column in 0..block.ncols() {
                            matrix[(place, first + column)] += block[(at, column)];
                        }
                    }
                    right[place] = self.load(index, row) + loads[contact][at];
                }
                Row::Equilibrium { contact } => {
                    for (index, interval) in self.of(contact) {
                        matrix[(place, index * self.count)] = interval.resultant();
                    }
                }
            }
        }
        let mut scales = Vec::with_capacity(right.len());
        for (place, right) in right.iter_mut().enumerate() {
            let scale = matrix.row(place).iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
            matrix.row_mut(place).iter_mut().for_each(|entry| *entry /= scale);
            *right /= scale;
            scales.push(scale);
        }
        System { matrix, right, scales }
    }

    /// The equations: those that determine pressures at prescribed ends, and then those that determine the ends.
    fn list(&self) -> Vec<Row> {
        let (mut kept, mut left) = (Vec::new(), Vec::new());
        for contact in self.problem.unknown() {
            let mut at = 0;
            for (index, interval) in self.of(contact) {
                for row in 0..self.rows(index) {
                    // the second end of a first interval off the middle has no gap to be closed: equilibrium gives the mean
                    // pressure, and the next test what is left over
                    let two_ends = row == 1 && self.is_apart(index);
                    let end = row == 0 || row >= interval.tests(self.count).len() || two_ends;
                    let list = if end { &mut left } else { &mut kept };
                    list.push(Row::Test { contact, index, row, at: at + row });
                }
                at += self.rows(index);
            }
            kept.push(Row::Equilibrium { contact });
        }
        kept.extend(left);
        kept
    }

    /// Where the pressures of a contact stand among all.
    pub(super) fn places_of(&self, contact: usize) -> Range<usize> {
        let first = self.of(contact).next().map_or(0, |(index, _)| index * self.count);
        first..first + self.of(contact).count() * self.count
    }

    /// What all pressures do to all tests.
    fn blocks(&self) -> Blocks {
        let n = self.contacts();
        let zeros =
            |contact: usize, other: usize| (other, Mat::zeros(self.rows_of(contact), self.places_of(other).len()));
        let coupled =
            |contact: usize| [Some(contact), contact.checked_sub(1), (contact + 1 < n).then_some(contact + 1)];
        let mut blocks: Vec<Vec<(usize, Mat<f64>)>> = (0..n)
            .map(|contact| coupled(contact).into_iter().flatten().map(|other| zeros(contact, other)).collect())
            .collect();
        let mut loads: Vec<Vec<f64>> = (0..n).map(|contact| vec![0.0; self.rows_of(contact)]).collect();
        // no more than two contacts at once, and some wavenumbers: tables take much memory
        let all = self.layout.zeta.len();
        for first in (0..all).step_by(TOGETHER) {
            let nodes = first..all.min(first + TOGETHER);
            let mut above: Option<Waves> = None;
            for contact in 0..n {
                let waves = self.waves(contact, nodes.clone());
                self.add_own(contact, first, &waves, &mut blocks[contact][0].1);
                for (other, weights) in self.neighbours(contact) {
                    let Some(given) = self.problem.sides[other].given() else { continue };
                    let given = self.given(given, &self.layout.zeta[first..first + waves.tests.nrows()]);
                    let tested = self.loaded(weights, first, &waves, &given);
                    loads[contact].iter_mut().zip(tested).for_each(|(load, tested)| *load += tested);
                }
                if let Some(above) = &above {
                    blocks[contact][1].1 -= self.between(contact - 1, first, &waves, above);
                    if let Some((_, below)) = blocks[contact - 1].last_mut() {
                        *below -= self.between(contact - 1, first, above, &waves);
                    }
                }
                above = Some(waves);
            }
        }
        for (contact, blocks) in blocks.iter_mut().enumerate() {
            self.add_half_plane(contact, self.layout.own[contact].limit, &mut blocks[0].1);
        }
        Blocks { blocks, loads }
    }

    /// Number of the tests of a contact, and of the gaps in it to be closed.
    pub(super) fn rows_of(&self, contact: usize) -> usize {
        self.of(contact).map(|(index, _)| self.rows(index)).sum()
    }

    /// What pressures leave of the equations as far as it is found in space: half-planes, the load, and equilibrium.
    pub(super) fn in_space(&self, pressures: &[f64]) -> Vec<f64> {
        let half_planes: Vec<Mat<f64>> = (0..self.contacts())
            .map(|contact| {
                let own = &pressures[self.places_of(contact)];
                let mut block = Mat::zeros(self.rows_of(contact), own.len());
                self.add_half_plane(contact, self.layout.own[contact].limit, &mut block);
                block * MatRef::from_column_major_slice(own, own.len(), 1)
            })
            .collect();
        let of = |row: Row| match row {
            Row::Test { contact, index, row, at } => half_planes[contact][(at, 0)] - self.load(index, row),
            Row::Equilibrium { contact } => {
                let own = self.of(contact);
                own.map(|(index, interval)| interval.resultant() * pressures[index * self.count]).sum::<f64>() - 1.0
            }
        };
        self.list().into_iter().map(of).collect()
    }

    /// Puts what belongs to the tests of each contact in the order of the equations, each scaled as in the system.
    pub(super) fn in_order(&self, system: &System, of_tests: &[Mat<f64>], others: &Mat<f64>) -> Mat<f64> {
        let mut all = others.clone();
        for (place, row) in self.list().into_iter().enumerate() {
            for column in 0..all.ncols() {
                if let Row::Test { contact, at, .. } = row {
                    all[(place, column)] += of_tests[contact][(at, column)];
                }
                all[(place, column)] /= system.scales[place];
            }
        }
        all
    }

    /// The transform of a given pressure at some wavenumbers less that of the pressure all are compared with.
    pub(super) fn given(&self, given: &Given, zeta: &[f64]) -> Vec<f64> {
        zeta.iter().zip(self.beyond(zeta)).map(|(zeta, beyond)| given.transform_minus_one(*zeta) + beyond).collect()
    }

    /// By how much the transform of the pressure that all are compared with, of the resultant 1, is less than 1.
    pub(super) fn beyond(&self, zeta: &[f64]) -> Vec<f64> {
        // as narrow as the shortest, so that few digits are lost where pressures cancel
        let end = self.intervals.iter().map(Interval::to).fold(f64::INFINITY, f64::min);
        zeta.iter().map(|zeta| -(-0.5 * (zeta * end).powi(2)).exp_m1()).collect()
    }

    /// The neighbours of a contact, with the weights of the laminates between.
    pub(super) fn neighbours(&self, contact: usize) -> impl Iterator<Item = (usize, &Weights)> {
        let next = [contact.checked_sub(1).map(|above| (above, above)), Some((contact + 1, contact))];
        next.into_iter().flatten().filter_map(|(other, coupling)| Some((other, self.layout.coupling.get(coupling)?)))
    }

    /// What is known of a contact at some wavenumbers, as far as it needs them.
    fn waves(&self, contact: usize, nodes: Range<usize>) -> Waves {
        let reach = self.layout.own[contact].reach;
        let zeta = &self.layout.zeta[nodes.start.min(reach)..nodes.end.min(reach)];
        let beyond = self.beyond(zeta);
        let tables = self.tables(contact, zeta, &beyond);
        let mut transforms = Mat::zeros(zeta.len(), tables.len() * self.count);
        for ((_, table), column) in tables.iter().zip((0..).step_by(self.count)) {
            table.transforms(transforms.as_mut().subcols_mut(column, self.count));
        }
        let remainders = tables.iter().map(|(_, table)| table.first_remainder()).collect();
        Waves { transforms, remainders, tests: self.tests(contact, &tables, zeta) }
    }

    /// Bessel functions of the intervals of a contact, with their indices.
    pub(super) fn tables<'a>(&'a self, contact: usize, zeta: &'a [f64], beyond: &'a [f64]) -> Vec<(usize, Table<'a>)> {
        self.of(contact).map(|(index, interval)| (index, Table::new(interval, self.count, zeta, beyond))).collect()
    }

    /// The tests of a contact at some wavenumbers.
    pub(super) fn tests(&self, contact: usize, tables: &[(usize, Table)], zeta: &[f64]) -> Mat<f64> {
        let mut tests = Mat::zeros(zeta.len(), self.rows_of(contact));
        let mut row = 0;
        for (index, table) in tables {
            table.tests(tests.as_mut().subcols_mut(row, self.rows(*index)));
            row += self.rows(*index);
            if let Some([from, to]) = self.opening(*index) {
                // a slope integrated over the gap: cos ζb − cos ζl, over ζ
                for (closing, zeta) in tests.col_as_slice_mut(row - 1).iter_mut().zip(zeta) {
                    *closing = 2.0 * (0.5 * zeta * (to + from)).sin() * (0.5 * zeta * (to - from)).sin() / zeta;
                }
            }
        }
        tests
    }

    /// Adds what the pressures of a contact do to itself, half-planes left out, by wavenumbers from `first` on.
    fn add_own(&self, contact: usize, first: usize, waves: &Waves, block: &mut Mat<f64>) {
        *block += self.tested(waves, &self.layout.own[contact].unit.plain, first, waves, false);
        for (_, weights) in self.neighbours(contact) {
            *block += self.tested(waves, &weights.plain, first, waves, true);
        }
    }

    /// What the pressures of another contact take from one.
    fn between(&self, coupling: usize, first: usize, waves: &Waves, other: &Waves) -> Mat<f64> {
        self.tested(waves, &self.layout.coupling[coupling].plain, first, other, true)
    }

    /// What a given pressure gives to a contact through a coupling, by wavenumbers from `first` on.
    fn loaded(&self, weights: &Weights, first: usize, waves: &Waves, field: &[f64]) -> Vec<f64> {
        let weights = &weights.plain;
        let terms = weights[first.min(weights.len())..].iter().zip(&self.layout.zeta[first..]).zip(field);
        let terms: Vec<f64> = terms.map(|((weight, zeta), value)| weight * zeta / PI * value).collect();
        let tests = (0..waves.tests.ncols()).map(|row| waves.tests.col_as_slice(row));
        tests.map(|test| dot(test, &terms)).collect()
    }

    /// (1/π) Σ tests · ζ weights · fields, by wavenumbers from `first` on.
    fn tested(&self, waves: &Waves, weights: &[f64], first: usize, fields: &Waves, less_resultants: bool) -> Mat<f64> {
        let weights = &weights[first.min(weights.len())..];
        let count = weights.len().min(fields.transforms.nrows()).min(waves.tests.nrows());
        let mut weighted = Mat::zeros(count, fields.transforms.ncols());
        for column in 0..weighted.ncols() {
            let terms = weights.iter().zip(&self.layout.zeta[first..]).zip(fields.column(column, less_resultants));
            for (out, ((weight, zeta), value)) in weighted.col_as_slice_mut(column).iter_mut().zip(terms) {
                *out = weight * zeta / PI * value;
            }
        }
        let tests: MatRef<'_, f64> = waves.tests.as_ref().subrows(0, count);
        tests.transpose() * &weighted
    }

    /// θ and weights of ∫ ... dθ from 0 to π.
    pub(super) fn places(&self) -> impl Iterator<Item = (f64, f64)> {
        let points = POINTS + PER_MODE * self.count;
        (0..points).map(move |q| (PI * (q as f64 + 0.5) / points as f64, PI / points as f64))
    }

    /// The right-hand side of one row.
    fn load(&self, index: usize, row: usize) -> f64 {
        let interval = &self.intervals[index];
        let Some(profile) = self.problem.sides[interval.contact].profile() else { return 0.0 };
        match (interval.tests(self.count).get(row), self.opening(index)) {
            (Some(test), _) => {
                let slope = |theta: f64| profile.slope(interval.middle + interval.half * theta.cos());
                self.places().map(|(theta, weight)| weight * (*test as f64 * theta).cos() * slope(theta)).sum()
            }
            (None, Some([from, to])) => profile.height(to) - profile.height(from),
            (None, None) => 0.0,
        }
    }
}

/// What known pressures do outside the contacts.
impl Equations<'_> {
    /// Slopes of waves, weights included, what half-planes do left out.
    pub(super) fn response(&self, contact: usize, coefficients: &[Vec<f64>]) -> Vec<f64> {
        let mut response = vec![0.0; self.layout.own[contact].reach];
        for first in (0..response.len()).step_by(TOGETHER) {
            let nodes = first..response.len().min(first + TOGETHER);
            let field = |waves: &Waves, contact: usize, less_resultants: bool| {
                let all: Vec<f64> = self.of(contact).flat_map(|(index, _)| coefficients[index].clone()).collect();
                waves.field(&all, less_resultants)
            };
            let part = &mut response[nodes.clone()];
            let zeta = &self.layout.zeta[nodes.clone()];
            let mut add = |weights: &[f64], field: &[f64], sign: f64| {
                let weights = &weights[first.min(weights.len())..];
                for (((response, weight), value), zeta) in part.iter_mut().zip(weights).zip(field).zip(zeta) {
                    *response += sign * weight * zeta / PI * value;
                }
            };
            let waves = self.waves(contact, nodes.clone());
            add(&self.layout.own[contact].unit.plain, &field(&waves, contact, false), 1.0);
            let remainders = field(&waves, contact, true);
            for (other, weights) in self.neighbours(contact) {
                let others = match self.problem.sides[other].given() {
                    Some(given) => self.given(given, &self.layout.zeta[first..first + remainders.len()]),
                    None => field(&self.waves(other, nodes.clone()), other, true),
                };
                add(&weights.plain, &remainders, 1.0);
                add(&weights.plain, &others, -1.0);
            }
        }
        response
    }
}
