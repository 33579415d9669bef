//! Columns of numbers, one value for each wavenumber: sums of columns, and sums over the wavenumbers.
use std::ops::Range;
use std::sync::Arc;

use faer::MatRef;

use crate::numeric::vector::{LANES, vectorised};
use crate::numeric::workspace::Workspace;

/// Columns taken together.
const TOGETHER: usize = 4;

/// Columns of samples at wavenumbers, one after the other.
pub(crate) struct Samples {
    rows: usize,
    count: usize,
    pub(crate) values: Vec<f64>,
    /// The columns that are zero, from left to right: nothing is multiplied by these.
    zero: Vec<Range<usize>>,
    /// Where the storage goes afterwards.
    workspace: Option<Arc<Workspace>>,
}

impl Drop for Samples {
    fn drop(&mut self) {
        if let Some(workspace) = &self.workspace {
            workspace.keep(std::mem::take(&mut self.values));
        }
    }
}

impl Samples {
    /// Columns to be overwritten, in storage of a workspace.
    pub(crate) fn new(rows: usize, columns: usize, workspace: &Arc<Workspace>) -> Self {
        let (values, workspace) = (workspace.take(rows * columns), Some(workspace.clone()));
        Self { rows, count: columns, values, zero: Vec::new(), workspace }
    }

    /// Columns of zeros.
    pub(crate) fn zeros(rows: usize, columns: usize) -> Self {
        Self { rows, count: columns, values: vec![0.0; rows * columns], zero: Vec::new(), workspace: None }
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.count
    }

    pub(crate) fn rows(&self) -> usize {
        self.rows
    }

    pub(crate) fn column(&self, m: usize) -> &[f64] {
        &self.values[m * self.rows..(m + 1) * self.rows]
    }

    pub(crate) fn column_mut(&mut self, m: usize) -> &mut [f64] {
        &mut self.values[m * self.rows..(m + 1) * self.rows]
    }

    /// Two of them, one to be changed by the other.
    pub(crate) fn two_mut(&mut self, one: usize, other: usize) -> [&mut [f64]; 2] {
        let (before, after) = self.values.split_at_mut(one.max(other) * self.rows);
        let least = &mut before[one.min(other) * self.rows..][..self.rows];
        let most = &mut after[..self.rows];
        if one < other { [least, most] } else { [most, least] }
    }

    /// Makes some columns zero that stand behind all others that are.
    pub(crate) fn clear(&mut self, columns: Range<usize>) {
        if !columns.is_empty() {
            self.values[columns.start * self.rows..columns.end * self.rows].fill(0.0);
            self.zero.push(columns);
        }
    }

    /// The columns that are zero in other samples become zero here.
    pub(crate) fn clear_like(mut self, other: &Self) -> Self {
        other.zero.iter().for_each(|columns| self.clear(columns.clone()));
        self
    }

    /// The columns that are zero here and in other samples.
    pub(crate) fn both_zero<'a>(&'a self, other: &'a Self) -> impl Iterator<Item = Range<usize>> {
        let common = |a: &Range<usize>, b: &Range<usize>| a.start.max(b.start)..a.end.min(b.end);
        self.zero.iter().flat_map(move |own| other.zero.iter().map(move |there| common(own, there)))
    }

    /// The columns between the ones that are zero.
    pub(crate) fn filled(&self) -> impl Iterator<Item = Range<usize>> + Clone {
        let from = std::iter::once(0).chain(self.zero.iter().map(|columns| columns.end));
        let to = self.zero.iter().map(|columns| columns.start).chain([self.count]);
        from.zip(to).map(|(from, to)| from..to).filter(|columns| !columns.is_empty())
    }

    /// Σ factor · column over the first columns, as many as there are factors.
    pub(crate) fn combine(&self, factors: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; self.rows];
        for columns in self.filled() {
            let columns = columns.start.min(factors.len())..columns.end.min(factors.len());
            self.part(columns.clone()).add_combined(&factors[columns], &mut sum);
        }
        sum
    }

    /// Σ over the rows of each column times `rows`, which may be fewer than the columns have.
    pub(crate) fn test(&self, rows: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.count];
        self.filled().for_each(|columns| self.part(columns.clone()).add_tested(1.0, rows, &mut sums[columns]));
        sums
    }

    /// Some of them.
    pub(crate) fn part(&self, columns: Range<usize>) -> ColumnRange<'_> {
        let values = &self.values[columns.start * self.rows..columns.end * self.rows];
        ColumnRange { rows: self.rows, count: columns.len(), values }
    }
}

/// Some of the columns of a table.
#[derive(Clone, Copy)]
pub(crate) struct ColumnRange<'a> {
    rows: usize,
    count: usize,
    values: &'a [f64],
}

impl<'a> ColumnRange<'a> {
    pub(crate) fn count(self) -> usize {
        self.count
    }

    pub(crate) fn column(self, m: usize) -> &'a [f64] {
        &self.values[m * self.rows..(m + 1) * self.rows]
    }

    /// As a matrix of some rows.
    pub(crate) fn matrix(self, rows: Range<usize>) -> MatRef<'a, f64> {
        MatRef::from_column_major_slice_with_stride(self.values, self.rows, self.count, self.rows)
            .subrows(rows.start, rows.len())
    }

    /// Adds Σ factor · column.
    pub(crate) fn add_combined(self, factors: &[f64], sum: &mut [f64]) {
        if self.rows == 0 {
            return;
        }
        vectorised(
            #[inline(always)]
            || {
                let together = self.values.chunks_exact(TOGETHER * self.rows);
                let rest = together.remainder().chunks_exact(self.rows);
                for (columns, factors) in together.zip(factors.chunks_exact(TOGETHER)) {
                    let (a, b) = columns.split_at(2 * self.rows);
                    let ((a, b), (c, d)) = (a.split_at(self.rows), b.split_at(self.rows));
                    for ((((sum, a), b), c), d) in sum.iter_mut().zip(a).zip(b).zip(c).zip(d) {
                        *sum += (factors[0] * a + factors[1] * b) + (factors[2] * c + factors[3] * d);
                    }
                }
                for (column, factor) in rest.zip(factors.chunks_exact(TOGETHER).remainder()) {
                    sum.iter_mut().zip(column).for_each(|(sum, value)| *sum += factor * value);
                }
            },
        );
    }

    /// Adds factor · Σ over the rows of each column times `rows`.
    pub(crate) fn add_tested(self, factor: f64, rows: &[f64], sums: &mut [f64]) {
        vectorised(
            #[inline(always)]
            || {
                for (block, sums) in sums.chunks_mut(TOGETHER).enumerate() {
                    // the last columns may be taken twice
                    let column = |k: usize| self.column(block * TOGETHER + k.min(sums.len() - 1));
                    let columns = [column(0), column(1), column(2), column(3)].map(|column| &column[..rows.len()]);
                    let found = products(columns, rows);
                    sums.iter_mut().zip(found).for_each(|(sum, found)| *sum += factor * found);
                }
            },
        );
    }
}

/// Sums of the products of four columns with a fifth.
#[inline(always)]
fn products([a, b, c, d]: [&[f64]; TOGETHER], rows: &[f64]) -> [f64; TOGETHER] {
    let [mut sum_a, mut sum_b, mut sum_c, mut sum_d] = [[0.0; LANES]; TOGETHER];
    let (row, rest) = rows.as_chunks::<LANES>();
    let columns = a.as_chunks::<LANES>().0.iter().zip(b.as_chunks::<LANES>().0);
    let more = c.as_chunks::<LANES>().0.iter().zip(d.as_chunks::<LANES>().0);
    for ((row, (a, b)), (c, d)) in row.iter().zip(columns).zip(more) {
        add_products(&mut sum_a, a, row);
        add_products(&mut sum_b, b, row);
        add_products(&mut sum_c, c, row);
        add_products(&mut sum_d, d, row);
    }
    let whole = rows.len() - rest.len();
    let mut totals = [0.0; TOGETHER];
    for (total, (sums, column)) in totals.iter_mut().zip([(sum_a, a), (sum_b, b), (sum_c, c), (sum_d, d)]) {
        *total = sums.iter().sum();
        for (value, row) in column[whole..].iter().zip(rest) {
            *total += value * row;
        }
    }
    totals
}

#[inline(always)]
fn add_products(sums: &mut [f64; LANES], column: &[f64; LANES], row: &[f64; LANES]) {
    for lane in 0..LANES {
        sums[lane] += column[lane] * row[lane];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_those_of_single_columns() {
        for (rows, count) in [(0, 3), (1, 1), (7, 5), (16, 4), (37, 11)] {
            let mut columns = Samples::zeros(rows, count);
            columns.values.iter_mut().enumerate().for_each(|(k, value)| *value = (k as f64).sin());
            if count > 5 {
                columns.clear(1..2);
                columns.clear(3..5);
            }
            let factors: Vec<f64> = (0..count).map(|m| (3.0 + m as f64).cos()).collect();
            let sum = columns.combine(&factors);
            for (row, sum) in sum.iter().enumerate() {
                let expected: f64 = (0..count).map(|m| factors[m] * columns.column(m)[row]).sum();
                assert!((sum - expected).abs() < 1e-14);
            }
            let rows = &sum[..rows - rows / 3];
            for (m, tested) in columns.test(rows).iter().enumerate() {
                let expected: f64 = columns.column(m).iter().zip(rows).map(|(value, row)| value * row).sum();
                assert!((tested - expected).abs() < 1e-13);
            }
        }
    }
}
