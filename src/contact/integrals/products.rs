//! Products of columns with weighted columns, the integrals over the wavenumber.
use faer::linalg::matmul::matmul;
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::{Accum, MatMut, Par};

use crate::contact::integrals::columns::{ColumnRange, Columns};
use crate::contact::integrals::tail::Weights;

/// A matrix to be written.
fn written(matrix: &mut Columns, columns: usize) -> MatMut<'_, f64> {
    let rows = matrix.rows();
    MatMut::from_column_major_slice_mut(&mut matrix.values, rows, columns)
}

/// Weights times some columns, over the rows that they cover.
fn weighted(weights: &Weights, columns: ColumnRange<'_>) -> Columns {
    let mut weighted = Columns::new(weights.rows(), columns.count());
    for m in 0..columns.count() {
        weights.times(columns.column(m), weighted.column_mut(m));
    }
    weighted
}

/// leftᵀ · weights · right.
pub(crate) fn product(left: ColumnRange<'_>, weights: &Weights, right: ColumnRange<'_>) -> Columns {
    let (count, rows) = (right.count(), left.matrix(weights.rows()).transpose());
    let mut product = Columns::new(left.count(), count);
    let right = weighted(weights, right);
    let right = right.part(0..count).matrix(weights.rows());
    matmul(written(&mut product, count), Accum::Replace, rows, right, 1.0, Par::Seq);
    product
}

/// columnsᵀ · weights · columns, its lower half at least.
pub(crate) fn symmetric_product(columns: ColumnRange<'_>, weights: &Weights) -> Columns {
    let count = columns.count();
    let mut product = Columns::new(count, count);
    let right = weighted(weights, columns);
    triangular::matmul(
        written(&mut product, count),
        BlockStructure::TriangularLower,
        Accum::Replace,
        columns.matrix(weights.rows()).transpose(),
        BlockStructure::Rectangular,
        right.part(0..count).matrix(weights.rows()),
        BlockStructure::Rectangular,
        1.0,
        Par::Seq,
    );
    product
}
