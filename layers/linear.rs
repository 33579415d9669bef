//! The one small linear solve that layers and block systems need.
use nalgebra::SMatrix;

/// Solves A X = B after bringing every row and column of A to size one, so that pivots are chosen by what matters and
/// not by units: a long wave stretches a layer with forces of order λh and bends it with forces of order (λh)³. `None`
/// if A is singular or the solution is not finite.
///
/// Elimination is written out on arrays: their sizes are known to the compiler, and a stack of many layers does little else.
pub fn solve_equilibrated<const N: usize, const C: usize>(
    matrix: SMatrix<f64, N, N>,
    loads: SMatrix<f64, N, C>,
) -> Option<SMatrix<f64, N, C>> {
    // column by column
    let (mut a, mut b) = (matrix.data.0, loads.data.0);
    let mut sizes = [0.0f64; N];
    for column in &a {
        sizes.iter_mut().zip(column).for_each(|(size, x)| *size = size.max(x.abs()));
    }
    let factors = sizes.map(f64::recip);
    for column in a.iter_mut().chain(&mut b) {
        column.iter_mut().zip(&factors).for_each(|(x, factor)| *x *= factor);
    }
    let mut columns = [0.0; N];
    for (column, factor) in a.iter_mut().zip(&mut columns) {
        *factor = column.iter().fold(0.0f64, |size, x| size.max(x.abs())).recip();
        column.iter_mut().for_each(|x| *x *= *factor);
    }
    // Gauss and Jordan: rows stay where they are, so that every step is the same few operations on whole columns
    let (mut rows, mut pivots, mut used) = ([0; N], [0.0; N], [false; N]);
    for k in 0..N {
        let column = a[k];
        let (mut row, mut size) = (0, 0.0);
        for i in 0..N {
            if !used[i] && column[i].abs() > size {
                (row, size) = (i, column[i].abs());
            }
        }
        if size == 0.0 {
            return None;
        }
        (rows[k], pivots[k], used[row]) = (row, column[row].recip(), true);
        let mut factors = column.map(|x| x * pivots[k]);
        factors[row] = 0.0;
        for column in &mut a[k + 1..] {
            eliminate(column, row, &factors);
        }
        for column in &mut b {
            eliminate(column, row, &factors);
        }
    }
    let solved = SMatrix::<f64, N, C>::from_fn(|k, c| b[c][rows[k]] * pivots[k] * columns[k]);
    solved.iter().all(|x| x.is_finite()).then_some(solved)
}

#[inline(always)]
fn eliminate<const N: usize>(column: &mut [f64; N], row: usize, factors: &[f64; N]) {
    let top = column[row];
    for i in 0..N {
        column[i] -= factors[i] * top;
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix2, Vector2};

    use super::*;

    #[test]
    fn units_of_rows_and_columns_do_not_matter() {
        let plain = Matrix2::new(2.0, 1.0, 1.0, 3.0);
        let solution = Vector2::new(1.0, -1.0);
        let (rows, columns) = (Matrix2::new(1e-200, 0.0, 0.0, 1e9), Matrix2::new(1e-12, 0.0, 0.0, 1e80));
        let found = solve_equilibrated(rows * plain * columns, rows * plain * solution).expect("regular");
        assert!((columns * found - solution).amax() < 1e-15);
    }

    #[test]
    fn a_singular_matrix_has_no_solution() {
        assert_eq!(solve_equilibrated(Matrix2::new(1.0, 2.0, 2.0, 4.0), Vector2::new(1.0, 0.0)), None);
        assert_eq!(solve_equilibrated(Matrix2::new(0.0, 0.0, 2.0, 4.0), Vector2::new(1.0, 0.0)), None);
        assert_eq!(solve_equilibrated(Matrix2::identity() * f64::NAN, Vector2::new(1.0, 0.0)), None);
    }
}
