//! An isotropic layer graded in any way, left to the general body.
use std::fmt;
use std::sync::Arc;

#[cfg(feature = "read")]
use schemars::JsonSchema;
use serde::Deserialize;

use crate::{
    Identity, Isotropic, Key, Layer, LayerError, Material, Notation, Parameter, Plane, Poisson, Positive, Profile,
    Thickness, material::Modulus,
};

/// Layers whose modulus varies by a larger factor are refused: digits would be lost where they are soft.
const MOST: f64 = 1e13;

/// Isotropic layer whose shear modulus, and Poisson's ratio too if need be, vary with depth.
///
/// ```
/// use recede_layers::{Graded, Isotropic, Layer, Plane, Profile};
/// let powdery = Graded::new(1.0, Profile::power(1.0, 0.5, 2.0)?, Profile::linear(0.2, 0.4)?)?;
/// let function = Graded::with(1.0, |depth| Isotropic {
///     shear_modulus: (1.0 + 2.0 * depth).powi(2),
///     poisson: 0.2 + 0.2 * depth,
/// })?;
/// let [a, b] = [&powdery, &function].map(|layer| layer.material(0.5, Plane::Strain).axial_stiffness);
/// assert!((a / b - 1.0).abs() < 1e-15);
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Deserialize)]
#[serde(try_from = "GradedFields")]
pub struct Graded {
    thickness: Thickness,
    variation: Variation,
}

#[derive(Clone)]
enum Variation {
    Written {
        modulus: Modulus<Profile<Positive>>,
        poisson: Profile<Poisson>,
    },
    /// Functions cannot be compared: each is the same as itself only.
    Function(Identity, Arc<dyn Fn(f64) -> Isotropic + Send + Sync>),
}

/// The fields as written in a scene, before they are checked together.
#[derive(Deserialize)]
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(deny_unknown_fields, rename = "Graded")]
struct GradedFields {
    /// Thickness h, in length.
    thickness: Thickness,
    /// Shear modulus as a function of the depth d, in stress; or in its place `young`.
    #[serde(default)]
    shear_modulus: Option<Profile<Positive>>,
    /// Young's modulus as a function of the depth d, in stress; or in its place `shear_modulus`.
    #[serde(default)]
    young: Option<Profile<Positive>>,
    /// Poisson's ratio, if it is the same at any depth.
    #[serde(default)]
    poisson: Option<Poisson>,
    /// Poisson's ratio as a function of depth, in place of `poisson`.
    #[serde(default)]
    poisson_profile: Option<Profile<Poisson>>,
}

#[cfg(feature = "read")]
described!(Graded by GradedFields);

impl TryFrom<GradedFields> for Graded {
    type Error = LayerError;

    fn try_from(fields: GradedFields) -> Result<Self, LayerError> {
        let GradedFields { thickness, shear_modulus, young, poisson, poisson_profile } = fields;
        let modulus = Modulus::one_of(shear_modulus, young)?;
        let poisson = match (poisson, poisson_profile) {
            (Some(constant), None) => Profile::Constant(constant),
            (None, Some(profile)) => profile,
            (one, _) => {
                let fields = ["poisson", "poisson_profile"];
                return Err(LayerError::EitherOr { found: one.map_or("none", |_| "both"), fields });
            }
        };
        Self::checked(thickness, modulus, poisson)
    }
}

/// What stands for a function, which has no text.
struct Function;

impl Parameter for Function {
    fn written(&self) -> String {
        "a function".to_owned()
    }
}

impl Graded {
    /// A layer of thickness h ≥ 0 (length; 0 means "not there"), with shear modulus μ(d) > 0 (stress) and Poisson's ratio
    /// −1 < ν(d) ≤ 1/2 as functions of depth.
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite, anywhere in the layer; if a table does not reach its
    /// bottom; if the modulus varies by a factor of more than 1e13.
    pub fn new(
        thickness: f64,
        shear_modulus: Profile<Positive>,
        poisson: Profile<Poisson>,
    ) -> Result<Self, LayerError> {
        Self::checked(LayerError::checked("thickness", thickness)?, Modulus::Shear(shear_modulus), poisson)
    }

    /// A layer of thickness h ≥ 0 (length) whose material is a function of the depth below its top face. The function is
    /// to be smooth, and legal: a Poisson's ratio of 0.6, say, is not found out.
    ///
    /// # Errors
    /// [`LayerError`] if the thickness is negative or not finite.
    pub fn with(
        thickness: f64,
        material: impl Fn(f64) -> Isotropic + Send + Sync + 'static,
    ) -> Result<Self, LayerError> {
        let thickness = LayerError::checked("thickness", thickness)?;
        Ok(Self { thickness, variation: Variation::Function(Identity::unique(), Arc::new(material)) })
    }

    fn checked(
        thickness: Thickness,
        modulus: Modulus<Profile<Positive>>,
        poisson: Profile<Poisson>,
    ) -> Result<Self, LayerError> {
        let (field, profile) = modulus.field();
        let [least, most] = profile.extremes(field, thickness.get())?;
        let ratios = poisson.extremes("poisson", thickness.get())?;
        // bounds of the shear modulus, wherever in the layer they may be met
        let [low, high] = ratios;
        let [least, most] =
            [(least, high), (most, low)].map(|(value, ratio)| modulus.isotropic(value, ratio).shear_modulus);
        if most / least > MOST {
            return Err(LayerError::VariesTooMuch { found: most / least, limit: MOST });
        }
        Ok(Self { thickness, variation: Variation::Written { modulus, poisson } })
    }
}

impl fmt::Debug for Graded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.notation())
    }
}

impl Layer for Graded {
    fn thickness(&self) -> Option<f64> {
        Some(self.thickness.get())
    }

    fn material(&self, depth: f64, plane: Plane) -> Material {
        let thickness = self.thickness.get();
        match &self.variation {
            Variation::Written { modulus, poisson } => {
                modulus.isotropic(modulus.field().1.at(depth, thickness), poisson.at(depth, thickness))
            }
            Variation::Function(_, material) => material(depth),
        }
        .material(plane)
    }

    fn kinks(&self) -> Vec<f64> {
        let thickness = self.thickness.get();
        match &self.variation {
            Variation::Written { modulus, poisson } => {
                [modulus.field().1.kinks(thickness), poisson.kinks(thickness)].concat()
            }
            Variation::Function(..) => Vec::new(),
        }
    }

    fn notation(&self) -> Notation {
        let notation = Notation::of::<Self>().with("thickness", &self.thickness);
        match &self.variation {
            Variation::Written { modulus, poisson } => {
                let (name, profile) = modulus.field();
                let notation = notation.with(name, profile);
                match poisson {
                    Profile::Constant(poisson) => notation.with("poisson", poisson),
                    profile => notation.with("poisson_profile", profile),
                }
            }
            Variation::Function(..) => notation.with("material", &Function),
        }
    }

    /// Two functions are known to be the same only if they are one object.
    fn key(&self) -> Option<Key> {
        let key = Key::of::<Self>().with([self.thickness.get()]);
        Some(match &self.variation {
            Variation::Written { modulus, poisson } => {
                let kind = if let Modulus::Shear(_) = modulus { 0.0 } else { 1.0 };
                poisson.keyed(modulus.field().1.keyed(key.with([kind])))
            }
            Variation::Function(identity, _) => key.with_identity(*identity),
        })
    }
}
