//! Products of columns with weighted columns, the integrals over the wavenumber.
use std::ops::Range;

use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};

use crate::contact::integrals::samples::{ColumnRange, Samples};
use crate::contact::integrals::tail::Weights;

/// A matrix to be written.
fn written(matrix: &mut Samples, columns: usize) -> MatMut<'_, f64> {
    let rows = matrix.rows();
    MatMut::from_column_major_slice_mut(&mut matrix.values, rows, columns)
}

/// Rows that are weighted together: so few that they stay in the cache of the processor.
const TOGETHER: usize = 256;

/// leftᵀ · weights · right.
pub(crate) fn product(left: ColumnRange<'_>, weights: &Weights, right: ColumnRange<'_>) -> Samples {
    let mut product = Samples::zeros(left.count(), right.count());
    let count = right.count();
    for_weighted(weights, right, |rows, right| {
        let left = left.matrix(rows.clone()).transpose();
        matmul(written(&mut product, count), Accum::Add, left, right, 1.0, Par::Seq);
    });
    product
}

/// Weights times some columns, over the rows that they cover: some rows after the other.
fn for_weighted(weights: &Weights, columns: ColumnRange<'_>, mut add: impl FnMut(Range<usize>, MatRef<'_, f64>)) {
    let mut weighted = vec![0.0; weights.rows().min(TOGETHER) * columns.count()];
    for rows in weights.blocks(TOGETHER) {
        let weighted = &mut weighted[..rows.len() * columns.count()];
        for (m, out) in weighted.chunks_exact_mut(rows.len()).enumerate() {
            weights.times(rows.clone(), &columns.column(m)[rows.clone()], out);
        }
        let matrix = MatRef::from_column_major_slice(weighted, rows.len(), columns.count());
        add(rows, matrix);
    }
}
