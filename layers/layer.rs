//! The trait `Layer` and nothing else.
use std::any::Any;
use std::fmt::Debug;

use crate::{FaceStates, Flexibility, LayerStates, Material, Plane, Wave, graded};

/// How a layer is written in the printed block matrix: symbols only, no numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notation {
    /// Name of the layer type, e.g. `Homogeneous`.
    pub kind: &'static str,
    /// The parameters with their values, as in the scene file, e.g. `thickness: 1.0, shear_modulus: 1.0, poisson: 0.25`.
    pub parameters: String,
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
/// [`thickness`](Layer::thickness), [`material`](Layer::material) and [`notation`](Layer::notation). These make a layer
/// complete: the rest follows from the material.
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
/// The provided [`face_states`](Layer::face_states) integrates the state equations: some microseconds for a thin
/// layer, about a millisecond for a thick one, and twelve digits. Override it when there is a closed form *that
/// keeps its digits at both ends*: for λh → 0, where a free layer bends with λ⁻⁴, and for λh → ∞, where only decaying
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
/// use recede_layers::{Isotropic, Layer, Material, Notation, Plane, conformance};
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
///
///     fn notation(&self) -> Notation {
///         let Self { thickness, face_modulus, exponent } = self;
///         let parameters = format!("thickness: {thickness:?}, face_modulus: {face_modulus:?}, exponent: {exponent:?}");
///         Notation { kind: "PowerLaw", parameters }
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
    /// It should be smooth in the depth. Jumps are found, but cost time: two layers are better.
    fn material(&self, depth: f64, plane: Plane) -> Material;

    /// How the layer is written in the printed block matrix.
    fn notation(&self) -> Notation;

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
