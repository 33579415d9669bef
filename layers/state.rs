//! The plain values that layers and solver exchange.
use nalgebra::{Matrix4, Matrix4x2, Vector4};

use crate::Plane;

/// One Fourier component: at which wavenumber, in which plane problem, in units of which modulus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave {
    /// Wavenumber λ > 0, in 1/length.
    pub wavenumber: f64,
    /// Modulus μ₀ by which displacements are multiplied, in stress.
    pub modulus: f64,
    /// Plane strain or plane stress.
    pub plane: Plane,
}

/// The transformed fields at one depth, (λμ₀U, λμ₀V, S, T), all in units of stress; see the crate's conventions.
pub type State = Vector4<f64>;

/// States at the faces of a layer as linear functions of the layer's amplitudes: column j is the state that
/// amplitude j = 1 produces. The choice of the amplitudes is the layer's own; no column overflows at any wavenumber.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "copied, not stored: a box would cost more")]
pub enum FaceStates {
    /// A layer of finite thickness: four amplitudes, two faces.
    Finite {
        /// States at the top face.
        top: Matrix4<f64>,
        /// States at the bottom face.
        bottom: Matrix4<f64>,
        /// A field close to uniform pressure, S = 1 and nothing else: its deviation from it at the top and at the
        /// bottom face. Where λh is small the deviation is small, of the order (λh)², and given to full relative
        /// accuracy: equal loads on both faces of a thin laminate would lose all digits otherwise.
        uniform: [State; 2],
    },
    /// A layer that fills everything below its top face: two amplitudes, which decay with depth.
    HalfPlane {
        /// States at the top face.
        top: Matrix4x2<f64>,
    },
}

/// States at the faces of a layer and at depths inside, all as functions of the same amplitudes.
#[derive(Clone, Debug, PartialEq)]
pub struct LayerStates {
    /// States at the faces.
    pub faces: FaceStates,
    /// States at the depths asked for, in their order.
    pub inside: Vec<InnerStates>,
}

/// States at one depth inside a layer as linear functions of the layer's amplitudes, see [`FaceStates`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InnerStates {
    /// Column j is the state that amplitude j = 1 produces; the last two columns are zero for a half-plane.
    pub columns: Matrix4<f64>,
    /// The field close to uniform pressure: its deviation from S = 1 and nothing else.
    pub uniform: State,
}

impl LayerStates {
    /// The same in units of another modulus: displacements times `factor`.
    pub(crate) fn with_displacements_times(self, factor: f64) -> Self {
        let mut inside = self.inside;
        for states in &mut inside {
            states.columns.fixed_rows_mut::<2>(0).scale_mut(factor);
            states.uniform.fixed_rows_mut::<2>(0).scale_mut(factor);
        }
        Self { faces: self.faces.with_displacements_times(factor), inside }
    }
}

impl InnerStates {
    /// States inside a layer so thick that the field close to uniform pressure is no field at all.
    pub fn thick(columns: Matrix4<f64>) -> Self {
        Self { columns, uniform: -Vector4::z() }
    }
}

impl FaceStates {
    /// The same in units of another modulus: displacements times `factor`.
    pub(crate) fn with_displacements_times(mut self, factor: f64) -> Self {
        match &mut self {
            Self::Finite { top, bottom, uniform } => {
                top.fixed_rows_mut::<2>(0).scale_mut(factor);
                bottom.fixed_rows_mut::<2>(0).scale_mut(factor);
                uniform.iter_mut().for_each(|state| state.fixed_rows_mut::<2>(0).scale_mut(factor));
            }
            Self::HalfPlane { top } => top.fixed_rows_mut::<2>(0).scale_mut(factor),
        }
        self
    }

    /// Face states of a layer so thick that uniform pressure needs no care: the field "close to it" is no field at
    /// all.
    pub fn thick(top: Matrix4<f64>, bottom: Matrix4<f64>) -> Self {
        let nothing = -Vector4::z();
        Self::Finite { top, bottom, uniform: [nothing, nothing] }
    }
}
