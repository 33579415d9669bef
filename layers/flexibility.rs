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
    /// λμ₀C_tb from both load cases: the stiffer face hardly moves under a load on the softer one, so it is the softer
    /// face whose displacement tells. Arguments: V of the top face under a load on the top and on the bottom face, then
    /// V of the bottom face likewise.
    pub fn coupling(top_by_top: f64, top_by_bottom: f64, bottom_by_top: f64, bottom_by_bottom: f64) -> f64 {
        if bottom_by_bottom.abs() > top_by_top.abs() { -bottom_by_top } else { top_by_bottom }
    }

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
            coupling: Self::coupling(at(top, 0), at(top, 1), at(bottom, 0), at(bottom, 1)),
            bottom: at(bottom, 1),
            equal_top: at(top, 2) + at_top[1],
            equal_bottom: at(bottom, 2) + at_bottom[1],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ClosedForm, HalfPlane, Homogeneous, Plane, Wave};

    #[test]
    fn a_half_plane_has_one_face_only() {
        let wave = Wave { wavenumber: 1.0, modulus: 1.0, plane: Plane::Strain };
        let ground = HalfPlane::new(1.0, 0.25).expect("legal");
        assert_eq!(Flexibility::of_face_states(&ground.face_states(&wave)), None);
    }

    #[test]
    fn amplitudes_are_the_layers_own_choice() {
        let wave = Wave { wavenumber: 1.5, modulus: 1.0, plane: Plane::Strain };
        let layer = Homogeneous::new(1.0, 1.0, 0.25).expect("legal");
        let expected = layer.flexibility(&wave).expect("finite");
        let FaceStates::Finite { top, bottom, .. } = layer.face_states(&wave) else { panic!("two faces") };
        let mixed = Matrix4::from_fn(|i, j| 1.0 / (1.0 + (i + 2 * j) as f64) + if i == j { 1.0 } else { 0.0 });
        let found = Flexibility::of_face_states(&FaceStates::thick(top * mixed, bottom * mixed)).expect("finite");
        for (a, b) in [(found.top, expected.top), (found.coupling, expected.coupling), (found.bottom, expected.bottom)]
        {
            assert!((a / b - 1.0).abs() < 1e-12);
        }
    }
}
