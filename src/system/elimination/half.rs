//! The part of a free chain between a loaded face and an interface, with the amplitudes eliminated.
use nalgebra::{
    Matrix2, Matrix2x3, Matrix2x4, Matrix2x6, Matrix4, Matrix4x2, Matrix4x3, Matrix4x6, RowVector4, SMatrix, Vector2,
    Vector4,
};
use recede_layers::{Flexibility, State, Wave, solve_equilibrated};

use super::junction::Junction;
use crate::system::InterfaceSide;

/// The result of the elimination so far, as functions of the displacements (U, V) at the interface, of the load and of equal loads on both
/// faces of the chain, one column each. Under equal loads S is the stress minus the load.
#[derive(Clone, Copy, Debug)]
pub(super) struct Half {
    /// The stresses (S, T) at the interface.
    pub(super) stress: Matrix2x4<f64>,
    /// V at the loaded face.
    pub(super) face: RowVector4<f64>,
}

/// The back substitution of a layer: its amplitudes and, where the interface before it is not bonded, the displacements on the other
/// side of that. Columns for the displacements w at its far face, for the load and for equal loads.
#[derive(Clone, Copy, Debug)]
pub(super) struct PutBack {
    pub(super) amplitudes: Matrix4<f64>,
    pub(super) before: Option<Matrix2x4<f64>>,
}

/// A face of a layer: its states, and the deviation from uniform pressure there.
pub(super) type FaceOf<'a> = (&'a Matrix4<f64>, &'a State);

impl Half {
    /// Before the first layer: the interface is the loaded face itself, on which there is no shear.
    pub(super) fn of_face() -> Self {
        let mut stress = Matrix2x4::zeros();
        stress.set_column(2, &uniform());
        Self { stress, face: RowVector4::new(0.0, 1.0, 0.0, 0.0) }
    }

    /// One layer more: `near` is its face at the present interface, `far` the one that becomes the interface. `across` are the
    /// rows at the present one, for the states on this side and on the side of the layer; `None` if these are the same.
    pub(super) fn through(
        &self,
        across: Option<[Matrix4<f64>; 2]>,
        near: FaceOf<'_>,
        far: FaceOf<'_>,
    ) -> Option<(Self, PutBack)> {
        let [(near, near_uniform), (far, far_uniform)] = [near, far];
        // two rows on the amplitudes of the layer, the load and equal loads
        let (condition, known, solved) = match across {
            None => {
                let stiffness = self.stiffness();
                let mut known: Matrix2<f64> = self.stress.fixed_columns::<2>(2).into_owned();
                let uniform = near_uniform.fixed_rows::<2>(2) - stiffness * near_uniform.fixed_rows::<2>(0);
                known.set_column(1, &(known.column(1) - uniform));
                (stress(near) - stiffness * displacement(near), known, None)
            }
            Some(rows) => {
                let [left, solved] = self.behind(&rows, near_uniform)?;
                let known: Matrix2<f64> = -left.fixed_columns::<2>(4);
                (left.fixed_columns::<4>(0) * near, known, Some(solved))
            }
        };
        let mut loads = Matrix4::zeros();
        loads.fixed_view_mut::<2, 2>(2, 0).fill_with_identity();
        loads.fixed_view_mut::<2, 2>(0, 2).copy_from(&known);
        loads.fixed_view_mut::<2, 1>(2, 3).copy_from(&-far_uniform.fixed_rows::<2>(0));
        let amplitudes = solve_equilibrated(stacked(&condition, &displacement(far)), loads)?;

        let own_face = self.face.fixed_columns::<2>(0);
        let (mut face, before) = match solved {
            None => {
                let mut face = own_face * displacement(near) * amplitudes;
                face[3] += (own_face * near_uniform.fixed_rows::<2>(0))[0];
                (face, None)
            }
            Some(solved) => {
                let mut before: Matrix2x4<f64> = solved.fixed_columns::<4>(0) * near * amplitudes;
                let mut by_loads = before.fixed_columns_mut::<2>(2);
                by_loads += solved.fixed_columns::<2>(4);
                (own_face * before, Some(before))
            }
        };
        face[2] += self.face[2];
        face[3] += self.face[3];
        let mut stress = stress(far) * amplitudes;
        stress.set_column(3, &(stress.column(3) + far_uniform.fixed_rows::<2>(2)));
        Some((Self { stress, face }, PutBack { amplitudes, before }))
    }

    /// The stresses at the interface under unit displacements there.
    fn stiffness(&self) -> Matrix2<f64> {
        self.stress.fixed_columns::<2>(0).into_owned()
    }

    /// The rows of an interface on which states differ, filled with the state on this side, which is a function of two displacements, after the
    /// elimination of these. Columns for the state of the layer, for the load and for equal loads.
    fn behind(&self, rows: &[Matrix4<f64>; 2], near_uniform: &State) -> Option<[Matrix2x6<f64>; 2]> {
        let [this_side, layer_side] = rows;
        let stress_columns = this_side.fixed_columns::<2>(2);
        let mut known = Matrix4x6::zeros();
        known.fixed_view_mut::<4, 4>(0, 0).copy_from(layer_side);
        known.set_column(4, &(stress_columns * self.stress.column(2)));
        known.set_column(5, &(stress_columns * self.stress.column(3) + layer_side * near_uniform + of_uniform(rows)));
        eliminate_two(this_side.fixed_columns::<2>(0) + stress_columns * self.stiffness(), known)
    }
}

/// Displacements (U, V) above and below the interface at which two halves meet, columns for a load on top, on the bottom, and on both.
/// `junction` is the interface; `None` if one of the halves has no layers.
pub(super) fn meet(
    [above, below]: &[Half; 2],
    junction: Option<&Junction>,
    wave: &Wave,
) -> Option<[Matrix2x3<f64>; 2]> {
    let Some(rows) = junction.and_then(|junction| junction.at(wave, InterfaceSide::Above)) else {
        // stresses are continuous: K_above w + ... = K_below w + ...
        let by = |half: &Half, column: usize| half.stress.column(column).into_owned();
        let zero = Vector2::zeros();
        let loads = Matrix2x3::from_columns(&[zero - by(above, 2), by(below, 2), by(below, 3) - by(above, 3)]);
        return Some([solve_equilibrated(above.stiffness() - below.stiffness(), loads)?; 2]);
    };
    let mut matrix = Matrix4::zeros();
    let mut loads = Matrix4x3::zeros();
    let equal = of_uniform(&rows);
    loads.set_column(2, &-equal);
    for (i, (rows, half)) in rows.iter().zip([above, below]).enumerate() {
        let stress = rows.fixed_columns::<2>(2);
        let columns = rows.fixed_columns::<2>(0) + stress * half.stiffness();
        matrix.fixed_view_mut::<4, 2>(0, 2 * i).copy_from(&columns);
        loads.set_column(i, &-(stress * half.stress.column(2)));
        let equal = loads.column(2) - stress * half.stress.column(3);
        loads.set_column(2, &equal);
    }
    let solved = solve_equilibrated(matrix, loads)?;
    Some([solved.fixed_rows::<2>(0).into_owned(), solved.fixed_rows::<2>(2).into_owned()])
}

/// The flexibility of the faces of two halves, from the displacements where they meet.
pub(super) fn flexibility([above, below]: &[Half; 2], displacements: &[Matrix2x3<f64>; 2]) -> Flexibility {
    let [top, bottom] = [(above, 0), (below, 1)].map(|(half, i)| half.face.fixed_columns::<2>(0) * displacements[i]);
    let (top_by_top, bottom_by_bottom) = (top[0] + above.face[2], bottom[1] + below.face[2]);
    Flexibility {
        top: top_by_top,
        coupling: Flexibility::coupling(top_by_top, top[1], bottom[0], bottom_by_bottom),
        bottom: bottom_by_bottom,
        equal_top: top[2] + above.face[3],
        equal_bottom: bottom[2] + below.face[3],
    }
}

/// The stresses (S, T) of uniform pressure.
pub(super) fn uniform() -> Vector2<f64> {
    Vector2::new(1.0, 0.0)
}

/// Eliminates two unknowns from four rows, whose other columns are `others`: two rows without the unknowns, and the unknowns as functions of
/// the other columns; `None` if the rows do not determine the unknowns.
///
/// An unknown that occurs in no row, as the motion along springs that resist none below an interface that slides, is 0.
///
/// Written out on arrays of known sizes, as [`solve_equilibrated`] is.
pub(super) fn eliminate_two<const M: usize>(
    unknowns: Matrix4x2<f64>,
    others: SMatrix<f64, 4, M>,
) -> Option<[SMatrix<f64, 2, M>; 2]> {
    let mut sizes = [unknowns.column(0).amax().recip(), unknowns.column(1).amax().recip()];
    let mut unknowns: [[f64; 2]; 4] = std::array::from_fn(|i| [unknowns[(i, 0)], unknowns[(i, 1)]]);
    let mut others: [[f64; M]; 4] = std::array::from_fn(|i| std::array::from_fn(|j| others[(i, j)]));
    if let Some(free) = sizes.iter().position(|size| size.is_infinite()) {
        // there is a row without entries then, which may say so
        let is_empty = |row: &usize| unknowns[*row].iter().chain(&others[*row]).all(|entry| *entry == 0.0);
        let row = (0..4).find(is_empty)?;
        (unknowns[row][free], sizes[free]) = (1.0, 1.0);
    }
    // pivots: the largest entry, columns scaled by their largest, then the largest remaining entry of the other column
    let mut largest = (0.0, 0, 0);
    for (i, row) in unknowns.iter().enumerate() {
        for (column, size) in sizes.iter().enumerate() {
            let found = row[column].abs() * size;
            if found > largest.0 {
                largest = (found, i, column);
            }
        }
    }
    let (_, first, column) = largest;
    eliminate(&mut unknowns, &mut others, first, column);
    let left = |row: usize| if row == first { 0.0 } else { unknowns[row][1 - column].abs() };
    let second = (1..4).fold(0, |best, row| if left(row) > left(best) { row } else { best });
    if largest.0 == 0.0 || left(second) == 0.0 {
        return None;
    }
    eliminate(&mut unknowns, &mut others, second, 1 - column);
    let (mut left, mut solved) = (SMatrix::<f64, 2, M>::zeros(), SMatrix::<f64, 2, M>::zeros());
    for (row, column) in [(first, column), (second, 1 - column)] {
        let factor = -unknowns[row][column].recip();
        for j in 0..M {
            solved[(column, j)] = factor * others[row][j];
        }
    }
    for (i, row) in (0..4).filter(|row| *row != first && *row != second).enumerate() {
        for j in 0..M {
            left[(i, j)] = others[row][j];
        }
    }
    Some([left, solved])
}

/// Subtracts a multiple of the pivot row from each other row, so that the entries of a column vanish there.
#[inline(always)]
fn eliminate<const M: usize>(unknowns: &mut [[f64; 2]; 4], others: &mut [[f64; M]; 4], row: usize, column: usize) {
    let (pivot, other) = (unknowns[row], others[row]);
    let divided = pivot[column].recip();
    for i in (0..4).filter(|i| *i != row) {
        let factor = unknowns[i][column] * divided;
        unknowns[i][1 - column] -= factor * pivot[1 - column];
        unknowns[i][column] = 0.0;
        for j in 0..M {
            others[i][j] -= factor * other[j];
        }
    }
}

/// The rows of an interface applied to uniform pressure on both of its sides.
fn of_uniform(rows: &[Matrix4<f64>; 2]) -> Vector4<f64> {
    let [above, below] = rows;
    (above + below).fixed_columns::<2>(2) * uniform()
}

pub(super) fn displacement(states: &Matrix4<f64>) -> Matrix2x4<f64> {
    states.fixed_rows::<2>(0).into_owned()
}

pub(super) fn stress(states: &Matrix4<f64>) -> Matrix2x4<f64> {
    states.fixed_rows::<2>(2).into_owned()
}

pub(super) fn stacked(upper: &Matrix2x4<f64>, lower: &Matrix2x4<f64>) -> Matrix4<f64> {
    Matrix4::from_rows(&[upper.row(0), upper.row(1), lower.row(0), lower.row(1)])
}
