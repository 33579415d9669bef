//! Columns at wavenumbers, and what resultants, moments and rotations do to long waves.
use faer::linalg::matmul::triangular::BlockStructure;
use faer::linalg::matmul::{matmul, triangular};
use faer::{Accum, Mat, MatRef, Par};

use crate::contact::intervals::columns::{Columns, Other, Subtracted};
use crate::contact::intervals::support::{ContactInterval, Parity};
use crate::contact::problem::modes::alternating;
use crate::numeric::bessel;

/// Wavenumbers of which columns are made at once: no number depends on it, but storage of many more has to be fetched from the system.
pub(super) const AT_ONCE: usize = 192;

/// What resultants, moments and rotations do to long waves, with the places of the columns or tests that these belong to.
pub(super) struct Long {
    pub(super) places: Vec<usize>,
    pub(super) values: Mat<f64>,
}

impl Columns<'_> {
    /// All columns at some wavenumbers: terms, singular pressures at ends, other tests; what resultants, moments and rotations do to long waves left out.
    pub(super) fn waves(&self, zeta: &[f64]) -> Mat<f64> {
        let (terms, ends, nodes) = (self.terms(), self.ends(), zeta.len());
        let others = self.others();
        let mut all = Mat::zeros(self.parts() * nodes, terms + ends + others.len());
        for number in 0..self.intervals.len() {
            self.add_waves(&mut all, number, zeta);
        }
        for (place, other) in (terms + ends..).zip(&others) {
            if let Other::Closing(number) = *other {
                let [from, to] = self.gap(number);
                let ([resultant, moment], rotation) = (self.carried_by(*other), self.rotation(*other));
                for (k, wave) in zeta.iter().enumerate() {
                    let [sum, difference] =
                        [to + from, to - from].map(|length| bessel::sinc_minus_one(0.5 * wave * length));
                    all[(k, place)] = resultant * wave * less_one(sum, difference);
                    if self.moves() {
                        let cos = cosine_minus_one(0.5 * wave * (to + from));
                        all[(nodes + k, place)] = -rotation * less_one(cos, difference) - moment * wave * wave;
                    }
                }
            }
        }
        for Subtracted { into, from, part } in self.subtracted() {
            (0..all.nrows()).for_each(|k| all[(k, into)] -= part * all[(k, from)]);
        }
        all
    }

    /// Adds the columns of one interval as they are.
    fn add_waves(&self, all: &mut Mat<f64>, number: usize, zeta: &[f64]) {
        let interval = &self.intervals[number];
        let ContactInterval { middle, half, .. } = *interval;
        let (nodes, count, first) = (zeta.len(), self.counts[number], self.first(number));
        let orders = (interval.order(count - 1) + 1).max(4);
        let arguments: Vec<f64> = zeta.iter().map(|zeta| zeta * half).collect();
        let mut table = vec![0.0; orders * nodes];
        bessel::table(orders, &arguments, &mut table);
        let j = |order: usize| &table[order * nodes..(order + 1) * nodes];
        let phases: Vec<(f64, f64)> = zeta.iter().map(|zeta| (zeta * middle).sin_cos()).collect();
        for m in 0..count {
            let order = interval.order(m);
            let factor = 2.0 * alternating(order / 2) / half;
            let column = all.col_as_slice_mut(first + m);
            for ((k, j), (sin, cos)) in j(order).iter().enumerate().zip(&phases) {
                let [real, imaginary] = if order.is_multiple_of(2) { [*sin, -cos] } else { [*cos, *sin] };
                column[k] = factor * j * real;
                if interval.parity == Parity::None {
                    column[nodes + k] = factor * j * imaginary;
                }
            }
        }
        let end = self.terms() + self.end(number);
        let mean = self.place(Other::Mean(number));
        for (k, wave) in zeta.iter().enumerate() {
            let (sin, phase) = (phases[k].0, wave * middle);
            let jinc = bessel::jinc_minus_one_from(arguments[k], j(1)[k]);
            let (zeroth, cos) = (jinc - j(2)[k], cosine_minus_one(phase));
            all[(k, first)] = wave * less_one(jinc, cos);
            for (place, side) in interval.sides().iter().enumerate() {
                all[(k, end + place)] = if interval.is_even() {
                    2.0 * wave * zeroth
                } else {
                    wave * (less_one(zeroth, cos) - side * j(1)[k] * sin)
                };
            }
            if interval.parity == Parity::Pair
                && let Some(mean) = mean
            {
                all[(k, mean)] = 2.0 * middle / half * wave * less_one(zeroth, bessel::sinc_minus_one(phase));
            }
            if interval.parity != Parity::None {
                continue;
            }
            // sin z − z of long waves
            let odd = phase * bessel::sinc_minus_one(phase);
            let second = jinc + if arguments[k] > 0.0 { 2.0 * j(3)[k] / arguments[k] } else { 0.0 };
            let row = nodes + k;
            all[(row, first)] = wave * (odd + sin * jinc);
            all[(row, first + 1)] = 0.25 * half * wave * wave * less_one(second, cos);
            for (place, side) in interval.sides().iter().enumerate() {
                let own = 0.5 * arguments[k] * jinc + j(1)[k] * cos;
                all[(row, end + place)] = wave * (odd + sin * zeroth + side * own);
            }
            if let Some(mean) = mean {
                let [_, moment] = self.carried_by(Other::Mean(number));
                all[(k, mean)] = 2.0 / half * (odd + sin * zeroth);
                all[(row, mean)] = -2.0 / half * less_one(zeroth, cos) - moment * wave * wave;
            }
        }
    }

    /// What [`Self::waves`] leaves out, with the columns it belongs to: resultants and moments of the first ones, and rotations of the tests that tell
    /// them.
    pub(super) fn long_waves(&self, zeta: &[f64]) -> Long {
        let carried = self.carried();
        let of = |resultant: f64, moment: f64, rotation: f64| -> Vec<f64> {
            let odd = zeta.iter().filter(|_| self.moves()).map(|wave| moment * wave * wave - rotation);
            zeta.iter().map(|wave| resultant * wave).chain(odd).collect()
        };
        let mut all = Vec::new();
        for first in self.groups().into_iter().map(|group| self.first(group.start)) {
            all.push((first, of(1.0, carried[first][1], 0.0)));
            if self.moves() {
                all.push((first + 1, of(0.0, carried[first + 1][1], 0.0)));
            }
        }
        for (place, other) in (carried.len()..).zip(self.others()) {
            if self.tells_rotation_of(other).is_some() {
                let [resultant, moment] = self.carried_by(other);
                all.push((place, of(resultant, moment, self.rotation(other))));
            }
        }
        let values = Mat::from_fn(self.parts() * zeta.len(), all.len(), |k, column| all[column].1[k]);
        Long { places: all.into_iter().map(|(place, _)| place).collect(), values }
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

/// The sum of the first columns with these amplitudes.
pub(super) fn combined(columns: &Mat<f64>, amplitudes: &[f64]) -> Vec<f64> {
    let mut sum = vec![0.0; columns.nrows()];
    for (column, amplitude) in amplitudes.iter().enumerate().filter(|(_, amplitude)| **amplitude != 0.0) {
        sum.iter_mut().zip(columns.col_as_slice(column)).for_each(|(sum, value)| *sum += amplitude * value);
    }
    sum
}

/// Columns of two neighbours at the first wavenumbers: what the first ones are more than the others, and behind these the others.
pub(super) fn differences(one: &Mat<f64>, other: &Mat<f64>, count: usize, parts: usize) -> Mat<f64> {
    let columns = one.ncols();
    let [of_one, of_other] = [one, other].map(|columns| columns.nrows() / parts);
    let mut all = Mat::zeros(parts * count, 2 * columns);
    for column in 0..columns {
        let [one, other] = [one, other].map(|columns| columns.col_as_slice(column));
        for part in 0..parts {
            let [one, other] = [&one[part * of_one..], &other[part * of_other..]].map(|values| &values[..count]);
            let rows = part * count..(part + 1) * count;
            let difference = all.col_as_slice_mut(column)[rows.clone()].iter_mut();
            difference.zip(one.iter().zip(other)).for_each(|(into, (one, other))| *into = one - other);
            all.col_as_slice_mut(columns + column)[rows].copy_from_slice(other);
        }
    }
    all
}

/// Columns times weights, over as many wavenumbers as there are weights and values.
pub(super) struct Weighted {
    values: Mat<f64>,
    parts: usize,
}

impl Weighted {
    pub(super) fn new(columns: &Mat<f64>, weights: &[f64], parts: usize) -> Self {
        let own = columns.nrows() / parts;
        let count = weights.len().min(own);
        let mut values = Mat::zeros(parts * count, columns.ncols());
        for column in 0..columns.ncols() {
            for (part, into) in values.col_as_slice_mut(column).chunks_mut(count.max(1)).enumerate() {
                let values = &columns.col_as_slice(column)[part * own..];
                into.iter_mut()
                    .zip(values.iter().zip(weights))
                    .for_each(|(into, (value, weight))| *into = value * weight);
            }
        }
        Self { values, parts }
    }

    /// Adds products leftᵀ · columns, of real parts and of imaginary ones.
    fn sums(&self, left: &Mat<f64>, mut add: impl FnMut(MatRef<f64>, MatRef<f64>)) {
        let [own, other] = [left, &self.values].map(|columns| columns.nrows() / self.parts);
        let count = own.min(other);
        for part in 0..self.parts {
            let left = left.as_ref().subrows(part * own, count);
            add(left.transpose(), self.values.as_ref().subrows(part * other, count));
        }
    }

    /// leftᵀ · weights · columns.
    pub(super) fn tested(&self, left: &Mat<f64>) -> Mat<f64> {
        let mut product = Mat::zeros(left.ncols(), self.values.ncols());
        self.sums(left, |left, right| matmul(product.as_mut(), Accum::Add, left, right, 1.0, Par::Seq));
        product
    }

    /// The same with the columns themselves on the left.
    pub(super) fn symmetric(&self, columns: &Mat<f64>) -> Mat<f64> {
        let size = columns.ncols();
        let mut product = Mat::zeros(size, size);
        let (lower, all) = (BlockStructure::TriangularLower, BlockStructure::Rectangular);
        self.sums(columns, |left, right| {
            triangular::matmul(product.as_mut(), lower, Accum::Add, left, all, right, all, 1.0, Par::Seq);
        });
        for column in 0..size {
            for row in column + 1..size {
                product[(column, row)] = product[(row, column)];
            }
        }
        product
    }
}

impl Long {
    /// The tests as they are: what [`Columns::waves`] has of them and what it leaves out, added before anything is summed, since both cancel for short waves.
    pub(super) fn whole(&self, waves: &Mat<f64>) -> Self {
        let mut whole = self.values.clone();
        for (number, place) in self.places.iter().enumerate() {
            let waves = waves.col_as_slice(*place);
            whole.col_as_slice_mut(number).iter_mut().zip(waves).for_each(|(value, wave)| *value += wave);
        }
        Self { places: self.places.clone(), values: whole }
    }

    /// Puts these tests into their rows of a product with columns.
    pub(super) fn put_rows(&self, product: &mut Mat<f64>, columns: &Weighted) {
        let rows = columns.tested(&self.values);
        for (number, place) in self.places.iter().enumerate() {
            (0..rows.ncols()).for_each(|column| product[(*place, column)] = rows[(number, column)]);
        }
    }

    /// Adds what is left out of the columns of a contact to a product of them with its tests, of which some are given as they are.
    pub(super) fn add_columns(
        &self,
        product: &mut Mat<f64>,
        tests: &Self,
        weights: &[f64],
        left: &Mat<f64>,
        parts: usize,
    ) {
        let own = Weighted::new(&self.values, weights, parts);
        let mut columns = own.tested(left);
        tests.put_rows(&mut columns, &own);
        for (number, place) in self.places.iter().enumerate() {
            let column = product.col_as_slice_mut(*place).iter_mut();
            column.zip(columns.col_as_slice(number)).for_each(|(sum, value)| *sum += value);
        }
    }
}
