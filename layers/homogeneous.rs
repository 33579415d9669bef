//! A homogeneous, isotropic layer: closed forms at both ends of the wavenumber axis.
use std::any::Any;
use std::sync::Arc;

use nalgebra::{Matrix4, Vector4};
#[cfg(feature = "read")]
use schemars::JsonSchema;
use serde::Deserialize;

use crate::{
    ClosedForm, ElasticConstants, FaceStates, Flexibility, HalfPlane, InnerStates, Isotropic, Key, Layer, LayerError,
    LayerStates, Material, Notation, Plane, Poisson, Positive, Thickness, Wave,
    decay::{decaying_downwards, decaying_upwards, scale},
    stable,
};

/// Up to this λh the amplitudes are the state at mid-depth; beyond, solutions that decay from either face.
const THIN: f64 = 2.0;

/// Homogeneous, isotropic layer of thickness h.
///
/// ```
/// use recede_layers::{Homogeneous, Layer};
/// let strip = Homogeneous::new(1.0, 1.0, 0.25)?;
/// assert_eq!(strip.thickness(), Some(1.0));
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(try_from = "HomogeneousFields")]
pub struct Homogeneous {
    thickness: Thickness,
    constants: ElasticConstants,
}

/// The fields as written in a scene, before they are checked together.
#[derive(Deserialize)]
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(deny_unknown_fields, rename = "Homogeneous")]
struct HomogeneousFields {
    /// Thickness h, in length.
    thickness: Thickness,
    /// Shear modulus μ, in stress; or in its place `young`.
    #[serde(default)]
    shear_modulus: Option<Positive>,
    /// Young's modulus E, in stress; or in its place `shear_modulus`.
    #[serde(default)]
    young: Option<Positive>,
    /// Poisson's ratio ν, dimensionless.
    poisson: Poisson,
}

#[cfg(feature = "read")]
described!(Homogeneous by HomogeneousFields);

impl TryFrom<HomogeneousFields> for Homogeneous {
    type Error = LayerError;

    fn try_from(fields: HomogeneousFields) -> Result<Self, LayerError> {
        let HomogeneousFields { thickness, shear_modulus, young, poisson } = fields;
        Ok(Self { thickness, constants: ElasticConstants::read(shear_modulus, young, poisson)? })
    }
}

impl Homogeneous {
    /// A layer of thickness h ≥ 0 (length; 0 means "not there"), shear modulus μ > 0 (stress) and Poisson's ratio
    /// −1 < ν ≤ 1/2.
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite.
    pub fn new(thickness: f64, shear_modulus: f64, poisson: f64) -> Result<Self, LayerError> {
        Ok(Self {
            thickness: LayerError::checked("thickness", thickness)?,
            constants: ElasticConstants::new(shear_modulus, poisson)?,
        })
    }

    fn isotropic(&self) -> Isotropic {
        self.constants.isotropic()
    }
}

impl Layer for Homogeneous {
    fn thickness(&self) -> Option<f64> {
        Some(self.thickness.get())
    }

    fn material(&self, _depth: f64, plane: Plane) -> Material {
        self.isotropic().material(plane)
    }

    fn closed_form(&self) -> Option<&dyn ClosedForm> {
        Some(self)
    }

    fn continues(&self, below: &dyn Layer) -> Option<Arc<dyn Layer>> {
        let below: &dyn Any = below;
        if let Some(other) = below.downcast_ref::<Self>() {
            let thickness = Thickness::try_from(self.thickness.get() + other.thickness.get()).ok()?;
            return (self.isotropic() == other.isotropic()).then(|| Arc::new(Self { thickness, ..*self }) as _);
        }
        let ground = below.downcast_ref::<HalfPlane>().filter(|ground| ground.isotropic() == self.isotropic())?;
        Some(Arc::new(*ground))
    }

    fn key(&self) -> Option<Key> {
        let Isotropic { shear_modulus, poisson } = self.isotropic();
        Some(Key::of::<Self>().with([self.thickness.get(), shear_modulus, poisson]))
    }

    fn notation(&self) -> Notation {
        self.constants.noted(Notation::of::<Self>().with("thickness", &self.thickness))
    }
}

impl ClosedForm for Homogeneous {
    fn face_states(&self, wave: &Wave) -> FaceStates {
        let depth = wave.wavenumber * self.thickness.get();
        if depth < THIN { thin(&self.isotropic(), wave, depth) } else { thick(&self.isotropic(), wave, depth) }
    }

    fn states(&self, wave: &Wave, depths: &[f64]) -> Option<LayerStates> {
        let (material, z) = (self.isotropic(), wave.wavenumber * self.thickness.get());
        let inside = depths.iter().map(|depth| {
            let below = (wave.wavenumber * depth).min(z);
            if z < THIN {
                thin_inside(&material, wave, 0.5 * z - below)
            } else {
                thick_inside(&material, wave, below, z)
            }
        });
        Some(LayerStates { inside: inside.collect(), faces: self.face_states(wave) })
    }

    /// With z = λh and g = (κ + 1)/(4μ), the half sum and half difference of the responses to equal loads,
    /// λC = g (cosh z − 1)/(sinh z + z), and to opposite ones, λC = g (cosh z + 1)/(sinh z − z).
    fn flexibility(&self, wave: &Wave) -> Option<Flexibility> {
        let z = wave.wavenumber * self.thickness.get();
        let unit = 2.0 * wave.modulus / self.isotropic().material(wave.plane).axial_stiffness;
        let (equal, opposite) = (stable::equal_load_ratio(z), stable::opposite_load_ratio(z));
        let own = 0.5 * unit * (opposite + equal);
        Some(Flexibility {
            top: own,
            coupling: -unit * stable::coupling_ratio(z),
            bottom: -own,
            equal_top: unit * equal,
            equal_bottom: -unit * equal,
        })
    }
}

/// Rows times their factors.
fn scaled(mut states: Matrix4<f64>, scale: &Vector4<f64>) -> Matrix4<f64> {
    for mut column in states.column_iter_mut() {
        column.component_mul_assign(scale);
    }
    states
}

/// Amplitudes = local state at mid-depth. With ζ = λy the state equations read X' = A X, A² = 1 + N, N² = 0, hence
/// cosh Aζ = cosh ζ + N (ζ/2) sinh ζ and sinh Aζ = A sinh ζ + A N (ζ cosh ζ − sinh ζ)/2. Entry by entry these have
/// the small-ζ orders of beam theory and no cancellation.
fn thin(material: &Isotropic, wave: &Wave, depth: f64) -> FaceStates {
    let (even, odd) = even_odd(material, wave.plane, 0.5 * depth);
    let scale = scale(material, wave);
    let identity_plus_even = Matrix4::identity() + even;
    let uniform_top = (even + odd).column(2).component_mul(&scale);
    let uniform_bottom = (even - odd).column(2).component_mul(&scale);
    FaceStates::Finite {
        top: scaled(identity_plus_even + odd, &scale),
        bottom: scaled(identity_plus_even - odd, &scale),
        uniform: [uniform_top, uniform_bottom],
    }
}

/// The same at ζ = λy above mid-depth.
fn thin_inside(material: &Isotropic, wave: &Wave, zeta: f64) -> InnerStates {
    let (even, odd) = even_odd(material, wave.plane, zeta);
    let scale = scale(material, wave);
    let deviation = scaled(even + odd, &scale);
    InnerStates { columns: Matrix4::from_diagonal(&scale) + deviation, uniform: deviation.column(2).into_owned() }
}

/// cosh Aζ − 1 and sinh Aζ in local components, ζ of either sign.
fn even_odd(material: &Isotropic, plane: Plane, zeta: f64) -> (Matrix4<f64>, Matrix4<f64>) {
    let unit = Isotropic { shear_modulus: 1.0, ..*material }.material(plane);
    let (c, d) = (unit.coupling, unit.normal_compliance);
    let q = 0.5 * unit.axial_stiffness; // 4/(κ + 1)
    let sinh = stable::sinh(zeta);
    let ch = stable::cosh_minus_one(zeta);
    let y = 0.5 * zeta * sinh;
    let w = 0.5 * stable::argument_cosh_minus_sinh(zeta);
    #[rustfmt::skip]
    let even = Matrix4::new(
        ch + q * y,    0.0,            0.5 * q * y,   0.0,
        0.0,           ch - q * y,     0.0,           -0.5 * q * y,
        -2.0 * q * y,  0.0,            ch - q * y,    0.0,
        0.0,           2.0 * q * y,    0.0,           ch + q * y,
    );
    #[rustfmt::skip]
    let odd = Matrix4::new(
        0.0,                   sinh + q * w,  0.0,                   sinh + 0.5 * q * w,
        -(c * sinh + q * w),   0.0,           d * sinh - 0.5 * q * w, 0.0,
        0.0,                   -2.0 * q * w,  0.0,                   -(sinh + q * w),
        2.0 * q * (sinh + w),  0.0,           c * sinh + q * w,      0.0,
    );
    (even, odd)
}

/// Amplitudes = two solutions that decay from the top face and two that decay from the bottom face.
fn thick(material: &Isotropic, wave: &Wave, depth: f64) -> FaceStates {
    let [a, b] = decaying_downwards(material, wave, 0.0);
    let [c, d] = decaying_upwards(material, wave, depth);
    let top = Matrix4::from_columns(&[a, b, c, d]);
    let [a, b] = decaying_downwards(material, wave, depth);
    let [c, d] = decaying_upwards(material, wave, 0.0);
    let bottom = Matrix4::from_columns(&[a, b, c, d]);
    FaceStates::thick(top, bottom)
}

/// The same at a depth, times λ, below the top face.
fn thick_inside(material: &Isotropic, wave: &Wave, below: f64, thickness: f64) -> InnerStates {
    let [a, b] = decaying_downwards(material, wave, below);
    let [c, d] = decaying_upwards(material, wave, thickness - below);
    InnerStates::thick(Matrix4::from_columns(&[a, b, c, d]))
}
