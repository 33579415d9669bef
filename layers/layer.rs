//! The trait `Layer` and nothing else.
use std::any::Any;
use std::fmt::Debug;
use std::sync::Arc;

use crate::{FaceStates, Flexibility, Key, LayerStates, Material, Notation, Plane, Wave};

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
/// 1. **Same thing.** A closed form must agree with what the material gives, for λh from 1e-8 to 1e8 to eleven digits, and
///    layers with equal [keys](Layer::key) with each other.
/// 2. **No time, no state.** The same question always gets the same answer.
/// 3. **Elastic.** All four coefficients of the [`Material`] are finite, `shear_compliance` and `axial_stiffness` are
///    positive, and `coupling`² + `axial_stiffness` · `normal_compliance` is.
/// 4. **No overflow.** Face states are finite for any wavenumber; amplitudes are the layer's own choice, so that
///    solutions that grow with e^(λh) can be measured where they are 1.
///
/// [`conformance`](crate::conformance) puts these laws, and what mechanics concludes from them, to any layer; one line,
/// [`layer_laws!`](crate::layer_laws), makes tests of them.
///
/// # When to offer a closed form
///
/// [`face_states`](#method.face_states) integrates the state equations, to twelve digits. A stack remembers
/// what it has integrated, and then needs some ten microseconds per wavenumber. Offer a [`ClosedForm`] by
/// [`closed_form`](Layer::closed_form) where there is one *that keeps its digits at both ends*: for λh → 0, where a free layer
/// bends with λ⁻⁴, and for λh → ∞, where only decaying exponentials may be formed. Nobody but the layer's own
/// `closed_form` decides which is used: what is asked of a layer, [`face_states`](#method.face_states),
/// [`states`](#method.states) and [`flexibility`](#method.flexibility) of `dyn Layer`, cannot be overridden.
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

    /// How the layer is written in drawings, messages and scene files; provided: the name of the type, and the thickness.
    fn notation(&self) -> Notation {
        let notation = Notation::of::<Self>();
        match self.thickness() {
            Some(thickness) => notation.with("thickness", &thickness),
            None => notation,
        }
    }

    /// Depths, in any order, at which the material is not smooth; provided: none.
    fn kinks(&self) -> Vec<f64> {
        Vec::new()
    }

    /// The layer itself, if its fields are known in closed form; `None`, as is provided, leaves them to the general body,
    /// of which a stack keeps what it computes, see [`crate::graded::Remembering`].
    fn closed_form(&self) -> Option<&dyn ClosedForm> {
        None
    }

    /// What tells this layer from others: its type and all of its parameters. A stack evaluates sequences of layers that are
    /// repeated only once. Provided: `None`, it is the same as no other.
    fn key(&self) -> Option<Key> {
        None
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

    /// The strain that the layer would have in all directions if nothing held it, dimensionless; provided: 0. See [`Loaded`](crate::Loaded).
    fn eigenstrain(&self) -> f64 {
        0.0
    }

    /// The weight of the layer, force per volume, positive downwards; provided: 0. See [`Loaded`](crate::Loaded).
    fn specific_weight(&self) -> f64 {
        0.0
    }

    /// The name of the layer in reports and pictures; provided: none. See [`Loaded`](crate::Loaded).
    fn name(&self) -> Option<&str> {
        None
    }

    /// Whether the material is the same in all directions along the layer, as it has to be about the axis of an axisymmetric problem. The
    /// default holds for isotropic materials: the coefficients of others do not tell.
    fn is_same_all_around(&self) -> bool {
        let thickness = self.thickness().unwrap_or(0.0);
        [0.0, 0.5, 1.0].into_iter().all(|part| self.material(part * thickness, Plane::Strain).is_isotropic())
    }
}

/// Fields of a layer in closed form, in place of the general body.
///
/// Only [`face_states`](ClosedForm::face_states) is required. [`conformance`](crate::conformance) compares each of these with
/// what the material gives.
pub trait ClosedForm {
    /// States at the faces as functions of the layer's amplitudes.
    fn face_states(&self, wave: &Wave) -> FaceStates;

    /// States at the faces and at `depths` below the top face, in ascending order from 0 to the thickness, in amplitudes
    /// common to all of them, which need not be the amplitudes of [`face_states`](ClosedForm::face_states): what the fields inside a
    /// stack are made of. `None`, as is provided, leaves them to the general body.
    fn states(&self, wave: &Wave, depths: &[f64]) -> Option<LayerStates> {
        let _ = (wave, depths);
        None
    }

    /// Flexibility of the layer alone with shear-free faces, e.g. for the symmetric and the antisymmetric load of a
    /// homogeneous strip; provided by solving for it with the face states.
    fn flexibility(&self, wave: &Wave) -> Option<Flexibility> {
        Flexibility::of_face_states(&self.face_states(wave))
    }
}
