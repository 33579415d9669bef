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
use crate::contact::parts::interval::Interval;
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::PER_MODE;
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
    scales: Vec<f64>,
}

/// One equation: its entries and its right-hand side.
struct Equation {
    entries: Vec<f64>,
    right: f64,
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

    /// What pressures leave of other equations, in the same order, scaled as these are.
    pub(super) fn residuals_of(&self, equations: &Equations, pressures: &[f64]) -> Vec<f64> {
        let all = equations.rows_with(Some(pressures)).into_iter().zip(&self.scales);
        all.map(|(equation, scale)| (equation.entries[0] - equation.right) / scale).collect()
    }
}

/// What all pressures do to all tests.
struct Blocks {
    /// For each contact, those of itself and of its neighbours.
    blocks: Vec<Vec<(usize, Mat<f64>)>>,
    /// What a given pressure on top does to the contact below it.
    loads: Vec<f64>,
}

/// What is known of one contact at all wavenumbers: pressures by columns, and tests.
struct Waves {
    transforms: Mat<f64>,
    /// The first transform of each interval less that of a given pressure of the same resultant: only the first have one.
    remainders: Vec<Vec<f64>>,
    tests: Mat<f64>,
}

impl Waves {
    /// The one transform of all pressures together, given these, in place of theirs.
    fn combined(self, pressures: &[f64]) -> Self {
        let sum = |less_resultants: bool| {
            let mut sum = vec![0.0; self.transforms.nrows()];
            for (column, pressure) in pressures.iter().enumerate() {
                let values = self.column(column, less_resultants);
                sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += pressure * value);
            }
            sum
        };
        let (plain, remainder) = (sum(false), sum(true));
        let transforms = Mat::from_fn(plain.len(), 1, |row, _| plain[row]);
        Self { transforms, remainders: vec![remainder], tests: self.tests }
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
    fn contacts(&self) -> usize {
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
        let equations = self.rows_with(None);
        let largest = |row: &[f64]| row.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
        let scales: Vec<f64> = equations.iter().map(|equation| largest(&equation.entries)).collect();
        let size = self.intervals.len() * self.count;
        let entry = |row: usize, column: usize| equations[row].entries[column] / scales[row];
        let matrix = Mat::from_fn(equations.len(), size, entry);
        let right = equations.iter().zip(&scales).map(|(equation, scale)| equation.right / scale).collect();
        System { matrix, right, scales }
    }

    /// Where the pressures of a contact stand among all.
    fn places_of(&self, contact: usize) -> Range<usize> {
        let first = self.of(contact).next().map_or(0, |(index, _)| index * self.count);
        first..first + self.of(contact).count() * self.count
    }

    /// The equations: those that determine pressures at prescribed ends, and then those that determine the ends. With pressures prescribed,
    /// each has one entry, what all of these make of it: that takes as many operations less as there are pressures.
    fn rows_with(&self, pressures: Option<&[f64]>) -> Vec<Equation> {
        let size = if pressures.is_some() { 1 } else { self.intervals.len() * self.count };
        let mut kept: Vec<Equation> = Vec::with_capacity(self.intervals.len() * self.count);
        let mut left: Vec<Equation> = Vec::new();
        let Blocks { blocks, loads } = self.blocks(pressures);
        for (contact, blocks) in blocks.into_iter().enumerate().skip(self.first()) {
            let place = |contact: usize| if pressures.is_some() { 0 } else { self.places_of(contact).start };
            let mut at = 0;
            for (index, interval) in self.of(contact) {
                let rows = self.rows(index);
                for row in 0..rows {
                    let mut entries = vec![0.0; size];
                    for (other, block) in &blocks {
                        for column in 0..block.ncols() {
                            entries[place(*other) + column] += block[(at + row, column)];
                        }
                    }
                    let right = self.load(index, row) + if contact == 1 { loads[at + row] } else { 0.0 };
                    // the second end of a first interval off the middle has no gap to be closed: equilibrium gives the mean
                    // pressure, and the next test what is left over
                    let two_ends = row == 1 && self.is_apart(index);
                    let end = row == 0 || row >= interval.tests(self.count).len() || two_ends;
                    let list = if end { &mut left } else { &mut kept };
                    list.push(Equation { entries, right });
                }
                at += rows;
            }
            // equilibrium
            let mut entries = vec![0.0; size];
            for (index, interval) in self.of(contact) {
                match pressures {
                    Some(pressures) => entries[0] += interval.resultant() * pressures[index * self.count],
                    None => entries[index * self.count] = interval.resultant(),
                }
            }
            kept.push(Equation { entries, right: 1.0 });
        }
        kept.extend(left);
        kept
    }

    /// What all pressures do to all tests, or with pressures given what these do together.
    fn blocks(&self, pressures: Option<&[f64]>) -> Blocks {
        let n = self.contacts();
        let rows = |contact: usize| self.of(contact).map(|(index, _)| self.rows(index)).sum();
        let columns = |contact: usize| if pressures.is_some() { 1 } else { self.places_of(contact).len() };
        let zeros = |contact: usize, other: usize| (other, Mat::zeros(rows(contact), columns(other)));
        let coupled =
            |contact: usize| [Some(contact), contact.checked_sub(1), (contact + 1 < n).then_some(contact + 1)];
        let mut blocks: Vec<Vec<(usize, Mat<f64>)>> = (0..n)
            .map(|contact| coupled(contact).into_iter().flatten().map(|other| zeros(contact, other)).collect())
            .collect();
        let mut loads = vec![0.0; if n > 1 { rows(1) } else { 0 }];
        // no more than two contacts at once, and some wavenumbers: tables take much memory
        for first in (0..self.layout.zeta.len()).step_by(8 * TOGETHER) {
            let mut above: Option<Waves> = None;
            for contact in 0..n {
                let waves = self.waves(contact, first..self.layout.zeta.len().min(first + 8 * TOGETHER));
                let waves = match pressures {
                    Some(pressures) => waves.combined(&pressures[self.places_of(contact)]),
                    None => waves,
                };
                self.add_own(contact, first, &waves, &mut blocks[contact][0].1);
                if contact == 1 && self.first() == 1 {
                    let given = self.given(first, waves.tests.nrows());
                    let tested = self.loaded(0, first, &waves, &given);
                    loads.iter_mut().zip(tested).for_each(|(load, tested)| *load += tested);
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
            let mut block = Mat::zeros(rows(contact), self.places_of(contact).len());
            self.add_half_plane(contact, self.layout.own[contact].limit, &mut block);
            match pressures {
                Some(pressures) => {
                    let own = &pressures[self.places_of(contact)];
                    let own = MatRef::from_column_major_slice(own, own.len(), 1);
                    blocks[0].1 += &block * own;
                }
                None => blocks[0].1 += block,
            }
        }
        Blocks { blocks, loads }
    }

    /// The first contact of which the pressure is unknown.
    fn first(&self) -> usize {
        usize::from(self.problem.top().given().is_some())
    }

    /// The transform of what presses on a contact at some wavenumbers less that of the pressure all are compared with.
    fn given(&self, first: usize, count: usize) -> Vec<f64> {
        let Some(given) = self.problem.top().given() else { return Vec::new() };
        let zeta = &self.layout.zeta[first..first + count];
        zeta.iter().zip(self.beyond(zeta)).map(|(zeta, beyond)| given.transform_minus_one(*zeta) + beyond).collect()
    }

    /// By how much the transform of the pressure that all are compared with, of the resultant 1, is less than 1.
    fn beyond(&self, zeta: &[f64]) -> Vec<f64> {
        // as narrow as the shortest, so that few digits are lost where pressures cancel
        let end = self.intervals.iter().map(Interval::to).fold(f64::INFINITY, f64::min);
        zeta.iter().map(|zeta| -(-0.5 * (zeta * end).powi(2)).exp_m1()).collect()
    }

    /// The laminates next to a contact.
    fn couplings(&self, contact: usize) -> impl Iterator<Item = &Weights> {
        let next = [contact.checked_sub(1), Some(contact)].into_iter().flatten();
        next.filter_map(|coupling| self.layout.coupling.get(coupling))
    }

    /// What is known of a contact at some wavenumbers, as far as it needs them.
    fn waves(&self, contact: usize, nodes: Range<usize>) -> Waves {
        let nodes = nodes.start.min(self.layout.own[contact].reach)..nodes.end.min(self.layout.own[contact].reach);
        let zeta = &self.layout.zeta[nodes.clone()];
        let beyond = self.beyond(zeta);
        let columns = self.of(contact).count() * self.count;
        let rows: usize = self.of(contact).map(|(index, _)| self.rows(index)).sum();
        let mut waves = Waves {
            transforms: Mat::zeros(nodes.len(), columns),
            remainders: Vec::new(),
            tests: Mat::zeros(nodes.len(), rows),
        };
        let (mut column, mut row) = (0, 0);
        for (index, interval) in self.of(contact) {
            let tests = interval.tests(self.count).len();
            let mut remainders = Vec::with_capacity(zeta.len());
            for start in (0..zeta.len()).step_by(TOGETHER) {
                let some = start..zeta.len().min(start + TOGETHER);
                let transforms = waves.transforms.as_mut().submatrix_mut(start, column, some.len(), self.count);
                let tested = waves.tests.as_mut().submatrix_mut(start, row, some.len(), tests);
                remainders.extend(interval.waves(&zeta[some.clone()], &beyond[some], transforms, tested));
            }
            waves.remainders.push(remainders);
            column += self.count;
            row += tests;
            if let Some([from, to]) = self.opening(index) {
                // cos ζb − cos ζl
                let closing = waves.tests.col_as_slice_mut(row);
                for (closing, zeta) in closing.iter_mut().zip(zeta) {
                    *closing = 2.0 * (0.5 * zeta * (to + from)).sin() * (0.5 * zeta * (to - from)).sin() / zeta;
                }
                row += 1;
            }
        }
        waves
    }

    /// Adds what the pressures of a contact do to itself, half-planes left out, by wavenumbers from `first` on.
    fn add_own(&self, contact: usize, first: usize, waves: &Waves, block: &mut Mat<f64>) {
        *block += self.tested(waves, &self.layout.own[contact].unit.plain, first, waves, false);
        for weights in self.couplings(contact) {
            *block += self.tested(waves, &weights.plain, first, waves, true);
        }
    }

    /// What the pressures of another contact take from one.
    fn between(&self, coupling: usize, first: usize, waves: &Waves, other: &Waves) -> Mat<f64> {
        self.tested(waves, &self.layout.coupling[coupling].plain, first, other, true)
    }

    /// What a given pressure gives to a contact through a coupling, by wavenumbers from `first` on.
    fn loaded(&self, coupling: usize, first: usize, waves: &Waves, field: &[f64]) -> Vec<f64> {
        let weights = &self.layout.coupling[coupling].plain;
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
        if interval.contact > 0 {
            return 0.0;
        }
        match (interval.tests(self.count).get(row), self.opening(index)) {
            (Some(test), _) => self
                .places()
                .map(|(theta, weight)| {
                    weight
                        * (*test as f64 * theta).cos()
                        * self.problem.top().slope(interval.middle + interval.half * theta.cos())
                })
                .sum(),
            (None, Some([from, to])) => self.problem.top().height(to) - self.problem.top().height(from),
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
            let field = |waves: &Waves, contact: usize, less_resultants: bool| -> Vec<f64> {
                let all = self.of(contact).flat_map(|(index, _)| coefficients[index].iter().copied());
                let mut sum = vec![0.0; waves.transforms.nrows()];
                for (column, c) in all.enumerate() {
                    let values = waves.column(column, less_resultants);
                    sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += c * value);
                }
                sum
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
            for (coupling, other) in [(contact.checked_sub(1), contact.wrapping_sub(1)), (Some(contact), contact + 1)] {
                if let Some(weights) = coupling.and_then(|coupling| self.layout.coupling.get(coupling)) {
                    let others = if other < self.first() {
                        self.given(first, remainders.len())
                    } else {
                        field(&self.waves(other, nodes.clone()), other, true)
                    };
                    add(&weights.plain, &remainders, 1.0);
                    add(&weights.plain, &others, -1.0);
                }
            }
        }
        response
    }
}
