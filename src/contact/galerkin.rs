//! The Galerkin equations of all contacts at given half-lengths: rows, columns and how they act.
//!
//! Unknowns are the modes j = 3, 5, ... of every contact (equilibrium fixes j = 1), equations the rows k = 3, 5, ...;
//! the rows k = 1 are left over, one per unknown half-length: the residual of Newton's method. Everything is per unit of
//! P' = P/(μ₀L): p̂_i = P' Σ_j y_ij J_j(ζa_i)/ζ, y_i1 = 2/a_i.
use faer::linalg::matmul::matmul;
use faer::reborrow::ReborrowMut;
use faer::{Accum, Mat, MatMut, MatRef, Par};

use super::basis::{Basis, Table};
use super::layout::Layout;

/// Rows k = 1, 3, ... of the right-hand sides, per unit of P': the punch's slope against the tests of contact 0.
pub(super) struct Slopes {
    /// ± ∫ f'(as) T_k(s)/√(1 − s²) ds.
    pub(super) value: Vec<f64>,
    /// Its derivative with respect to ln a.
    pub(super) slope: Vec<f64>,
}

/// The equations of one stack, one layout and one set of half-lengths.
pub(super) struct Equations<'a> {
    layout: &'a Layout,
    bases: &'a [Basis],
    slopes: &'a Slopes,
    /// Modes solved for, per contact, j = 1 included.
    modes: &'a [usize],
}

/// A function of the wavenumber for one contact: at the real nodes and at the rows of the tail.
pub(super) struct Transform {
    real: Vec<f64>,
    tail: Vec<f64>,
}

impl<'a> Equations<'a> {
    pub(super) fn new(layout: &'a Layout, bases: &'a [Basis], slopes: &'a Slopes, modes: &'a [usize]) -> Self {
        Self { layout, bases, slopes, modes }
    }

    pub(super) fn contacts(&self) -> usize {
        self.bases.len()
    }

    /// Where the unknowns of each contact begin, and how many there are.
    pub(super) fn offsets(&self) -> (Vec<usize>, usize) {
        let mut offsets = Vec::with_capacity(self.contacts());
        let mut total = 0;
        for modes in self.modes {
            offsets.push(total);
            total += modes - 1;
        }
        (offsets, total)
    }

    /// Neighbours of a contact with the coupling's weights.
    fn neighbours(&self, i: usize) -> impl Iterator<Item = (usize, &'a [f64])> {
        let coupling = &self.layout.coupling;
        let above = i.checked_sub(1).map(|m| (m, &coupling[m][..]));
        let below = coupling.get(i).map(|weights| (i + 1, &weights[..]));
        above.into_iter().chain(below)
    }

    /// The matrix of rows and modes from 3 on.
    pub(super) fn matrix(&self) -> Mat<f64> {
        let (offsets, size) = self.offsets();
        let mut matrix = Mat::zeros(size, size);
        for i in 0..self.contacts() {
            let (own, basis, count) = (&self.layout.own[i], &self.bases[i], self.modes[i] - 1);
            if count == 0 {
                continue;
            }
            let mut block = matrix.as_mut().submatrix_mut(offsets[i], offsets[i], count, count);
            add_product(block.rb_mut(), &basis.real, &own.diagonal, &basis.real);
            add_product(block.rb_mut(), &basis.tail, &basis.tail_weights, &basis.tail);
            for m in 0..count {
                block[(m, m)] += own.limit / order(m + 1) * 0.5;
            }
            if let Some(weights) = self.layout.coupling.get(i) {
                let other = self.modes[i + 1] - 1;
                if other > 0 {
                    let mut block = matrix.as_mut().submatrix_mut(offsets[i], offsets[i + 1], count, other);
                    add_product(block.rb_mut(), &basis.real, weights, &self.bases[i + 1].real);
                    let transposed = block.to_owned();
                    matrix
                        .as_mut()
                        .submatrix_mut(offsets[i + 1], offsets[i], other, count)
                        .copy_from(transposed.transpose());
                }
            }
        }
        matrix
    }

    /// The slope transform that the unit pressures (all contacts carry P', mode 1 only) make at contact i: equal
    /// pressures first, then what the neighbours' unit pressures differ from the own one.
    pub(super) fn unit_slopes(&self, i: usize) -> Transform {
        let (own, basis) = (&self.layout.own[i], &self.bases[i]);
        let amplitude = 2.0 / basis.half_length;
        let mut real = vec![0.0; own.reach];
        scaled_product(&mut real, amplitude, &own.unit, basis.real.value(0));
        for (other, weights) in self.neighbours(i) {
            let other = &self.bases[other];
            for (node, weight) in weights.iter().enumerate() {
                real[node] += weight * self.layout.zeta[node] * (other.deficit[node] - basis.deficit[node]);
            }
        }
        let mut tail = vec![0.0; basis.tail.rows()];
        if !tail.is_empty() {
            scaled_product(&mut tail, amplitude, &basis.tail_weights, basis.tail.value(0));
        }
        Transform { real, tail }
    }

    /// Derivative of [`Self::unit_slopes`] of contact i with respect to ln a of contact `by`.
    pub(super) fn unit_slopes_change(&self, i: usize, by: usize) -> Transform {
        let (own, basis) = (&self.layout.own[i], &self.bases[i]);
        let mut real = vec![0.0; own.reach];
        let mut tail = vec![0.0; basis.tail.rows()];
        if by == i {
            let amplitude = 2.0 / basis.half_length;
            scaled_product(&mut real, amplitude, &own.unit, basis.real.slope(0));
            scaled_product(&mut real, -amplitude, &own.unit, basis.real.value(0));
            if !tail.is_empty() {
                scaled_product(&mut tail, amplitude, &basis.tail_weights, basis.tail.slope(0));
                scaled_product(&mut tail, -amplitude, &basis.tail_weights, basis.tail.value(0));
            }
        }
        for (other, weights) in self.neighbours(i) {
            if by != i && by != other {
                continue;
            }
            let change = &self.bases[by].deficit_slope;
            let sign = if by == i { -1.0 } else { 1.0 };
            for (node, weight) in weights.iter().enumerate() {
                real[node] += sign * weight * self.layout.zeta[node] * change[node];
            }
        }
        Transform { real, tail }
    }

    /// Σ_j y_ij (J_j or its derivative) of contact i over a range of modes.
    pub(super) fn transform(&self, i: usize, coefficients: &[f64], first: usize, slope: bool) -> Transform {
        let basis = &self.bases[i];
        let sum = |table: &Table| {
            let mut sum = vec![0.0; table.rows()];
            for (m, c) in coefficients.iter().enumerate() {
                let column = if slope { table.slope(first + m) } else { table.value(first + m) };
                for (sum, value) in sum.iter_mut().zip(column) {
                    *sum += c * value;
                }
            }
            sum
        };
        Transform { real: sum(&basis.real), tail: sum(&basis.tail) }
    }

    /// Adds to `slopes` of contact i what pressures with the transform `pressure` of contact `by` cause there (g∞ left
    /// out).
    pub(super) fn add_response(&self, slopes: &mut Transform, i: usize, by: usize, pressure: &Transform) {
        if by == i {
            scaled_product(&mut slopes.real, 1.0, &self.layout.own[i].diagonal, &pressure.real);
            scaled_product(&mut slopes.tail, 1.0, &self.bases[i].tail_weights, &pressure.tail);
        }
        for (other, weights) in self.neighbours(i) {
            if by == other {
                scaled_product(&mut slopes.real, 1.0, weights, &pressure.real);
            }
        }
    }

    /// Tests a slope transform of contact i with the row of mode `m`.
    pub(super) fn test(&self, i: usize, slopes: &Transform, m: usize) -> f64 {
        let basis = &self.bases[i];
        dot(&slopes.real, basis.real.value(m)) + dot(&slopes.tail, basis.tail.value(m))
    }

    pub(super) fn test_slope(&self, i: usize, slopes: &Transform, m: usize) -> f64 {
        let basis = &self.bases[i];
        dot(&slopes.real, basis.real.slope(m)) + dot(&slopes.tail, basis.tail.slope(m))
    }

    /// The slope transforms of all contacts at the real wavenumbers, weights included and g∞ left out, for given modes.
    pub(super) fn slope_transforms(&self, modes: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let n = self.contacts();
        let mut slopes: Vec<Transform> = (0..n).map(|i| self.unit_slopes(i)).collect();
        for (by, modes) in modes.iter().enumerate() {
            let pressure = self.transform(by, &modes[1..], 1, false);
            for (i, slopes) in slopes.iter_mut().enumerate() {
                self.add_response(slopes, i, by, &pressure);
            }
        }
        slopes.into_iter().map(|slopes| slopes.real).collect()
    }

    /// A transform of contact i that is zero.
    pub(super) fn nothing(&self, i: usize) -> Transform {
        Transform { real: vec![0.0; self.layout.own[i].reach], tail: vec![0.0; self.bases[i].tail.rows()] }
    }

    /// Modes solved for, j = 1 included.
    pub(super) fn modes(&self, i: usize) -> usize {
        self.modes[i]
    }

    /// Half-length of a contact in units of L.
    pub(super) fn half_length(&self, i: usize) -> f64 {
        self.bases[i].half_length
    }

    /// g∞ of a contact.
    pub(super) fn limit(&self, i: usize) -> f64 {
        self.layout.own[i].limit
    }

    /// The punch's part of a row.
    pub(super) fn punch(&self, i: usize, m: usize) -> f64 {
        if i == 0 { self.slopes.value.get(m).copied().unwrap_or(0.0) } else { 0.0 }
    }

    pub(super) fn punch_slope(&self, i: usize, m: usize) -> f64 {
        if i == 0 { self.slopes.slope.get(m).copied().unwrap_or(0.0) } else { 0.0 }
    }
}

/// (−1)^m, the sign of the test functions and modes of order 2m + 1.
pub(super) fn alternating(m: usize) -> f64 {
    if m.is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// Order j of mode m.
pub(super) fn order(m: usize) -> f64 {
    (2 * m + 1) as f64
}

/// block += leftᵀ diag(weights) right, modes from 3 on, over the rows that have weights.
fn add_product(block: MatMut<'_, f64>, left: &Table, weights: &[f64], right: &Table) {
    let rows = weights.len();
    if rows == 0 {
        return;
    }
    let (m, n) = (block.nrows(), block.ncols());
    let mut weighted = Mat::<f64>::zeros(rows, n);
    for c in 0..n {
        let column = &right.value(c + 1)[..rows];
        for (r, (weight, value)) in weights.iter().zip(column).enumerate() {
            weighted[(r, c)] = weight * value;
        }
    }
    let left = left.modes_from_three(m);
    matmul(block, Accum::Add, left.submatrix(0, 0, rows, m).transpose(), weighted.as_ref(), 1.0, Par::Seq);
}

impl Table {
    /// The basis functions of modes 1 ..= `count` as a matrix of nodes by modes.
    fn modes_from_three(&self, count: usize) -> MatRef<'_, f64> {
        MatRef::from_column_major_slice(&self.columns()[self.rows()..(count + 1) * self.rows()], self.rows(), count)
    }
}

/// sum += factor · weights · values, over as many nodes as there are weights.
fn scaled_product(sum: &mut [f64], factor: f64, weights: &[f64], values: &[f64]) {
    for ((sum, weight), value) in sum.iter_mut().zip(weights).zip(values) {
        *sum += factor * weight * value;
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
