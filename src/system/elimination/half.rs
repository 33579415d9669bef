//! The part of a free chain between a loaded face and an interface, with the amplitudes eliminated.
use nalgebra::{
    Matrix2, Matrix2x3, Matrix2x4, Matrix4, Matrix4x2, Matrix4x3, Matrix4x6, RowVector2, RowVector4, SMatrix, Vector2,
    Vector4,
};
use recede_layers::{Flexibility, State, Wave, solve_equilibrated};

use super::junction::{Junction, Rows};
use crate::system::{Row, Side};

/// The result of the elimination so far: the stresses (S, T) at the interface and V at the face, as
/// functions of the displacements w = (U, V) at the interface and of the load. Under equal loads on both faces of the
/// chain, S is the stress minus the load.
#[derive(Clone, Copy, Debug)]
pub(super) struct Half {
    pub(super) stiffness: Matrix2<f64>,
    pub(super) by_load: Vector2<f64>,
    pub(super) by_equal: Vector2<f64>,
    pub(super) face: RowVector2<f64>,
    pub(super) face_by_load: f64,
    pub(super) face_by_equal: f64,
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
    /// Before the first layer: the interface is the loaded face itself, at which these rows hold for the layer on this side.
    pub(super) fn of_face<'a>(rows: impl Iterator<Item = &'a Row> + Clone, side: Side) -> Self {
        let mut loads = Vector2::zeros();
        loads
            .iter_mut()
            .zip(rows.clone())
            .for_each(|(load, row)| *load = if row.pressure.is_some() { 1.0 } else { 0.0 });
        let [above, below] = Rows::<2>::new(rows).plain();
        let rows = if side == Side::Above { above } else { below };
        // without springs on it a face has no stiffness
        let by_load = rows.fixed_columns::<2>(2).into_owned().try_inverse().map(|inverse| inverse * loads);
        let by_load = by_load.unwrap_or(Vector2::repeat(f64::NAN));
        Self {
            stiffness: Matrix2::zeros(),
            by_load,
            by_equal: by_load - uniform(),
            face: RowVector2::new(0.0, 1.0),
            face_by_load: 0.0,
            face_by_equal: 0.0,
        }
    }

    /// One layer more: `near` is its face at the present interface, `far` the one that becomes the interface. `across` are the
    /// rows at the present one, for the states on this side and on the side of the layer; `None` if these are the same.
    pub(super) fn through(
        &self,
        across: Option<[Matrix4<f64>; 2]>,
        near: FaceOf<'_>,
        far: FaceOf<'_>,
    ) -> Option<(Self, PutBack)> {
        match across {
            None => self.through_bonded(near, far),
            Some(rows) => self.through_rows(&rows, near, far),
        }
    }

    /// Four amplitudes from the stresses at the near face and the displacements at the far one.
    fn through_bonded(&self, near: FaceOf<'_>, far: FaceOf<'_>) -> Option<(Self, PutBack)> {
        let [(near, near_uniform), (far, far_uniform)] = [near, far];
        let condition = stress(near) - self.stiffness * displacement(near);
        let uniform_condition =
            self.by_equal - (near_uniform.fixed_rows::<2>(2) - self.stiffness * near_uniform.fixed_rows::<2>(0));
        let mut loads = Matrix4::zeros();
        loads.fixed_view_mut::<2, 2>(2, 0).fill_with_identity();
        loads.fixed_view_mut::<2, 1>(0, 2).copy_from(&self.by_load);
        loads.fixed_view_mut::<2, 1>(0, 3).copy_from(&uniform_condition);
        loads.fixed_view_mut::<2, 1>(2, 3).copy_from(&-far_uniform.fixed_rows::<2>(0));
        let amplitudes = solve_equilibrated(stacked(&condition, &displacement(far)), loads)?;
        let mut half = self.beyond(far, far_uniform, &amplitudes, &(self.face * displacement(near) * amplitudes));
        half.face_by_equal += (self.face * near_uniform.fixed_rows::<2>(0))[0];
        Some((half, PutBack { amplitudes, before: None }))
    }

    /// The same where rows hold in place of continuity: they are filled with the state on this side, a function of two
    /// displacements, and these are eliminated, which leaves two rows on the state of the layer.
    fn through_rows(&self, rows: &[Matrix4<f64>; 2], near: FaceOf<'_>, far: FaceOf<'_>) -> Option<(Self, PutBack)> {
        let [(near, near_uniform), (far, far_uniform)] = [near, far];
        let [this_side, layer_side] = rows;
        let stress_columns = this_side.fixed_columns::<2>(2);
        // columns for the state of the layer, for the load and for equal loads
        let mut known = Matrix4x6::zeros();
        known.fixed_view_mut::<4, 4>(0, 0).copy_from(layer_side);
        known.set_column(4, &(stress_columns * self.by_load));
        known.set_column(5, &(stress_columns * self.by_equal + layer_side * near_uniform + of_uniform(rows)));
        let unknowns = this_side.fixed_columns::<2>(0) + stress_columns * self.stiffness;
        let Eliminated { left, solved } = eliminate_two(unknowns, known)?;
        let condition: Matrix2x4<f64> = left.fixed_columns::<4>(0) * near;
        let mut loads = Matrix4::zeros();
        loads.fixed_view_mut::<2, 2>(2, 0).fill_with_identity();
        loads.fixed_view_mut::<2, 2>(0, 2).copy_from(&-left.fixed_columns::<2>(4));
        loads.fixed_view_mut::<2, 1>(2, 3).copy_from(&-far_uniform.fixed_rows::<2>(0));
        let amplitudes = solve_equilibrated(stacked(&condition, &displacement(far)), loads)?;
        let mut before: Matrix2x4<f64> = solved.fixed_columns::<4>(0) * near * amplitudes;
        for case in [0, 1] {
            let column = before.column(2 + case) + solved.column(4 + case);
            before.set_column(2 + case, &column);
        }
        let half = self.beyond(far, far_uniform, &amplitudes, &(self.face * before));
        Some((half, PutBack { amplitudes, before: Some(before) }))
    }

    /// The half with one layer more, from the amplitudes of that and V at the loaded face.
    fn beyond(
        &self,
        far: &Matrix4<f64>,
        far_uniform: &State,
        amplitudes: &Matrix4<f64>,
        face: &RowVector4<f64>,
    ) -> Self {
        let at_far = stress(far) * amplitudes;
        Self {
            stiffness: at_far.fixed_columns::<2>(0).into_owned(),
            by_load: at_far.column(2).into_owned(),
            by_equal: at_far.column(3) + far_uniform.fixed_rows::<2>(2),
            face: face.fixed_columns::<2>(0).into_owned(),
            face_by_load: self.face_by_load + face[2],
            face_by_equal: self.face_by_equal + face[3],
        }
    }
}

/// Two halves at the interface where they meet.
pub(super) struct Meeting {
    pub(super) above: Half,
    pub(super) below: Half,
    /// Displacements (U, V) above and below the interface, columns for a load on top, on the bottom, and on both.
    pub(super) displacements: [Matrix2x3<f64>; 2],
}

impl Meeting {
    /// `junction` is the interface; `None` if one of the halves has no layers.
    pub(super) fn of(above: Half, below: Half, junction: Option<&Junction>, wave: &Wave) -> Option<Self> {
        let displacements = match junction.and_then(|junction| junction.at(wave, Side::Above)) {
            None => {
                // stresses are continuous: K_above w + ... = K_below w + ...
                let zero = Vector2::zeros();
                let loads =
                    Matrix2x3::from_columns(&[zero - above.by_load, below.by_load, below.by_equal - above.by_equal]);
                [solve_equilibrated(above.stiffness - below.stiffness, loads)?; 2]
            }
            Some(rows) => {
                let mut matrix = Matrix4::zeros();
                let mut loads = Matrix4x3::zeros();
                let equal = of_uniform(&rows);
                loads.set_column(2, &-equal);
                for (i, (rows, half)) in rows.iter().zip([&above, &below]).enumerate() {
                    let stress = rows.fixed_columns::<2>(2);
                    let columns = rows.fixed_columns::<2>(0) + stress * half.stiffness;
                    matrix.fixed_view_mut::<4, 2>(0, 2 * i).copy_from(&columns);
                    loads.set_column(i, &-(stress * half.by_load));
                    let equal = loads.column(2) - stress * half.by_equal;
                    loads.set_column(2, &equal);
                }
                let solved = solve_equilibrated(matrix, loads)?;
                [solved.fixed_rows::<2>(0).into_owned(), solved.fixed_rows::<2>(2).into_owned()]
            }
        };
        Some(Self { above, below, displacements })
    }

    /// The flexibility of the faces.
    pub(super) fn flexibility(&self) -> Flexibility {
        let Self { above, below, displacements: [at_above, at_below] } = self;
        let (top, bottom) = (above.face * at_above, below.face * at_below);
        let (top_by_top, bottom_by_bottom) = (top[0] + above.face_by_load, bottom[1] + below.face_by_load);
        Flexibility {
            top: top_by_top,
            coupling: Flexibility::coupling(top_by_top, top[1], bottom[0], bottom_by_bottom),
            bottom: bottom_by_bottom,
            equal_top: top[2] + above.face_by_equal,
            equal_bottom: bottom[2] + below.face_by_equal,
        }
    }
}

/// The stresses (S, T) of uniform pressure.
fn uniform() -> Vector2<f64> {
    Vector2::new(1.0, 0.0)
}

/// Four rows after the elimination of two unknowns.
pub(super) struct Eliminated<const M: usize> {
    /// Two rows without the unknowns.
    pub(super) left: SMatrix<f64, 2, M>,
    /// The unknowns as functions of the other columns.
    pub(super) solved: SMatrix<f64, 2, M>,
}

/// Eliminates two unknowns from four rows, whose other columns are `others`; `None` if the rows do not determine the unknowns.
///
/// An unknown that occurs in no row, as the motion along springs that resist none below an interface that slides, is 0.
///
/// Written out on arrays of known sizes, as [`solve_equilibrated`] is.
pub(super) fn eliminate_two<const M: usize>(
    unknowns: Matrix4x2<f64>,
    others: SMatrix<f64, 4, M>,
) -> Option<Eliminated<M>> {
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
    Some(Eliminated { left, solved })
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
