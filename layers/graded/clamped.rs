//! Thick layers: amplitudes = the stresses on one face while the other is clamped, or absent.
use nalgebra::{Matrix2, Matrix4, Matrix4x2};

use super::slices::inverse;
use crate::{FaceStates, State};

/// Above this a layer counts as thick whatever its length, see [`Clamped::independence`].
const INDEPENDENT: f64 = 0.01;

/// A layer seen from one of its faces.
pub(super) struct Seen {
    /// (λμ₀U, λμ₀V) at the face from (S, T) on it.
    pub flexibility: Matrix2<f64>,
    /// (S, T) on the far, clamped face from (S, T) on this one; `None` if there is no far face.
    pub far: Option<Matrix2<f64>>,
}

impl Seen {
    /// Nothing yet, next to the clamp.
    pub fn clamped() -> Self {
        Self { flexibility: Matrix2::zeros(), far: Some(Matrix2::identity()) }
    }

    /// The face moved through a slice, away from the far one.
    pub fn through(self, transfer: &Matrix4<f64>) -> Self {
        let (flexibility, back) = step(&self.flexibility, transfer);
        Self { flexibility, far: self.far.map(|far| far * back) }
    }

    /// The states at the face for S = 1 and for T = 1 on it.
    pub fn states(&self) -> Matrix4x2<f64> {
        stacked(&self.flexibility, &Matrix2::identity())
    }

    /// The states at the far face for S = 1 and for T = 1 on this one.
    fn far_states(&self) -> Matrix4x2<f64> {
        stacked(&Matrix2::zeros(), &self.far.unwrap_or(Matrix2::zeros()))
    }
}

/// A flexibility carried through a slice, whose transfer matrix, less identity, leads there; and the way back of the
/// stresses.
pub(super) fn step(flexibility: &Matrix2<f64>, transfer: &Matrix4<f64>) -> (Matrix2<f64>, Matrix2<f64>) {
    let block = |i: usize, j: usize| transfer.fixed_view::<2, 2>(i, j);
    let displacement = flexibility + (block(0, 0) * flexibility + block(0, 2));
    let stress = Matrix2::identity() + (block(2, 0) * flexibility + block(2, 2));
    let back = stress.try_inverse().unwrap_or(Matrix2::repeat(f64::NAN));
    (displacement * back, back)
}

/// A layer of which one or the other face is clamped. Amplitudes = (S, T) on the top face above a clamped bottom, then
/// (S, T) on the bottom face below a clamped top.
pub(crate) struct Clamped {
    from_top: Seen,
    from_bottom: Seen,
}

impl Clamped {
    /// From the transfer matrices, less identity, of consecutive slices from the top down.
    pub fn new<'a>(transfers: impl DoubleEndedIterator<Item = &'a Matrix4<f64>> + Clone) -> Self {
        Self {
            from_top: transfers.clone().rev().fold(Seen::clamped(), |seen, transfer| seen.through(transfer)),
            from_bottom: transfers.fold(Seen::clamped(), |seen, transfer| seen.through(&inverse(transfer))),
        }
    }

    /// 1 if the faces do not feel each other, 0 if stresses on one face are handed on to the other unchanged, as in a
    /// layer that moves like a rigid body.
    fn independence(&self) -> f64 {
        let [down, up] = [&self.from_top, &self.from_bottom].map(|seen| seen.far.unwrap_or(Matrix2::zeros()));
        (Matrix2::identity() - up * down).determinant()
    }

    /// Whether the faces feel each other so little that the amplitudes are well chosen.
    pub fn is_independent(&self) -> bool {
        self.independence() > INDEPENDENT
    }

    pub fn face_states(&self, uniform: [State; 2]) -> FaceStates {
        FaceStates::Finite {
            top: beside(&self.from_top.states(), &self.from_bottom.far_states()),
            bottom: beside(&self.from_top.far_states(), &self.from_bottom.states()),
            uniform,
        }
    }
}

/// The flexibility of a face that looks down rather than up: V and T change their signs.
pub(super) fn upside_down(flexibility: Matrix2<f64>) -> Matrix2<f64> {
    Matrix2::from_fn(|i, j| if i == j { flexibility[(i, j)] } else { -flexibility[(i, j)] })
}

fn stacked(upper: &Matrix2<f64>, lower: &Matrix2<f64>) -> Matrix4x2<f64> {
    Matrix4x2::from_fn(|i, j| if i < 2 { upper[(i, j)] } else { lower[(i - 2, j)] })
}

pub(super) fn beside(left: &Matrix4x2<f64>, right: &Matrix4x2<f64>) -> Matrix4<f64> {
    Matrix4::from_fn(|i, j| if j < 2 { left[(i, j)] } else { right[(i, j - 2)] })
}
