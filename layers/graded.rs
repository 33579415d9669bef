//! The general body: face states of any layer from its [`Material`] alone, by integrating the state equations.
//!
//! The layer is cut into slices, so thin that the wave (λδ) and the material hardly change in one. A slice's transfer
//! matrix, less identity, is a power series in λδ from Picard iteration on Gauss points: every entry keeps its own order
//! in λδ, and with it all its digits. Slices are halves of halves of the layer, and remembered, so that the next
//! wavenumber finds its matrices ready but for the sum of a series. Three ways lead from the slices to the faces:
//!
//! * *thin*: amplitudes = the state at one depth; the transfer matrices are multiplied as X − 1.
//! * *thick*: amplitudes = the stresses on one face while the other is clamped; the flexibility seen from a face is
//!   carried from slice to slice, so that nothing grows.
//! * *deep*: the faces do not feel each other; each is the surface of a half-plane.
//!
//! A layer that turns out to be homogeneous needs no slices unless it is thin: see `graded/homogeneous.rs`.
mod clamped;
mod homogeneous;
mod inside;
mod points;
mod remembering;
mod rule;
mod series;
mod slices;
mod surface;
mod thin;
mod tree;

pub(crate) use self::clamped::Clamped;
use self::homogeneous::Homogeneous;
pub use self::remembering::Remembering;
use self::rule::RULE;
pub(crate) use self::slices::inverse;
pub(crate) use self::surface::{surface_flexibility, surface_states};
use self::tree::From;
pub(crate) use self::tree::Tree;
use crate::{FaceStates, Flexibility, Layer, LayerStates, Material, Wave};

/// Up to this length, in decay lengths of the material, a layer is thin: it bends and translates almost freely.
const THIN: f64 = 1.25;
/// Beyond this length, in decay lengths, nothing is felt: e^(−2·30) is below rounding, squared once more.
const FELT: f64 = 30.0;

/// Face states of any layer, from [`Layer::thickness`] and [`Layer::material`]: the provided body of
/// `face_states` of `dyn Layer`, and what a [closed form](Layer::closed_form) is examined against.
///
/// Relative accuracy of the flexibility: 1e-12 for any λh and a smooth modulus that varies by up to e^±30; of the
/// response to equal loads 1e-10, or 1e-8 if the layer is as steep as that and incompressible. Jumps of the material
/// are found, at the cost of some fifty slices each; two layers are better. A feature much thinner than 1/(100 λ) and
/// than h/200 is found only where it meets a face.
///
/// ```
/// use recede_layers::{ClosedForm, Exponential, Flexibility, Plane, Wave, graded};
/// let layer = Exponential::new(1.0, 1.0, 0.25, -2.0)?;
/// let wave = Wave { wavenumber: 3.0, modulus: 1.0, plane: Plane::Strain };
/// let general = Flexibility::of_face_states(&graded::face_states(&layer, &wave)).expect("has two faces");
/// let closed_form = layer.flexibility(&wave).expect("has two faces");
/// assert!((general.top / closed_form.top - 1.0).abs() < 1e-12);
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
///
/// [`Remembering`] does the same for many wavenumbers, some fifty times faster.
pub fn face_states(layer: &(impl Layer + ?Sized), wave: &Wave) -> FaceStates {
    of_layer(layer, wave, &Tree::default())
}

/// `tree` has the parts of the layer in the plane of the wave.
pub(crate) fn of_layer(layer: &(impl Layer + ?Sized), wave: &Wave, tree: &Tree) -> FaceStates {
    let material = |depth| layer.material(depth, wave.plane);
    BodyProfile { thickness: layer.thickness(), material: &material, kinks: &layer.kinks() }.face_states(wave, tree)
}

/// Flexibility of any layer with shear-free faces; `None` for a half-plane, or if the layer's amplitudes do not determine its
/// state. Equal loads do not bend a homogeneous layer: their response then has no rounding error of bending.
pub fn flexibility(layer: &(impl Layer + ?Sized), wave: &Wave) -> Option<Flexibility> {
    flexibility_of_layer(layer, wave, &Tree::default())
}

/// `tree` has the parts of the layer in the plane of the wave.
pub(crate) fn flexibility_of_layer(layer: &(impl Layer + ?Sized), wave: &Wave, tree: &Tree) -> Option<Flexibility> {
    let material = |depth| layer.material(depth, wave.plane);
    let profile = BodyProfile { thickness: layer.thickness(), material: &material, kinks: &layer.kinks() };
    match profile.homogeneous(wave, tree) {
        Some(homogeneous) => Some(homogeneous.flexibility()),
        None => Flexibility::of_face_states(&profile.face_states(wave, tree)),
    }
}

/// States of any layer at its faces and at `depths` in ascending order, in common amplitudes: the provided body of
/// `states` of `dyn Layer`. Slices end at these depths, so that their number adds to the cost.
pub fn states(layer: &(impl Layer + ?Sized), wave: &Wave, depths: &[f64]) -> LayerStates {
    states_of_layer(layer, wave, &Tree::default(), depths, depths)
}

/// `tree` has the parts of the layer in the plane of the wave, cut at `cuts`, of which `depths` are some.
pub(crate) fn states_of_layer(
    layer: &(impl Layer + ?Sized),
    wave: &Wave,
    tree: &Tree,
    cuts: &[f64],
    depths: &[f64],
) -> LayerStates {
    let material = |depth| layer.material(depth, wave.plane);
    let cuts = [&layer.kinks(), cuts].concat();
    BodyProfile { thickness: layer.thickness(), material: &material, kinks: &cuts }.states(wave, tree, depths)
}

/// All that the general body knows of a layer.
#[derive(Clone, Copy)]
pub(crate) struct BodyProfile<'a> {
    /// As [`Layer::thickness`].
    pub thickness: Option<f64>,
    /// The material at a depth.
    pub material: &'a dyn Fn(f64) -> Material,
    /// As [`Layer::kinks`].
    pub kinks: &'a [f64],
}

impl BodyProfile<'_> {
    /// `tree` is this profile's own.
    pub(crate) fn face_states(&self, wave: &Wave, tree: &Tree) -> FaceStates {
        self.states(wave, tree, &[]).faces
    }

    /// The layer, if it is homogeneous and has a thickness.
    fn homogeneous<'t>(&self, wave: &Wave, tree: &'t Tree) -> Option<Homogeneous<'t>> {
        let thickness = self.thickness.filter(|thickness| *thickness > 0.0)?;
        Some(Homogeneous::new(tree.material(self)?, wave, thickness))
    }

    /// ∫ f dy over the thickness for each of the functions of (material, depth), with the points that resolve the
    /// material; zero for a half-plane.
    pub(crate) fn integrate<const N: usize>(&self, f: impl Fn(&Material, f64) -> [f64; N]) -> [f64; N] {
        let mut sums = [0.0; N];
        if self.thickness.is_none() {
            return sums;
        }
        Tree::default().parts(self, 0.0, From::Top, |part| {
            for (t, weight) in RULE.nodes.iter().zip(RULE.weights.iter()) {
                let depth = part.depth(*t);
                for (sum, value) in sums.iter_mut().zip(f(&(self.material)(depth), depth)) {
                    *sum += weight * part.thickness * value;
                }
            }
            true
        });
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::clamped::Seen;
    use super::*;
    use crate::{Isotropic, Plane};

    fn wave(wavenumber: f64) -> Wave {
        Wave { wavenumber, modulus: 1.0, plane: Plane::Strain }
    }

    fn isotropic(shear_modulus: f64) -> Material {
        Isotropic { shear_modulus, poisson: 0.3 }.material(Plane::Strain)
    }

    #[test]
    fn a_jump_of_the_material_is_found() {
        let jump = 0.3;
        let material = |depth: f64| isotropic(if depth < jump { 1.0 } else { 10.0 });
        let profile = BodyProfile { thickness: Some(1.0), material: &material, kinks: &[] };
        let [stiffness] = profile.integrate(|m, _| [m.axial_stiffness]);
        let expected = isotropic(jump + 10.0 * (1.0 - jump)).axial_stiffness;
        assert!((stiffness / expected - 1.0).abs() < 1e-13);
    }

    #[test]
    fn a_material_without_any_order_ends() {
        let material = |depth: f64| isotropic(1.5 + (1e9 * depth).sin());
        let profile = BodyProfile { thickness: Some(1.0), material: &material, kinks: &[] };
        let states = profile.face_states(&wave(1.0), &Tree::default());
        assert!(Flexibility::of_face_states(&states).is_some());
    }

    #[test]
    fn a_half_plane_that_stiffens_is_a_layer_on_rigid_ground() {
        // μ = e^(βd), so soft at the face that waves longer than 1/β feel nothing of it but its compression
        let material = |depth: f64| isotropic((5.0 * depth).exp());
        for wavenumber in [1e-8, 1e-3, 1.0, 10.0] {
            let half_plane = BodyProfile { thickness: None, material: &material, kinks: &[] };
            let FaceStates::HalfPlane { top } = half_plane.face_states(&wave(wavenumber), &Tree::default()) else {
                panic!("one face")
            };
            let rigid = BodyProfile { thickness: Some(14.0), material: &material, kinks: &[] };
            let seen = rigid
                .slices(&Tree::default(), wavenumber, From::Top, FELT)
                .list
                .iter()
                .rev()
                .fold(Seen::clamped(), |seen, slice| seen.through(&slice.transfer));
            assert!((top - seen.states()).amax() < 1e-13 * top.amax(), "{wavenumber} {top} {}", seen.states());
        }
    }

    #[test]
    fn no_thickness_is_no_layer() {
        let nothing = crate::Homogeneous::new(0.0, 1.0, 0.25).expect("legal");
        let FaceStates::Finite { top, bottom, .. } = face_states(&nothing, &wave(1.0)) else { panic!("two faces") };
        assert_eq!(top, bottom);
    }
}
