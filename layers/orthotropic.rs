//! Orthotropic material with axes along and across the layers: a homogeneous layer, and a half-plane.
use std::any::Any;
use std::sync::Arc;

use nalgebra::Matrix4;
#[cfg(feature = "read")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::graded::surface_states;
use crate::{
    ClosedForm, FaceStates, Finite, InnerStates, Key, Layer, LayerError, LayerStates, Material, Notation, Parameter,
    Plane, Positive, Thickness, Wave,
};

/// By how much the determinant of a material on the verge of instability may be negative for rounding.
const ROUNDING: f64 = 1e-12;

/// Young's moduli of an orthotropic material: x along the layers, y across them, z out of the plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Young {
    /// E_x, in stress.
    pub x: Positive,
    /// E_y, in stress.
    pub y: Positive,
    /// E_z, in stress; it matters in plane strain only.
    pub z: Positive,
}

/// Poisson's ratios of an orthotropic material: ν_ij is −ε_j/ε_i under a stress along i, so that ν_ij/E_i = ν_ji/E_j.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PoissonRatios {
    /// ν_xy, dimensionless.
    pub xy: Finite,
    /// ν_xz, dimensionless; it matters in plane strain only.
    pub xz: Finite,
    /// ν_yz, dimensionless; it matters in plane strain only.
    pub yz: Finite,
}

impl Parameter for Young {
    fn written(&self) -> String {
        let Self { x, y, z } = self;
        format!("(x: {}, y: {}, z: {})", x.written(), y.written(), z.written())
    }
}

impl Parameter for PoissonRatios {
    fn written(&self) -> String {
        let Self { xy, xz, yz } = self;
        format!("(xy: {}, xz: {}, yz: {})", xy.written(), xz.written(), yz.written())
    }
}

/// The engineering constants of an orthotropic material.
///
/// ```
/// use recede_layers::{EngineeringConstants, Isotropic, Plane};
/// let (mu, nu) = (80.0, 0.25);
/// let young = 2.0 * mu * (1.0 + nu);
/// let steel = EngineeringConstants::new([young; 3], [nu; 3], mu)?.material(Plane::Strain);
/// let isotropic = Isotropic::new(mu, nu)?.material(Plane::Strain);
/// assert!((steel.axial_stiffness / isotropic.axial_stiffness - 1.0).abs() < 1e-15);
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EngineeringConstants {
    young: Young,
    poisson: PoissonRatios,
    shear_modulus: Positive,
}

/// Moduli that differ by less, in parts of their size, are the same.
const SAME: f64 = 1e-9;

impl EngineeringConstants {
    /// Young's moduli E_x, E_y, E_z > 0 (stress), Poisson's ratios ν_xy, ν_xz, ν_yz and the shear modulus G_xy > 0
    /// (stress).
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite, or if some deformation of the material would set
    /// energy free.
    pub fn new(young: [f64; 3], poisson: [f64; 3], shear_modulus: f64) -> Result<Self, LayerError> {
        let [x, y, z] = young.map(|value| LayerError::checked("young", value));
        let [xy, xz, yz] = poisson.map(|value| LayerError::checked("poisson", value));
        let shear_modulus = LayerError::checked("shear_modulus", shear_modulus)?;
        Self {
            young: Young { x: x?, y: y?, z: z? },
            poisson: PoissonRatios { xy: xy?, xz: xz?, yz: yz? },
            shear_modulus,
        }
        .check()
    }

    /// The coefficients of the state equations.
    pub fn material(&self, plane: Plane) -> Material {
        let ([ex, ey, ez], [xy, xz, yz]) = self.numbers();
        // strains (x, y) from stresses: in plane strain σ_zz adds its share
        let share = if plane == Plane::Strain { ez } else { 0.0 };
        let along = (1.0 - xz * xz * share / ex) / ex;
        let across = (1.0 - yz * yz * share / ey) / ey;
        let mixed = (xy + xz * yz * share / ey) / ex;
        Material {
            shear_compliance: self.shear_modulus.get().recip(),
            // zero, and no less, if incompressible
            normal_compliance: (across - mixed * (mixed / along)).max(0.0),
            coupling: mixed / along,
            axial_stiffness: along.recip(),
            // ε_zz = σ_zz/E_z − ν_xz σ_xx/E_x − ν_yz σ_yy/E_y is 0 in plane strain
            out_of_plane: Some([xz * share / ex, yz * share / ey]),
        }
    }

    fn noted(&self, notation: Notation) -> Notation {
        let Self { young, poisson, shear_modulus } = self;
        notation.with("young", young).with("poisson", poisson).with("shear_modulus", shear_modulus)
    }

    fn keyed(&self, key: Key) -> Key {
        let (young, poisson) = self.numbers();
        key.with(young).with(poisson).with([self.shear_modulus.get()])
    }

    fn numbers(&self) -> ([f64; 3], [f64; 3]) {
        let Self { young, poisson, .. } = self;
        ([young.x, young.y, young.z].map(Positive::get), [poisson.xy, poisson.xz, poisson.yz].map(Finite::get))
    }

    /// Whether x and z cannot be told apart: E_x = E_z and ν_xy/E_x = ν_zy/E_z.
    fn is_same_all_around(&self) -> bool {
        let ([ex, ey, ez], [xy, _, yz]) = self.numbers();
        (ex - ez).abs() <= SAME * ex && (xy * ey - yz * ex).abs() <= SAME * ex
    }

    /// Any deformation takes work, or at least, like a pure change of volume of an incompressible material, gives none back.
    fn check(self) -> Result<Self, LayerError> {
        let ([ex, ey, ez], [xy, xz, yz]) = self.numbers();
        for (field, found, ratio) in
            [("poisson.xy", xy, ex / ey), ("poisson.xz", xz, ex / ez), ("poisson.yz", yz, ey / ez)]
        {
            if found * found >= ratio {
                return Err(LayerError::Unstable { field, found, limit: ratio.sqrt() });
            }
        }
        let squares = xy * xy * ey / ex + yz * yz * ez / ey + xz * xz * ez / ex;
        let found = 1.0 - squares - 2.0 * xy * yz * xz * ez / ex;
        if found >= -ROUNDING { Ok(self) } else { Err(LayerError::NegativeEnergy { found }) }
    }
}

/// Homogeneous orthotropic layer with axes along and across it.
///
/// It is left to the general body, in which roots that coincide, as the roots of an isotropic material do, are nothing special.
///
/// ```
/// use recede_layers::{EngineeringConstants, Layer, Orthotropic};
/// let ply = EngineeringConstants::new([140.0, 10.0, 10.0], [0.3, 0.3, 0.4], 5.0)?;
/// assert_eq!(Orthotropic::new(0.125, ply)?.thickness(), Some(0.125));
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(try_from = "LayerFields")]
pub struct Orthotropic {
    thickness: Thickness,
    young: Young,
    poisson: PoissonRatios,
    shear_modulus: Positive,
}

/// The fields as written in a scene, before they are checked together.
#[derive(Deserialize)]
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(deny_unknown_fields, rename = "Orthotropic")]
struct LayerFields {
    /// Thickness h, in length.
    thickness: Thickness,
    /// Young's moduli.
    young: Young,
    /// Poisson's ratios.
    poisson: PoissonRatios,
    /// Shear modulus G_xy, in stress.
    shear_modulus: Positive,
}

impl TryFrom<LayerFields> for Orthotropic {
    type Error = LayerError;

    fn try_from(fields: LayerFields) -> Result<Self, LayerError> {
        let LayerFields { thickness, young, poisson, shear_modulus } = fields;
        Ok(Self::of(thickness, EngineeringConstants { young, poisson, shear_modulus }.check()?))
    }
}

impl Orthotropic {
    /// A layer of thickness h ≥ 0 (length; 0 means "not there").
    ///
    /// # Errors
    /// [`LayerError`] if the thickness is negative or not finite.
    pub fn new(thickness: f64, constants: EngineeringConstants) -> Result<Self, LayerError> {
        Ok(Self::of(LayerError::checked("thickness", thickness)?, constants))
    }

    fn of(thickness: Thickness, constants: EngineeringConstants) -> Self {
        let EngineeringConstants { young, poisson, shear_modulus } = constants;
        Self { thickness, young, poisson, shear_modulus }
    }

    fn constants(&self) -> EngineeringConstants {
        let Self { young, poisson, shear_modulus, .. } = *self;
        EngineeringConstants { young, poisson, shear_modulus }
    }
}

impl Layer for Orthotropic {
    fn thickness(&self) -> Option<f64> {
        Some(self.thickness.get())
    }

    fn material(&self, _depth: f64, plane: Plane) -> Material {
        self.constants().material(plane)
    }

    fn is_same_all_around(&self) -> bool {
        self.constants().is_same_all_around()
    }

    fn notation(&self) -> Notation {
        self.constants().noted(Notation::of::<Self>().with("thickness", &self.thickness))
    }

    fn key(&self) -> Option<Key> {
        Some(self.constants().keyed(Key::of::<Self>().with([self.thickness.get()])))
    }

    fn continues(&self, below: &dyn Layer) -> Option<Arc<dyn Layer>> {
        let below: &dyn Any = below;
        if let Some(other) = below.downcast_ref::<Self>() {
            let thickness = Thickness::try_from(self.thickness.get() + other.thickness.get()).ok()?;
            let whole = Self { thickness, ..*self };
            return (whole == Self { thickness, ..*other }).then(|| Arc::new(whole) as _);
        }
        let own = OrthotropicHalfPlane::new(self.constants());
        below.downcast_ref::<OrthotropicHalfPlane>().filter(|ground| **ground == own).map(|_| Arc::new(own) as _)
    }
}

/// Homogeneous orthotropic half-plane with axes along and across its face.
///
/// ```
/// use recede_layers::{EngineeringConstants, OrthotropicHalfPlane};
/// let wood = OrthotropicHalfPlane::new(EngineeringConstants::new([12.0, 0.8, 0.5], [0.4, 0.45, 0.6], 0.7)?);
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(try_from = "HalfPlaneFields")]
pub struct OrthotropicHalfPlane {
    young: Young,
    poisson: PoissonRatios,
    shear_modulus: Positive,
}

/// The fields as written in a scene, before they are checked together.
#[derive(Deserialize)]
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(deny_unknown_fields, rename = "OrthotropicHalfPlane")]
struct HalfPlaneFields {
    /// Young's moduli.
    young: Young,
    /// Poisson's ratios.
    poisson: PoissonRatios,
    /// Shear modulus G_xy, in stress.
    shear_modulus: Positive,
}

impl TryFrom<HalfPlaneFields> for OrthotropicHalfPlane {
    type Error = LayerError;

    fn try_from(fields: HalfPlaneFields) -> Result<Self, LayerError> {
        let HalfPlaneFields { young, poisson, shear_modulus } = fields;
        Ok(Self::new(EngineeringConstants { young, poisson, shear_modulus }.check()?))
    }
}

impl OrthotropicHalfPlane {
    /// A half-plane of this material.
    pub fn new(constants: EngineeringConstants) -> Self {
        let EngineeringConstants { young, poisson, shear_modulus } = constants;
        Self { young, poisson, shear_modulus }
    }

    fn constants(&self) -> EngineeringConstants {
        let Self { young, poisson, shear_modulus } = *self;
        EngineeringConstants { young, poisson, shear_modulus }
    }
}

impl Layer for OrthotropicHalfPlane {
    fn thickness(&self) -> Option<f64> {
        None
    }

    fn material(&self, _depth: f64, plane: Plane) -> Material {
        self.constants().material(plane)
    }

    fn closed_form(&self) -> Option<&dyn ClosedForm> {
        Some(self)
    }

    fn is_same_all_around(&self) -> bool {
        self.constants().is_same_all_around()
    }

    fn notation(&self) -> Notation {
        self.constants().noted(Notation::of::<Self>())
    }

    fn key(&self) -> Option<Key> {
        Some(self.constants().keyed(Key::of::<Self>()))
    }
}

impl ClosedForm for OrthotropicHalfPlane {
    /// Amplitudes = (S, T) on the face.
    fn face_states(&self, wave: &Wave) -> FaceStates {
        FaceStates::HalfPlane { top: surface_states(&self.material(0.0, wave.plane), wave.modulus, 0.0) }
    }

    fn states(&self, wave: &Wave, depths: &[f64]) -> Option<LayerStates> {
        let material = self.material(0.0, wave.plane);
        let inside = depths.iter().map(|depth| {
            let states = surface_states(&material, wave.modulus, wave.wavenumber * depth);
            InnerStates::thick(Matrix4::from_fn(|i, j| if j < 2 { states[(i, j)] } else { 0.0 }))
        });
        Some(LayerStates { inside: inside.collect(), faces: self.face_states(wave) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Isotropic;

    #[test]
    fn isotropic_constants_are_those_of_an_isotropic_material() {
        for poisson in [-0.9, 0.0, 0.3, 0.499_999, 0.5] {
            for plane in [Plane::Strain, Plane::Stress] {
                let young = 2.0 * 3.0 * (1.0 + poisson);
                let found = EngineeringConstants::new([young; 3], [poisson; 3], 3.0).expect("legal").material(plane);
                let expected = Isotropic { shear_modulus: 3.0, poisson }.material(plane);
                for (a, b) in [
                    (found.shear_compliance, expected.shear_compliance),
                    (found.normal_compliance, expected.normal_compliance),
                    (found.coupling, expected.coupling),
                    (found.axial_stiffness / 9.0, expected.axial_stiffness / 9.0),
                    (found.out_of_plane.unwrap()[0], expected.out_of_plane.unwrap()[0]),
                    (found.out_of_plane.unwrap()[1], expected.out_of_plane.unwrap()[1]),
                ] {
                    assert!((a - b).abs() < 2e-15 * (1.0 + b.abs()), "{poisson} {plane:?} {a} {b}");
                }
            }
        }
    }

    #[test]
    fn impossible_materials_are_refused() {
        for (young, poisson, message) in [
            ([1.0, 1.0, 1.0], [1.0, 0.0, 0.0], "poisson.xy: found 1.0, allowed is -1.0 < poisson.xy < 1.0"),
            ([4.0, 1.0, 1.0], [2.5, 0.0, 0.0], "poisson.xy: found 2.5, allowed is -2.0 < poisson.xy < 2.0"),
            ([1.0, 1.0, 1.0], [0.6, 0.6, 0.6], "these Poisson's ratios together"),
        ] {
            let error = EngineeringConstants::new(young, poisson, 1.0).expect_err("unstable").to_string();
            assert!(error.starts_with(message), "{error}");
        }
    }
}
