//! Layers bonded to each other.
use nalgebra::{Matrix2, SMatrix};

use crate::{FaceStates, Flexibility, solve_equilibrated};

/// Two layers bonded to each other, by one system of eight equations.
pub(super) fn bonded(above: &FaceStates, below: &FaceStates) -> Option<Flexibility> {
    let FaceStates::Finite { top, bottom, uniform } = above else { return None };
    let FaceStates::Finite { top: lower_top, bottom: lower_bottom, uniform: lower_uniform } = below else {
        return None;
    };
    let mut system = SMatrix::<f64, 8, 8>::zeros();
    system.fixed_view_mut::<2, 4>(0, 0).copy_from(&top.fixed_rows::<2>(2));
    system.fixed_view_mut::<4, 4>(2, 0).copy_from(bottom);
    system.fixed_view_mut::<4, 4>(2, 4).copy_from(&-lower_top);
    system.fixed_view_mut::<2, 4>(6, 4).copy_from(&lower_bottom.fixed_rows::<2>(2));
    let mut loads = SMatrix::<f64, 8, 3>::zeros();
    loads[(0, 0)] = 1.0;
    loads[(6, 1)] = 1.0;
    loads.fixed_view_mut::<2, 1>(0, 2).copy_from(&-uniform[0].fixed_rows::<2>(2));
    loads.fixed_view_mut::<4, 1>(2, 2).copy_from(&(lower_uniform[0] - uniform[1]));
    loads.fixed_view_mut::<2, 1>(6, 2).copy_from(&-lower_uniform[1].fixed_rows::<2>(2));
    let amplitudes = solve_equilibrated(system, loads)?;
    let at_top = top.row(1) * amplitudes.fixed_rows::<4>(0);
    let at_bottom = lower_bottom.row(1) * amplitudes.fixed_rows::<4>(4);
    Some(Flexibility {
        top: at_top[0],
        coupling: at_top[1],
        bottom: at_bottom[1],
        equal_top: at_top[2] + uniform[0][1],
        equal_bottom: at_bottom[2] + lower_uniform[1][1],
    })
}

/// A layer bonded to a half-plane.
pub(super) fn bonded_to_half_plane(above: &FaceStates, below: &FaceStates) -> Option<Matrix2<f64>> {
    let (FaceStates::Finite { top, bottom, .. }, FaceStates::HalfPlane { top: lower }) = (above, below) else {
        return None;
    };
    let mut system = SMatrix::<f64, 6, 6>::zeros();
    system.fixed_view_mut::<2, 4>(0, 0).copy_from(&top.fixed_rows::<2>(2));
    system.fixed_view_mut::<4, 4>(2, 0).copy_from(bottom);
    system.fixed_view_mut::<4, 2>(2, 4).copy_from(&-lower);
    let amplitudes = solve_equilibrated(system, SMatrix::<f64, 6, 2>::identity())?;
    Some(top.fixed_rows::<2>(0) * amplitudes.fixed_rows::<4>(0))
}
