//! Products of columns with weighted columns, the integrals over the wavenumber.
use std::ops::Range;

use faer::linalg::matmul::matmul;
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::reborrow::ReborrowMut;
use faer::{Accum, MatMut, MatRef, Par};

use crate::numeric::buffer::Buffer;

use super::super::tail::Weights;

/// Modes of a small block.
const SMALL: usize = 24;
/// Weighted columns of more entries are made some at a time.
const MANY: usize = 1 << 18;

/// Columns of a matrix, one after the other.
pub(super) struct Columns {
    pub(super) rows: usize,
    values: Buffer,
}

impl Columns {
    pub(super) fn new(rows: usize, columns: usize) -> Self {
        Self { rows, values: Buffer::any(rows * columns) }
    }

    pub(super) fn column(&self, m: usize) -> &[f64] {
        &self.values[m * self.rows..(m + 1) * self.rows]
    }

    pub(super) fn column_mut(&mut self, m: usize) -> &mut [f64] {
        &mut self.values[m * self.rows..(m + 1) * self.rows]
    }

    /// Some columns, from a row on.
    fn part(&mut self, columns: Range<usize>, row: usize) -> MatMut<'_, f64> {
        let (rows, count) = (self.rows, columns.len());
        let values = &mut self.values[columns.start * rows..columns.end * rows];
        MatMut::from_column_major_slice_mut(values, rows, count).subrows_mut(row, rows - row)
    }

    pub(super) fn first(&self, columns: usize) -> MatRef<'_, f64> {
        MatRef::from_column_major_slice(&self.values[..columns * self.rows], self.rows, columns)
    }
}

/// Weights times some columns, over the rows that they cover.
fn weighted<'b>(weights: &Weights, columns: Range<usize>, column: impl Fn(usize) -> &'b [f64]) -> Columns {
    let mut weighted = Columns::new(weights.rows(), columns.len());
    for (k, m) in columns.enumerate() {
        weights.times(column(m), weighted.column_mut(k));
    }
    weighted
}

/// Ranges of columns that are weighted together.
fn ranges(rows: usize, columns: usize) -> impl Iterator<Item = Range<usize>> {
    let together = (MANY / rows.max(1)).next_multiple_of(SMALL);
    (0..columns).step_by(together).map(move |first| first..columns.min(first + together))
}

/// leftᵀ · weights · columns.
pub(super) fn product<'b>(
    left: MatRef<'_, f64>,
    weights: &Weights,
    columns: usize,
    column: impl Fn(usize) -> &'b [f64],
) -> Columns {
    let mut product = Columns::new(left.ncols(), columns);
    for range in ranges(left.nrows(), columns) {
        let right = weighted(weights, range.clone(), &column);
        let (out, right) = (product.part(range.clone(), 0), right.first(range.len()));
        matmul(out, Accum::Replace, left.transpose(), right, 1.0, Par::Seq);
    }
    product
}

/// leftᵀ · weights · left, of which `column` tells the columns; its lower half at least.
pub(super) fn symmetric_product<'b>(
    left: MatRef<'_, f64>,
    weights: &Weights,
    column: impl Fn(usize) -> &'b [f64],
) -> Columns {
    let columns = left.ncols();
    // what half of a small product saves is less than what it takes
    if columns <= SMALL {
        return product(left, weights, columns, column);
    }
    let mut product = Columns::new(columns, columns);
    for range in ranges(left.nrows(), columns) {
        let right = weighted(weights, range.clone(), &column);
        let (first, count) = (range.start, range.len());
        let rows = left.subcols(first, columns - first).transpose();
        let mut out = product.part(range, first);
        let right = right.first(count);
        triangular::matmul(
            out.rb_mut().subrows_mut(0, count),
            BlockStructure::TriangularLower,
            Accum::Replace,
            rows.subrows(0, count),
            BlockStructure::Rectangular,
            right,
            BlockStructure::Rectangular,
            1.0,
            Par::Seq,
        );
        let below = rows.nrows() - count;
        matmul(out.subrows_mut(count, below), Accum::Replace, rows.subrows(count, below), right, 1.0, Par::Seq);
    }
    product
}
