//! Products of columns with weighted columns, the integrals over the wavenumber.
use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};

use crate::contact::integrals::samples::{ColumnRange, Samples};
use crate::contact::integrals::tail::Weights;

/// Rows that are weighted together: so few that they stay in the cache of the processor.
const TOGETHER: usize = 256;

/// leftᵀ · weights · right.
pub(crate) fn product(left: ColumnRange<'_>, weights: &Weights, right: ColumnRange<'_>) -> Samples {
    let (tests, count) = (left.count(), right.count());
    let mut product = Samples::zeros(tests, count);
    let mut weighted = vec![0.0; weights.rows().min(TOGETHER) * count];
    for rows in weights.blocks(TOGETHER) {
        let weighted = &mut weighted[..rows.len() * count];
        for (m, out) in weighted.chunks_exact_mut(rows.len()).enumerate() {
            weights.times(rows.clone(), &right.column(m)[rows.clone()], out);
        }
        let weighted = MatRef::from_column_major_slice(weighted, rows.len(), count);
        let product = MatMut::from_column_major_slice_mut(&mut product.values, tests, count);
        matmul(product, Accum::Add, left.matrix(rows).transpose(), weighted, 1.0, Par::Seq);
    }
    product
}
