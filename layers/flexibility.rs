//! How far the faces of a free body move under pressure on them.
use nalgebra::{Matrix4, Matrix4x3};

use crate::FaceStates;
use crate::linear::solve_equilibrated;

/// Flexibility of a free body with shear-free faces: [V_top, V_bottom] = C [S_top, S_bottom], given as the
/// dimensionless λμ₀C.
///
/// Reciprocity makes C_bt = −C_tb. A long wave bends a free body like a beam, so C grows like λ⁻⁴ while the response
/// to *equal* loads on both faces does not: it is a load case of its own here, never a sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flexibility {
    /// λμ₀C_tt > 0: top face under a load on the top face.
    pub top: f64,
    /// λμ₀C_tb = −λμ₀C_bt: top face under a load on the bottom face.
    pub coupling: f64,
    /// λμ₀C_bb < 0: bottom face under a load on the bottom face.
    pub bottom: f64,
    /// λμ₀(C_tt + C_tb): top face under equal loads.
    pub equal_top: f64,
    /// λμ₀(C_bt + C_bb): bottom face under equal loads.
    pub equal_bottom: f64,
}

impl Flexibility {
    /// The flexibility that follows from the states at a layer's faces; `None` for a half-plane, which has one face
    /// only, or if the layer's amplitudes do not determine its state.
    pub fn of_face_states(states: &FaceStates) -> Option<Self> {
        let FaceStates::Finite { top, bottom, uniform: [at_top, at_bottom] } = states else { return None };
        let rows = Matrix4::from_rows(&[top.row(2), top.row(3), bottom.row(2), bottom.row(3)]);
        #[rustfmt::skip]
        let loads = Matrix4x3::new(
            1.0, 0.0, -at_top[2],
            0.0, 0.0, -at_top[3],
            0.0, 1.0, -at_bottom[2],
            0.0, 0.0, -at_bottom[3],
        );
        let amplitudes = solve_equilibrated(rows, loads)?;
        let at = |face: &Matrix4<f64>, case: usize| (face.row(1) * amplitudes.column(case))[0];
        Some(Self {
            top: at(top, 0),
            coupling: at(top, 1),
            bottom: at(bottom, 1),
            equal_top: at(top, 2) + at_top[1],
            equal_bottom: at(bottom, 2) + at_bottom[1],
        })
    }
}
