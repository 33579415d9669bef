//! The rows at an interface as matrices over the states (λμ₀U, λμ₀V, S, T) on its two sides.
use nalgebra::{Matrix4, SMatrix};
use recede_layers::Wave;

use crate::system::{InterfaceSide, Row};

/// Places of the stresses in a state.
const STRESSES: [usize; 2] = [2, 3];

/// N rows over the state above an interface and that below it.
#[derive(Clone, Debug)]
pub(super) struct JunctionRows<const N: usize> {
    /// Factors ±1.
    plain: [SMatrix<f64, N, 4>; 2],
    /// Stiffnesses, in stress per length.
    stiffness: [SMatrix<f64, N, 4>; 2],
}

impl<const N: usize> JunctionRows<N> {
    /// More or fewer than N rows, which no block system has, would determine nothing: all stay zero, so that the matrix of a
    /// chain with them is singular.
    pub(super) fn new<'a>(rows: impl Iterator<Item = &'a Row>) -> Self {
        let zeros = [SMatrix::zeros(); 2];
        let mut all = Self { plain: zeros, stiffness: zeros };
        let Ok(rows) = <[&Row; N]>::try_from(rows.collect::<Vec<_>>()) else { return all };
        for (i, row) in rows.into_iter().enumerate() {
            for block in row.blocks.iter() {
                let sign = if block.negative { -1.0 } else { 1.0 };
                let (matrices, factor) = match block.stiffness {
                    Some(stiffness) => (&mut all.stiffness, sign * stiffness),
                    None => (&mut all.plain, sign),
                };
                matrices[block.side() as usize][(i, block.quantity.index())] += factor;
            }
        }
        all
    }

    /// The rows at one wavenumber, for the states above and below.
    pub(super) fn at(&self, wave: &Wave) -> [SMatrix<f64, N, 4>; 2] {
        let mut filled = self.plain;
        // states hold λμ₀ times the displacements
        let displacement = wave.wavenumber * wave.modulus;
        for i in 0..N {
            let stiffness = self.stiffness.iter().fold(0.0, |most: f64, side| most.max(side.row(i).amax()));
            if stiffness > 0.0 {
                // λμ₀ and the stiffness may be of any size: only their ratio counts
                let largest = displacement.max(stiffness);
                for (filled, stiffness) in filled.iter_mut().zip(&self.stiffness) {
                    let row = filled.row(i) * (displacement / largest) + stiffness.row(i) / largest;
                    filled.set_row(i, &row);
                }
            }
        }
        filled
    }
}

/// An interface between two layers of a chain.
#[derive(Clone, Debug)]
pub(super) struct Junction {
    /// The rows as they are used from above and from below; `None` if they say that the states on both sides are the same.
    rows: Option<Box<[JunctionRows<4>; 2]>>,
}

impl Junction {
    pub(super) fn new<'a>(rows: impl Iterator<Item = &'a Row>) -> Self {
        let rows = JunctionRows::<4>::new(rows);
        let [above, below] = &rows.plain;
        if rows.stiffness == [Matrix4::zeros(); 2] && *above == -below && above.determinant() != 0.0 {
            return Self { rows: None };
        }
        Self {
            rows: Some(Box::new(
                [InterfaceSide::Above, InterfaceSide::Below].map(|near| with_far_stresses(rows.clone(), near)),
            )),
        }
    }

    /// Whether the states on both sides are the same.
    pub(super) fn is_bonded(&self) -> bool {
        self.rows.is_none()
    }

    /// The rows at one wavenumber for the state on the side `near`, and for that on the other side; `None` if
    /// both states are the same.
    pub(super) fn at(&self, wave: &Wave, near: InterfaceSide) -> Option<[Matrix4<f64>; 2]> {
        let near = near as usize;
        let mut rows = self.rows.as_ref()?[near].at(wave);
        rows.swap(0, near);
        Some(rows)
    }
}

/// The same rows with stresses of the near side replaced by stresses of the far side, where a row says that both are equal. The
/// stress of springs then follows from the jump: the stress on the near side, computed from a stiffness and a load, would
/// cancel where the springs are soft.
fn with_far_stresses(mut rows: JunctionRows<4>, near: InterfaceSide) -> JunctionRows<4> {
    let (near, far) = (near as usize, 1 - near as usize);
    for stress in STRESSES {
        let entries = |i: usize| {
            let all = rows.plain.iter().chain(&rows.stiffness).flat_map(|matrix| (0..4).map(move |j| matrix[(i, j)]));
            all.filter(|factor| *factor != 0.0).count()
        };
        let equates = |i: usize| {
            let factors = [near, far].map(|side| rows.plain[side][(i, stress)]);
            factors[0] != 0.0 && factors[1] == -factors[0] && entries(i) == 2
        };
        let Some(equal) = (0..4).find(|i| equates(*i)) else { continue };
        for i in (0..4).filter(|i| *i != equal) {
            let factor = rows.plain[near][(i, stress)];
            rows.plain[near][(i, stress)] = 0.0;
            rows.plain[far][(i, stress)] += factor;
        }
    }
    rows
}
