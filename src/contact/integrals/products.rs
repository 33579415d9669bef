//! Products of columns with weighted columns, the integrals over the wavenumber.
use std::ops::Range;

use faer::linalg::matmul::matmul;
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::reborrow::ReborrowMut;
use faer::{Accum, MatMut, Par};

use crate::contact::integrals::columns::{Columns, Part};
use crate::contact::integrals::tail::Weights;

/// Columns of a small block: what half of a product of such saves is less than what it takes.
const SMALL: usize = 24;
/// Weighted columns of more entries are made some at a time.
const MANY: usize = 1 << 18;

/// Some columns of a square matrix as a block of it, from a row on.
fn block(matrix: &mut Columns, columns: Range<usize>, row: usize) -> MatMut<'_, f64> {
    let (rows, count) = (matrix.rows(), columns.len());
    let values = &mut matrix.values[columns.start * rows..columns.end * rows];
    MatMut::from_column_major_slice_mut(values, rows, count).subrows_mut(row, rows - row)
}

/// Weights times some columns, over the rows that they cover.
fn weighted(weights: &Weights, columns: Part<'_>) -> Columns {
    let mut weighted = Columns::new(weights.rows(), columns.count());
    for m in 0..columns.count() {
        weights.times(columns.column(m), weighted.column_mut(m));
    }
    weighted
}

/// Ranges of columns that are weighted together.
fn ranges(rows: usize, columns: usize) -> impl Iterator<Item = Range<usize>> {
    let together = (MANY / rows.max(1)).next_multiple_of(SMALL);
    (0..columns).step_by(together).map(move |first| first..columns.min(first + together))
}

/// leftᵀ · weights · right.
pub(crate) fn product(left: Part<'_>, weights: &Weights, right: Part<'_>) -> Columns {
    let mut product = Columns::new(left.count(), right.count());
    let rows = left.matrix(weights.rows()).transpose();
    for range in ranges(weights.rows(), right.count()) {
        let right = weighted(weights, right.part(range.clone()));
        let right = right.part(0..range.len()).matrix(weights.rows());
        matmul(block(&mut product, range, 0), Accum::Replace, rows, right, 1.0, Par::Seq);
    }
    product
}

/// columnsᵀ · weights · columns, its lower half at least.
pub(crate) fn symmetric_product(columns: Part<'_>, weights: &Weights) -> Columns {
    let count = columns.count();
    if count <= SMALL {
        return product(columns, weights, columns);
    }
    let mut product = Columns::new(count, count);
    for range in ranges(weights.rows(), count) {
        let right = weighted(weights, columns.part(range.clone()));
        let (first, width) = (range.start, range.len());
        let right = right.part(0..width).matrix(weights.rows());
        let rows = columns.part(first..count).matrix(weights.rows()).transpose();
        let mut out = block(&mut product, range, first);
        triangular::matmul(
            out.rb_mut().subrows_mut(0, width),
            BlockStructure::TriangularLower,
            Accum::Replace,
            rows.subrows(0, width),
            BlockStructure::Rectangular,
            right,
            BlockStructure::Rectangular,
            1.0,
            Par::Seq,
        );
        let below = rows.nrows() - width;
        matmul(out.subrows_mut(width, below), Accum::Replace, rows.subrows(width, below), right, 1.0, Par::Seq);
    }
    product
}
