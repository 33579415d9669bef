//! Columns at wavenumbers, and what resultants, moments and rotations do to long waves.
use std::ops::Range;
use std::sync::Arc;

use faer::linalg::matmul::triangular::BlockStructure;
use faer::linalg::matmul::{matmul, triangular};
use faer::{Accum, Mat, Par};

use crate::contact::integrals::samples::Samples;
use crate::contact::intervals::columns::{Columns, Other, Subtracted};
use crate::contact::intervals::support::{ContactInterval, Parity};
use crate::numeric::workspace::Workspace;
use crate::numeric::{bessel, largest, trigonometry};

/// Wavenumbers of which columns are made at once: no number depends on it, but storage of many more has to be fetched from the system.
pub(super) const AT_ONCE: usize = 96;

/// What resultants, moments and rotations do to long waves, with the places of the columns or tests that these belong to.
pub(super) struct Long {
    pub(super) places: Vec<usize>,
    pub(super) values: Samples,
}

impl Columns<'_> {
    /// All columns at some wavenumbers: terms, singular pressures at ends, other tests; what resultants, moments and rotations do to long waves left out.
    pub(super) fn waves(&self, zeta: &[f64], workspace: &Arc<Workspace>) -> Samples {
        let (terms, ends, nodes) = (self.terms(), self.ends(), zeta.len());
        let others = &self.others;
        let mut all = Samples::new(self.parts() * nodes, terms + ends + others.len(), workspace);
        for number in 0..self.intervals.len() {
            self.put_waves(&mut all, number, zeta, workspace);
        }
        for (place, other) in (terms + ends..).zip(others) {
            if let Other::Closing(number) = *other {
                let [from, to] = self.gap(number);
                let ([resultant, moment], rotation) = (self.carried_by(*other), self.rotation(*other));
                let column = all.column_mut(place);
                for (k, wave) in zeta.iter().enumerate() {
                    let [sum, difference] =
                        [to + from, to - from].map(|length| bessel::sinc_minus_one(0.5 * wave * length));
                    column[k] = resultant * wave * less_one(sum, difference);
                    if self.moves() {
                        let cos = cosine_minus_one(0.5 * wave * (to + from));
                        column[nodes + k] = -rotation * less_one(cos, difference) - moment * wave * wave;
                    }
                }
            }
        }
        for Subtracted { into, from, part } in &self.subtracted {
            let [into, from] = all.two_mut(*into, *from);
            into.iter_mut().zip(from).for_each(|(into, from)| *into -= part * *from);
        }
        all
    }

    /// The columns and tests of one interval as they are.
    fn put_waves(&self, all: &mut Samples, number: usize, zeta: &[f64], workspace: &Arc<Workspace>) {
        let interval = &self.intervals[number];
        let ContactInterval { middle, half, .. } = *interval;
        let (nodes, count, first, twin) = (zeta.len(), self.counts[number], self.first(number), interval.twin);
        let arguments: Vec<f64> = zeta.iter().map(|zeta| zeta * half).collect();
        // all of them: no number depends on where a block of wavenumbers ends
        let orders = (interval.order(count - 1) + 1).max(4);
        let wanted = interval.wanted();
        let mut table = Samples::new(nodes, wanted.below(orders), workspace);
        bessel::scaled_orders(orders, wanted, &arguments, 1.0, nodes, &mut table.values);
        let [sines, cosines, minus_one] =
            trigonometry::waves(&zeta.iter().map(|zeta| zeta * middle).collect::<Vec<_>>());
        let enough = bessel::orders_up_to(largest(arguments.iter().copied()));
        self.put_terms(all, (number, enough), &table, [&sines, &cosines]);
        let end = self.terms() + self.end(number);
        let mean = self.place(Other::Mean(number));
        let [j1, j3] = [1, 3].map(|order| table.column(interval.among_wanted(order)));
        for (k, wave) in zeta.iter().enumerate() {
            let (sin, phase) = (sines[k], wave * middle);
            let jinc = twin.jinc_minus_one(arguments[k], j1[k]);
            let j2 = 0.5 * arguments[k] * (j1[k] + j3[k]) / (2.0 + twin.shift);
            let (zeroth, cos) = (jinc - j2, minus_one[k]);
            let mut put = |column: usize, row: usize, value: f64| all.column_mut(column)[row] = value;
            if interval.is_odd() {
                // gaps that close have no resultants that matter to long waves
                let images = if interval.is_even() { 2.0 } else { 1.0 };
                for (place, side) in (end..).zip(interval.sides()) {
                    put(place, k, wave * (sin * (1.0 + zeroth) + images * side * j1[k] * cosines[k]));
                }
                mean.into_iter().for_each(|mean| put(mean, k, -2.0 / half * (1.0 + zeroth) * cosines[k]));
                continue;
            }
            put(first, k, wave * less_one(jinc, cos));
            for (place, side) in (end..).zip(interval.sides()) {
                let value = if interval.is_even() { 2.0 * zeroth } else { less_one(zeroth, cos) - side * j1[k] * sin };
                put(place, k, wave * value);
            }
            if interval.parity == Parity::Pair
                && let Some(mean) = mean
            {
                put(mean, k, 2.0 * middle / half * wave * less_one(zeroth, bessel::sinc_minus_one(phase)));
            }
            if interval.parity != Parity::None {
                continue;
            }
            // sin z − z, of long waves by its series
            let odd = if phase.abs() > 1.0 { sin - phase } else { phase * bessel::sinc_minus_one(phase) };
            let second = jinc + if arguments[k] > 0.0 { 2.0 * j3[k] / arguments[k] } else { 0.0 };
            let row = nodes + k;
            put(first, row, wave * (odd + sin * jinc));
            put(first + 1, row, 0.25 * half * wave * wave * less_one(second, cos));
            for (place, side) in (end..).zip(interval.sides()) {
                let own = 0.5 * arguments[k] * jinc + j1[k] * cos;
                put(place, row, wave * (odd + sin * zeroth + side * own));
            }
            if let Some(mean) = mean {
                let [_, moment] = self.carried_by(Other::Mean(number));
                put(mean, k, 2.0 / half * (odd + sin * zeroth));
                put(mean, row, -2.0 / half * less_one(zeroth, cos) - moment * wave * wave);
            }
        }
    }

    /// The terms of one interval whose orders count, for long waves have no part of short terms, from a table of Bessel functions and the sines and cosines of ζ middle.
    fn put_terms(
        &self,
        all: &mut Samples,
        (number, enough): (usize, usize),
        table: &Samples,
        [sines, cosines]: [&Vec<f64>; 2],
    ) {
        let (interval, first, count) = (&self.intervals[number], self.first(number), self.counts[number]);
        let filled = (0..count).take_while(|m| interval.order(*m) < enough).count();
        all.clear(first + filled..first + count);
        for m in 0..filled {
            let order = interval.order(m);
            let values = table.column(interval.among_wanted(order));
            let factor = interval.transform(m);
            let column = all.column_mut(first + m);
            if interval.is_even() {
                let factor = if interval.opens { -factor } else { factor };
                column.iter_mut().zip(values).for_each(|(into, j)| *into = factor * j);
                continue;
            }
            let parts = column.chunks_mut(table.rows().max(1));
            // cos ζm and sin ζm, or sin ζm and −cos ζm
            let phases = match order.is_multiple_of(2) {
                true => [(sines, factor), (cosines, -factor)],
                false => [(cosines, factor), (sines, factor)],
            };
            for (into, (phases, factor)) in parts.zip(&phases[usize::from(interval.is_odd())..]) {
                let waves = values.iter().zip(*phases);
                into.iter_mut().zip(waves).for_each(|(into, (j, phase))| *into = factor * j * phase);
            }
        }
    }

    /// What [`Self::waves`] leaves out, with the columns it belongs to: resultants and moments of the first ones, and rotations of the tests that tell
    /// them.
    pub(super) fn long_waves(&self, zeta: &[f64], workspace: &Arc<Workspace>) -> Long {
        let (carried, others, places) = (&self.carried, &self.others, self.told());
        let mut values = Samples::new(self.parts() * zeta.len(), places.len(), workspace);
        for (number, place) in places.iter().enumerate() {
            let ([resultant, moment], rotation) = match place.checked_sub(carried.len()) {
                None => (carried[*place], 0.0),
                Some(other) => (self.carried_by(others[other]), self.rotation(others[other])),
            };
            let (even, odd) = values.column_mut(number).split_at_mut(zeta.len());
            even.iter_mut().zip(zeta).for_each(|(into, wave)| *into = resultant * wave);
            odd.iter_mut().zip(zeta).for_each(|(into, wave)| *into = moment * wave * wave - rotation);
        }
        Long { places, values }
    }

    /// The columns and tests that tell resultants, moments and rotations: none where nothing is done to long waves.
    pub(super) fn told(&self) -> Vec<usize> {
        if self.are_odd() {
            return Vec::new();
        }
        let first = self.groups.iter().map(|group| self.first(group.start));
        let first = first.flat_map(|first| first..=first + usize::from(self.moves()));
        let carried = self.terms() + self.ends();
        let others = self.others.iter().enumerate();
        let others = others.filter(|(_, other)| self.tells_rotation_of(**other).is_some());
        first.chain(others.map(|(number, _)| carried + number)).collect()
    }
}

/// cos z − 1.
fn cosine_minus_one(z: f64) -> f64 {
    let sine = (0.5 * z).sin();
    -2.0 * sine * sine
}

/// (1 + a)(1 + b) − 1.
fn less_one(a: f64, b: f64) -> f64 {
    a + b + a * b
}

/// Columns of two neighbours at the first wavenumbers: what the first ones are more than the others, and behind these the others.
pub(super) fn differences(
    one: &Samples,
    other: &Samples,
    count: usize,
    parts: usize,
    workspace: &Arc<Workspace>,
) -> Samples {
    let columns = one.count();
    let [of_one, of_other] = [one, other].map(|columns| columns.rows() / parts);
    let mut all = Samples::new(parts * count, 2 * columns, workspace);
    for first in [0, columns] {
        one.both_zero(other).for_each(|zero| all.clear(first + zero.start..first + zero.end));
    }
    let filled: Vec<usize> = all.filled().flatten().take_while(|column| *column < columns).collect();
    for column in filled {
        let [one, other] = [one, other].map(|columns| columns.column(column));
        for part in 0..parts {
            let [one, other] = [&one[part * of_one..], &other[part * of_other..]].map(|values| &values[..count]);
            let rows = part * count..(part + 1) * count;
            let difference = all.column_mut(column)[rows.clone()].iter_mut();
            difference.zip(one.iter().zip(other)).for_each(|(into, (one, other))| *into = one - other);
            all.column_mut(columns + column)[rows].copy_from_slice(other);
        }
    }
    all
}

/// Columns times weights, over as many wavenumbers as there are weights and values.
pub(super) struct Weighted {
    values: Samples,
    parts: usize,
}

impl Weighted {
    pub(super) fn new(columns: &Samples, weights: &[f64], parts: usize, workspace: &Arc<Workspace>) -> Self {
        let own = columns.rows() / parts;
        let count = weights.len().min(own);
        let mut values = Samples::new(parts * count, columns.count(), workspace).clear_like(columns);
        for column in columns.filled().flatten() {
            for (part, into) in values.column_mut(column).chunks_mut(count.max(1)).enumerate() {
                let values = columns.column(column)[part * own..].iter().zip(weights);
                into.iter_mut().zip(values).for_each(|(into, (value, weight))| *into = value * weight);
            }
        }
        Self { values, parts }
    }

    /// The rows of real parts, and of imaginary ones, of other columns and of these.
    fn rows(&self, left: &Samples) -> impl Iterator<Item = [Range<usize>; 2]> {
        let [own, other] = [left, &self.values].map(|columns| columns.rows() / self.parts);
        let count = own.min(other);
        (0..self.parts).map(move |part| [own, other].map(|rows| part * rows..part * rows + count))
    }

    /// Adds leftᵀ · weights · columns.
    pub(super) fn add_tested(&self, left: &Samples, product: &mut Mat<f64>) {
        for [rows, own] in self.rows(left) {
            for tests in left.filled() {
                let left = left.part(tests.clone()).matrix(rows.clone()).transpose();
                for columns in self.values.filled() {
                    let right = self.values.part(columns.clone()).matrix(own.clone());
                    let into = product.get_mut(tests.clone(), columns);
                    matmul(into, Accum::Add, left, right, 1.0, Par::Seq);
                }
            }
        }
    }

    /// Adds the lower half of the same.
    pub(super) fn add_symmetric(&self, columns: &Samples, product: &mut Mat<f64>) {
        let (lower, all) = (BlockStructure::TriangularLower, BlockStructure::Rectangular);
        for [rows, own] in self.rows(columns) {
            for tests in columns.filled() {
                let left = columns.part(tests.clone()).matrix(rows.clone()).transpose();
                for pressing in columns.filled().take_while(|pressing| pressing.start <= tests.start) {
                    let right = self.values.part(pressing.clone()).matrix(own.clone());
                    let half = if pressing == tests { lower } else { all };
                    let into = product.get_mut(tests.clone(), pressing);
                    triangular::matmul(into, half, Accum::Add, left, all, right, all, 1.0, Par::Seq);
                }
            }
        }
    }

    /// Adds others to columns at these places.
    pub(super) fn add(&mut self, others: &Self, places: &[usize]) {
        for (number, place) in places.iter().enumerate() {
            let pairs = self.values.column_mut(*place).iter_mut().zip(others.values.column(number));
            pairs.for_each(|(sum, value)| *sum += value);
        }
    }

    /// The columns at these places.
    pub(super) fn part(&self, places: &[usize]) -> Self {
        let mut values = Samples::zeros(self.values.rows(), places.len());
        for (number, place) in places.iter().enumerate() {
            values.column_mut(number).copy_from_slice(self.values.column(*place));
        }
        Self { values, parts: self.parts }
    }
}

impl Long {
    /// Of a given pressure with a unit resultant, and a moment if there is another part.
    pub(super) fn of_given(moment: f64, zeta: &[f64], parts: usize, workspace: &Arc<Workspace>) -> Self {
        let mut values = Samples::new(parts * zeta.len(), 1, workspace);
        let (even, odd) = values.column_mut(0).split_at_mut(zeta.len());
        even.copy_from_slice(zeta);
        odd.iter_mut().zip(zeta).for_each(|(into, wave)| *into = moment * wave * wave);
        Self { places: vec![0], values }
    }

    /// Waves less what these do, with some amplitudes, and with it.
    pub(super) fn added_to(&self, less: &[f64], amplitudes: &[f64]) -> Vec<f64> {
        let mut all = less.to_vec();
        let told = self.places.iter().enumerate().filter(|(_, place)| **place < amplitudes.len());
        for (number, place) in told {
            let column = all.iter_mut().zip(self.values.column(number));
            column.for_each(|(sum, value)| *sum += amplitudes[*place] * value);
        }
        all
    }

    /// The tests as they are: what [`Columns::waves`] has of them and what it leaves out, added before anything is summed, since both cancel for short waves.
    pub(super) fn whole(&self, waves: &Samples, workspace: &Arc<Workspace>) -> Samples {
        let mut whole = Samples::new(self.values.rows(), self.places.len(), workspace);
        for (number, place) in self.places.iter().enumerate() {
            let both = self.values.column(number).iter().zip(waves.column(*place));
            whole.column_mut(number).iter_mut().zip(both).for_each(|(sum, (value, wave))| *sum = value + wave);
        }
        whole
    }
}
