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
