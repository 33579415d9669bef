//! The Galerkin equations of all contacts at given half-lengths.
//!
//! Unknowns are the modes j = 3, 5, ... of every contact (theory: equilibrium fixes j = 1), equations the rows
//! k = 3, 5, ...; the rows k = 1 are left over, one per unknown half-length: the residual of Newton's method.
//! Everything is per unit of P' = P/(μ₀L): p̂_i = P' Σ_j y_ij J_j(ζa_i)/ζ, y_i1 = 2/a_i.
use faer::linalg::matmul::matmul;
use faer::linalg::solvers::{Llt, PartialPivLu, Solve};
use faer::reborrow::ReborrowMut;
use faer::{Accum, Mat, MatMut, MatRef, Par, Side};

use super::basis::{Basis, Table};
use super::layout::Layout;

/// How often the iterated modes are computed: each time they feel what the last round added.
const SWEEPS: usize = 3;

/// Rows k = 1, 3, ... of the right-hand sides, per unit of P': the punch's slope against the tests of contact 0.
pub(super) struct Slopes {
    /// ± ∫ f'(as) T_k(s)/√(1 − s²) ds.
    pub(super) value: Vec<f64>,
    /// Its derivative with respect to ln a.
    pub(super) slope: Vec<f64>,
}

/// Solved equations: pressures at given half-lengths, and how far these are from equilibrium.
pub(super) struct Galerkin {
    /// y_ij of contact i, j = 1, 3, ...; those beyond the modes solved for are iterated ones.
    pub(super) modes: Vec<Vec<f64>>,
    /// What is left of the rows k = 1.
    pub(super) residual: Vec<f64>,
    /// Its derivative with respect to the logarithms of the half-lengths.
    pub(super) jacobian: Mat<f64>,
    /// d y_ij / d ln a_m: `sensitivity[m][i][j]`.
    pub(super) sensitivity: Vec<Vec<Vec<f64>>>,
    /// By how much modes beyond those solved for change the residual; already contained in `residual`.
    pub(super) correction: Vec<f64>,
}

/// The matrix of the rows and modes from 3 on, factorised. Symmetric and positive definite up to quadrature.
enum Factor {
    Cholesky(Llt<f64>),
    Lu(PartialPivLu<f64>),
}

impl Factor {
    fn new(matrix: &Mat<f64>) -> Self {
        match matrix.llt(Side::Lower) {
            Ok(cholesky) => Self::Cholesky(cholesky),
            Err(_) => Self::Lu(matrix.partial_piv_lu()),
        }
    }

    fn solve(&self, right: &Mat<f64>) -> Mat<f64> {
        match self {
            Self::Cholesky(factor) => factor.solve(right),
            Self::Lu(factor) => factor.solve(right),
        }
    }
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
struct Transform {
    real: Vec<f64>,
    tail: Vec<f64>,
}

impl<'a> Equations<'a> {
    pub(super) fn new(layout: &'a Layout, bases: &'a [Basis], slopes: &'a Slopes, modes: &'a [usize]) -> Self {
        Self { layout, bases, slopes, modes }
    }

    fn contacts(&self) -> usize {
        self.bases.len()
    }

    /// Where the unknowns of each contact begin, and how many there are.
    fn offsets(&self) -> (Vec<usize>, usize) {
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
    fn matrix(&self) -> Mat<f64> {
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
    fn unit_slopes(&self, i: usize) -> Transform {
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
    fn unit_slopes_change(&self, i: usize, by: usize) -> Transform {
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
    fn transform(&self, i: usize, coefficients: &[f64], first: usize, slope: bool) -> Transform {
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
    fn add_response(&self, slopes: &mut Transform, i: usize, by: usize, pressure: &Transform) {
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
    fn test(&self, i: usize, slopes: &Transform, m: usize) -> f64 {
        let basis = &self.bases[i];
        dot(&slopes.real, basis.real.value(m)) + dot(&slopes.tail, basis.tail.value(m))
    }

    fn test_slope(&self, i: usize, slopes: &Transform, m: usize) -> f64 {
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

    /// The punch's part of a row.
    fn punch(&self, i: usize, m: usize) -> f64 {
        if i == 0 { self.slopes.value.get(m).copied().unwrap_or(0.0) } else { 0.0 }
    }

    fn punch_slope(&self, i: usize, m: usize) -> f64 {
        if i == 0 { self.slopes.slope.get(m).copied().unwrap_or(0.0) } else { 0.0 }
    }

    /// Splits the rows of a solution column by contact.
    fn split(&self, column: &Mat<f64>, c: usize) -> Vec<Vec<f64>> {
        let (offsets, _) = self.offsets();
        (0..self.contacts())
            .map(|i| (0..self.modes[i] - 1).map(|m| column[(offsets[i] + m, c)]).collect())
            .collect()
    }

    /// Solves for the modes, with `iterated` modes in all for each contact: those beyond the solved ones follow row by
    /// row (iterated Galerkin, Sloan 1976), since the dominant part of each row is its own diagonal g∞/(2k), and act
    /// back on the solved ones.
    pub(super) fn solve(&self, iterated: &[usize]) -> Galerkin {
        let n = self.contacts();
        let (offsets, size) = self.offsets();
        let factor = Factor::new(&self.matrix());
        let unit: Vec<Transform> = (0..n).map(|i| self.unit_slopes(i)).collect();
        let rows = |test: &dyn Fn(usize, usize) -> f64| -> Mat<f64> {
            let mut right = Mat::zeros(size, 1);
            for i in 0..n {
                for m in 1..self.modes[i] {
                    right[(offsets[i] + m - 1, 0)] = test(i, m);
                }
            }
            right
        };
        let solution = factor.solve(&rows(&|i, m| self.punch(i, m) - self.test(i, &unit[i], m)));
        let mut higher = self.split(&solution, 0);

        // slopes of the solved modes, and iterated modes
        let mut slopes = unit;
        let add = |slopes: &mut [Transform], coefficients: &[Vec<f64>], first: &dyn Fn(usize) -> usize| {
            for (by, coefficients) in coefficients.iter().enumerate() {
                let pressure = self.transform(by, coefficients, first(by), false);
                for i in by.saturating_sub(1)..(by + 2).min(n) {
                    self.add_response(&mut slopes[i], i, by, &pressure);
                }
            }
        };
        add(&mut slopes, &higher, &|_| 1);
        let residual_of = |slopes: &[Transform]| -> Vec<f64> {
            (0..n)
                .map(|i| {
                    self.test(i, &slopes[i], 0) + self.layout.own[i].limit / self.bases[i].half_length
                        - self.punch(i, 0)
                })
                .collect()
        };
        let plain = residual_of(&slopes);
        let nothing = || -> Vec<Transform> {
            (0..n)
                .map(|i| Transform {
                    real: vec![0.0; self.layout.own[i].reach],
                    tail: vec![0.0; self.bases[i].tail.rows()],
                })
                .collect()
        };
        let mut beyond: Vec<Vec<f64>> = (0..n).map(|i| vec![0.0; iterated[i].saturating_sub(self.modes[i])]).collect();
        let sweeps = if beyond.iter().all(Vec::is_empty) { 0 } else { SWEEPS };
        for _ in 0..sweeps {
            let mut news: Vec<Vec<f64>> = Vec::with_capacity(n);
            for i in 0..n {
                let row = |(k, old): (usize, &mut f64)| -> f64 {
                    let m = self.modes[i] + k;
                    let new = (self.punch(i, m) - self.test(i, &slopes[i], m)) * 2.0 * order(m)
                        / self.layout.own[i].limit;
                    let news = new - *old;
                    *old = new;
                    news
                };
                news.push(beyond[i].iter_mut().enumerate().map(row).collect());
            }
            let mut extra = nothing();
            add(&mut extra, &news, &|i| self.modes[i]);
            let change = self.split(&factor.solve(&rows(&|i, m| -self.test(i, &extra[i], m))), 0);
            add(&mut slopes, &news, &|i| self.modes[i]);
            add(&mut slopes, &change, &|_| 1);
            for (modes, change) in higher.iter_mut().zip(&change) {
                for (y, dy) in modes.iter_mut().zip(change) {
                    *y += dy;
                }
            }
        }
        let residual = residual_of(&slopes);
        let correction = residual.iter().zip(&plain).map(|(full, plain)| full - plain).collect();

        // derivatives with respect to ln a of each contact in turn
        let mut jacobian = Mat::zeros(n, n);
        let mut sensitivity = Vec::with_capacity(n);
        for by in 0..n {
            let near = by.saturating_sub(1)..(by + 2).min(n);
            let pressure = self.transform(by, &higher[by], 1, true);
            let mut change: Vec<Transform> = Vec::with_capacity(n);
            for i in 0..n {
                let mut slopes = self.unit_slopes_change(i, by);
                if near.contains(&i) {
                    self.add_response(&mut slopes, i, by, &pressure);
                }
                change.push(slopes);
            }
            let row = |i: usize, m: usize| -> f64 {
                let mut row = if near.contains(&i) { self.test(i, &change[i], m) } else { 0.0 };
                if i == by {
                    row += self.test_slope(i, &slopes[i], m) - self.punch_slope(i, m);
                }
                row
            };
            let response = self.split(&factor.solve(&rows(&|i, m| -row(i, m))), 0);
            let mut moved = nothing();
            add(&mut moved, &response, &|_| 1);
            for i in 0..n {
                jacobian[(i, by)] = row(i, 0) + self.test(i, &moved[i], 0);
                if i == by {
                    jacobian[(i, by)] -= self.layout.own[i].limit / self.bases[i].half_length;
                }
            }
            sensitivity.push(
                response
                    .into_iter()
                    .enumerate()
                    .map(|(i, response)| {
                        let first = if i == by { -2.0 / self.bases[i].half_length } else { 0.0 };
                        std::iter::once(first).chain(response).collect()
                    })
                    .collect(),
            );
        }
        let modes = (0..n)
            .map(|i| {
                let first = 2.0 / self.bases[i].half_length;
                std::iter::once(first).chain(higher[i].iter().copied()).chain(beyond[i].iter().copied()).collect()
            })
            .collect();
        Galerkin { modes, residual, jacobian, sensitivity, correction }
    }
}

/// Order j of mode m.
fn order(m: usize) -> f64 {
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
