//! The trait `Layer` and nothing else.
use std::any::Any;
use std::fmt::Debug;
use std::sync::Arc;

use crate::{FaceStates, Flexibility, LayerStates, Material, Plane, Wave, graded};

/// How a layer is written in drawings and messages.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notation {
    /// Name of the layer type, e.g. `Homogeneous`.
    pub kind: &'static str,
    /// The parameters with their values, as in the scene file, e.g. `thickness: 1.0, shear_modulus: 1.0, poisson: 0.25`.
    pub parameters: String,
}

impl Notation {
    /// The name of the type, and its fields as [`Debug`] tells them: a layer whose fields are those of the scene file is
    /// written as there.
    ///
    /// ```
    /// use recede_layers::{Homogeneous, Notation};
    /// let notation = Notation::of(&Homogeneous::new(1.0, 1.0, 0.25)?);
    /// assert_eq!(notation.kind, "Homogeneous");
    /// assert_eq!(notation.parameters, "thickness: 1.0, shear_modulus: 1.0, poisson: 0.25");
    /// # Ok::<(), recede_layers::LayerError>(())
    /// ```
    pub fn of<L: Debug + ?Sized>(layer: &L) -> Self {
        let path = std::any::type_name::<L>();
        let path = path.split_once('<').map_or(path, |(path, _)| path);
        let fields = format!("{layer:?}").replace(" { ", "(").replace(" }", ")");
        let inside = fields.split_once('(').and_then(|(_, rest)| rest.strip_suffix(')')).unwrap_or_default();
        Self { kind: path.rsplit("::").next().unwrap_or(path), parameters: inside.to_owned() }
    }
}

/// An elastic layer, known to the solver only by its transformed fields.
///
/// A layer fills the strip between two planes, or everything below one, with an elastic material that may vary with
/// depth. It knows nothing of its neighbours, of loads or of contact. All that is ever asked of it is how the states
/// (λμ₀U, λμ₀V, S, T) at its faces depend on each other for one wavenumber λ; the conventions stand at the head of
/// the [crate].
///
/// # Required methods
///
/// [`thickness`](Layer::thickness) and [`material`](Layer::material). These make a layer complete: the rest follows from
/// the material.
///
/// # Laws
///
/// 1. **Same thing.** Whatever is overridden must agree with what is provided, for λh from 1e-8 to 1e8 to eleven
///    digits.
/// 2. **No time, no state.** The same question always gets the same answer.
/// 3. **Elastic.** All four coefficients of the [`Material`] are finite, `shear_compliance` and `axial_stiffness` are
///    positive, and `coupling`² + `axial_stiffness` · `normal_compliance` is.
/// 4. **No overflow.** Face states are finite for any wavenumber; amplitudes are the layer's own choice, so that
///    solutions that grow with e^(λh) can be measured where they are 1.
///
/// [`conformance`](crate::conformance) puts these laws, and what mechanics concludes from them, to any layer; one line,
/// [`layer_laws!`](crate::layer_laws), makes tests of them.
///
/// # When to override a provided method
///
/// The provided [`face_states`](Layer::face_states) integrates the state equations, to twelve digits. A stack remembers
/// what it has integrated, and then needs some ten microseconds per wavenumber. Override it, and
/// [`has_closed_form`](Layer::has_closed_form) with it, when there is a closed form *that keeps its digits at both ends*: for λh → 0, where a free layer bends with λ⁻⁴, and for λh → ∞, where only decaying
/// exponentials may be formed. Where there is a closed form of the [`flexibility`](Layer::flexibility) too, e.g. for
/// the symmetric and the antisymmetric load of a homogeneous strip, override it as well; else it is solved for.
///
/// Who overrides `face_states` and wants fields inside to be as fast overrides [`states`](Layer::states) too: the same
/// closed form at any depth.
///
/// # Example: a layer of one's own
///
/// A coating whose modulus falls from the face to a core like a power of the depth, and which is examined by all laws:
///
/// ```
/// use recede_layers::{Isotropic, Layer, Material, Plane, conformance};
///
/// /// μ(d) = μ_face (1 + d/h)^(−n).
/// #[derive(Debug)]
/// struct PowerLaw {
///     thickness: f64,
///     face_modulus: f64,
///     exponent: f64,
/// }
///
/// impl Layer for PowerLaw {
///     fn thickness(&self) -> Option<f64> {
///         Some(self.thickness)
///     }
///
///     fn material(&self, depth: f64, plane: Plane) -> Material {
///         let shear_modulus = self.face_modulus * (1.0 + depth / self.thickness).powf(-self.exponent);
///         Isotropic { shear_modulus, poisson: 0.3 }.material(plane)
///     }
/// }
///
/// let coating = PowerLaw { thickness: 0.2, face_modulus: 80e9, exponent: 2.5 };
/// assert_eq!(conformance::examine(&coating, Plane::Strain), Ok(()));
/// ```
///
/// An orthotropic material needs no other trait: `material` returns its four coefficients. To use the layer in scene
/// files, derive `serde::Deserialize` and hand it to [`Registry::register`](crate::Registry::register).
pub trait Layer: Debug + Send + Sync + Any {
    /// Thickness h ≥ 0, in length; `None` for a layer that fills everything below its top face.
    fn thickness(&self) -> Option<f64>;

    /// The material at `depth` below the top face, 0 ≤ depth ≤ thickness.
    ///
    /// It should be smooth in the depth, except at the [`kinks`](Layer::kinks). Jumps elsewhere are found, but cost time.
    fn material(&self, depth: f64, plane: Plane) -> Material;

    /// How the layer is written in drawings and messages; provided by [`Notation::of`], that is by [`Debug`].
    fn notation(&self) -> Notation {
        Notation::of(self)
    }

    /// Depths, in any order, at which the material is not smooth; provided: none.
    fn kinks(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Whether this is an elastic body, as is provided. A support such as springs, without a thickness, is none: it
    /// overrides [`face_states`](Layer::face_states), and its material is [`Material::NONE`].
    fn has_material(&self) -> bool {
        true
    }

    /// Whether [`face_states`](Layer::face_states) is overridden; if not, as is provided, a stack keeps what the general
    /// body computes of the layer, see [`graded::Remembering`].
    fn has_closed_form(&self) -> bool {
        false
    }

    /// This layer and the one bonded below it as one layer, if both are one body cut in two: it fills both and is, at any
    /// depth, of their material. A stack solves for one layer what is one; provided: nothing is known, `None`. The layer
    /// below may be a half-plane, and then so is the whole.
    ///
    /// ```
    /// use recede_layers::{HalfPlane, Homogeneous, Layer};
    /// let strip = Homogeneous::new(1.0, 80.0, 0.25)?;
    /// let whole = strip.continues(&Homogeneous::new(0.5, 80.0, 0.25)?).expect("one material");
    /// assert_eq!(whole.thickness(), Some(1.5));
    /// assert_eq!(strip.continues(&HalfPlane::new(80.0, 0.25)?).expect("one material").thickness(), None);
    /// assert!(strip.continues(&HalfPlane::new(80.0, 0.3)?).is_none());
    /// # Ok::<(), recede_layers::LayerError>(())
    /// ```
    fn continues(&self, below: &dyn Layer) -> Option<Arc<dyn Layer>> {
        let _ = below;
        None
    }

    /// Whether another layer is the same, wherever it lies: a stack evaluates sequences of layers that are repeated only once.
    /// Provided: nothing is known, `false`.
    fn is_like(&self, other: &dyn Layer) -> bool {
        let _ = other;
        false
    }

    /// States at the faces as functions of the layer's amplitudes; provided by [`graded::face_states`].
    fn face_states(&self, wave: &Wave) -> FaceStates {
        graded::face_states(self, wave)
    }

    /// States at the faces and at `depths` below the top face, in ascending order from 0 to the thickness, in amplitudes
    /// common to all of them: what the fields inside a stack are made of. The amplitudes need not be those of
    /// [`face_states`](Layer::face_states). Provided by [`graded::states`].
    fn states(&self, wave: &Wave, depths: &[f64]) -> LayerStates {
        graded::states(self, wave, depths)
    }

    /// Flexibility of the layer alone with shear-free faces; `None` for a half-plane, see [`Flexibility`]. Provided by
    /// solving for it with the face states.
    fn flexibility(&self, wave: &Wave) -> Option<Flexibility> {
        Flexibility::of_face_states(&self.face_states(wave))
    }
}
