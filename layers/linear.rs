//! The one small linear solve that layers and block systems need.
use nalgebra::{Const, DimMin, SMatrix};

/// Solves A X = B after bringing every row and column of A to size one, so that pivots are chosen by what matters and
/// not by units: a long wave stretches a layer with forces of order λh and bends it with forces of order (λh)³. `None`
/// if A is singular or the solution is not finite.
pub fn solve_equilibrated<const N: usize, const C: usize>(
    mut matrix: SMatrix<f64, N, N>,
    mut loads: SMatrix<f64, N, C>,
) -> Option<SMatrix<f64, N, C>>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    for i in 0..N {
        let size = matrix.row(i).amax();
        matrix.row_mut(i).unscale_mut(size);
        loads.row_mut(i).unscale_mut(size);
    }
    let mut columns = [0.0; N];
    for (j, size) in columns.iter_mut().enumerate() {
        *size = matrix.column(j).amax();
        matrix.column_mut(j).unscale_mut(*size);
    }
    if !matrix.lu().solve_mut(&mut loads) {
        return None;
    }
    for (j, size) in columns.iter().enumerate() {
        loads.row_mut(j).unscale_mut(*size);
    }
    loads.iter().all(|x| x.is_finite()).then_some(loads)
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
