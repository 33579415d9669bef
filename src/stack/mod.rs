//! A stack: the checked structure of a scene's layers and interfaces.
mod assemble;
mod builder;
mod contrast;
mod drawing;
mod error;
mod faces;
mod gaps;
mod joint;
mod key;
mod merged;
mod residual;
mod weight;

use std::sync::Arc;

use recede_layers::{Body, Isotropic, Layer, Plane, Support, layer_label};

pub use builder::StackBuilder;
pub use error::{StackError, StackProblem};
pub(crate) use gaps::{Dent, Gaps};
pub use joint::Joint;
pub(crate) use residual::{ResidualStrain, residual_stress};

use crate::geometry::Geometry;
use crate::scene::{Gap, Punch};
use crate::solution::Interface;

/// Largest number of layers in a stack, the half-plane and layers of thickness zero left out.
pub const MAX_LAYERS: usize = 5000;
/// Largest number of receding interfaces in a stack.
pub const MAX_RECEDING: usize = 32;

/// Largest ratio of two moduli in a stack, the punch included: diamond is some 1e12 times as stiff as the softest gels, and
/// beyond the inverse of rounding one body counts as rigid next to the other.
pub const MAX_CONTRAST: f64 = 1e15;

/// Layers in order, in groups that are joined to each other.
///
/// Receding interfaces divide a stack into free *laminates* and the *base*; a receding interface lies between
/// consecutive laminates, and between the last laminate and the base. Layers of thickness zero are dropped.
///
/// ```
/// use recede::{Exponential, HalfPlane, Homogeneous, Plane, Stack};
/// let stack = Stack::builder(Plane::Strain)
///     .layer(Homogeneous::new(1.0, 1.0, 0.25)?)
///     .bonded()
///     .layer(Exponential::new(1.0, 1.0, 0.25, -1.0)?)
///     .receding()
///     .layer(HalfPlane::new(1.0, 0.25)?)
///     .build()?;
/// assert_eq!(stack.laminates().len(), 1);
/// assert_eq!(stack.laminates()[0].layers().len(), 2);
/// assert_eq!(stack.total_thickness(), 2.0);
/// let contacts: Vec<String> = stack.contacts().iter().map(ToString::to_string).collect();
/// assert_eq!(contacts, ["punch", "2|3"]);
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Stack {
    geometry: Geometry,
    pressure_on_top: f64,
    laminates: Vec<Laminate>,
    base: Base,
    dropped: Vec<Placed>,
    /// The elastic body that presses on the top face, if there is one.
    second: Option<Arc<Stack>>,
}

/// A layer and its number.
#[derive(Clone, Debug)]
pub struct Placed {
    /// Number from the top as written in the scene, starting at 1; layers of thickness zero count.
    pub number: usize,
    /// The layer.
    pub layer: Arc<dyn Layer>,
    /// By how much the slope of the layer grows with x, in 1/length, once parabolic gaps below it are pressed flat.
    pub(crate) pressed_to: f64,
}

impl Placed {
    /// The name of the layer in messages, e.g. `layer 1 (Homogeneous)` or `layer 1 "coating" (Homogeneous)`.
    pub fn name(&self) -> String {
        format!("{} ({})", layer_label(self.number, self.layer.name()), self.layer.notation().kind)
    }

    fn thickness(&self) -> f64 {
        self.layer.thickness().unwrap_or(0.0)
    }
}

/// A free group of at least one layer, joined to each other.
#[derive(Clone, Debug, Default)]
pub struct Laminate {
    layers: Vec<Placed>,
    joints: Vec<Joint>,
    gap: Option<Punch>,
}

impl Laminate {
    /// The layers from the top down.
    pub fn layers(&self) -> &[Placed] {
        &self.layers
    }

    /// The joints of each layer with the next, from the top down: one less than there are layers.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// The shape of the gap below it before it is loaded, if there is one.
    pub fn gap(&self) -> Option<&Punch> {
        self.gap.as_ref()
    }

    /// Thickness of the laminate, in length.
    pub fn thickness(&self) -> f64 {
        self.layers.iter().map(Placed::thickness).sum()
    }
}

/// The foundation, and the layers joined to it.
#[derive(Clone, Debug)]
pub struct Base {
    /// The layers, with a joint below the last one, too.
    joined: Laminate,
    foundation: Foundation,
}

impl Base {
    /// The layers joined to the foundation from the top down, without the foundation itself.
    pub fn layers(&self) -> &[Placed] {
        &self.joined.layers
    }

    /// The joints of each layer with the next, from the top down, and of the last one with the foundation.
    pub fn joints(&self) -> &[Joint] {
        &self.joined.joints
    }

    /// The foundation.
    pub fn foundation(&self) -> &Foundation {
        &self.foundation
    }
}

/// The foundation of a stack.
#[derive(Clone, Debug)]
pub enum Foundation {
    /// A layer without a thickness, which fills everything below.
    HalfPlane(Placed),
    /// A support that is no elastic body, such as springs.
    Support {
        /// The number of the support, counted with the layers.
        number: usize,
        /// The support itself.
        support: Arc<dyn Support>,
    },
    /// A rigid body.
    Rigid {
        /// The number of the rigid body, counted with the layers.
        number: usize,
    },
}

/// Layers joined to each other: a laminate, or the base with its foundation.
pub(crate) struct Group<'a> {
    joined: &'a Laminate,
    foundation: Option<&'a Foundation>,
}

impl<'a> Group<'a> {
    /// The layers from the top down, an elastic foundation as the last one.
    pub(crate) fn layers(&self) -> impl Iterator<Item = &'a Placed> + use<'a> {
        self.joined.layers.iter().chain(self.foundation.and_then(Foundation::half_plane))
    }

    /// The joints of each body with the next.
    pub(crate) fn joints(&self) -> &'a [Joint] {
        &self.joined.joints
    }

    /// The bodies from the top down with their numbers, the foundation as the last one; `None` if that is rigid.
    pub(crate) fn bodies(&self) -> impl Iterator<Item = (usize, Option<Body>)> + use<'a> {
        let layer = |placed: &Placed| (placed.number, Some(Body::Layer(Arc::clone(&placed.layer))));
        let foundation = self.foundation.map(|foundation| match foundation {
            Foundation::HalfPlane(placed) => layer(placed),
            Foundation::Support { number, support } => (*number, Some(Body::Support(Arc::clone(support)))),
            Foundation::Rigid { number } => (*number, None),
        });
        self.joined.layers.iter().map(layer).chain(foundation)
    }
}

impl Foundation {
    /// The half-plane that it is, if it is one.
    pub fn half_plane(&self) -> Option<&Placed> {
        if let Self::HalfPlane(placed) = self { Some(placed) } else { None }
    }

    /// The support that it is and its number, if it is one.
    pub fn support(&self) -> Option<(usize, &Arc<dyn Support>)> {
        if let Self::Support { number, support } = self { Some((*number, support)) } else { None }
    }

    /// The foundation's number, counted with the layers.
    pub fn number(&self) -> usize {
        match self {
            Self::HalfPlane(placed) => placed.number,
            Self::Support { number, .. } | Self::Rigid { number } => *number,
        }
    }
}

impl Stack {
    /// Checks that an elastic punch is neither stiffer nor softer than the layers by more than [`MAX_CONTRAST`].
    pub(crate) fn check_punch(&self, material: &Isotropic) -> Result<(), StackError> {
        let material = material.material(self.plane());
        contrast::check(self, Some(material)).map_err(|StackError { problem, .. }| StackError::whole(problem))
    }

    /// The same stack under a second body, which presses on its top face in place of a rigid punch: another stack, seen from its own top face
    /// inwards. All of it is joined to its base, and any punch presses both together with its profile.
    ///
    /// ```
    /// use recede::{Homogeneous, Model, Plane, Punch, Stack};
    /// let layer = Homogeneous::new(1.0, 1.0, 0.3)?;
    /// let cover = || Stack::builder(Plane::Strain).layer(layer).bonded().rigid().build();
    /// let roller = Punch::parabola(100.0)?;
    /// // two equal covers share what one of them has under twice the curvature
    /// let both = Model::new(cover()?.under(cover()?)?)?.press(&roller, 0.01)?;
    /// let one = Model::new(cover()?)?.press(Punch::parabola(200.0)?, 0.01)?;
    /// assert!((both.contacts()[0].reach() / one.contacts()[0].reach() - 1.0).abs() < 1e-10);
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`StackError`] if layers of the second body are loose, if it belongs to another geometry, or if moduli differ by more than [`MAX_CONTRAST`].
    pub fn under(self, second: Self) -> Result<Self, StackError> {
        if let Some(loose) = second.contacts().get(1) {
            return Err(StackError::of_second(StackProblem::LooseCover(*loose)));
        }
        if second.geometry != self.geometry {
            return Err(StackError::of_second(StackProblem::OtherGeometry));
        }
        let both = Self { second: Some(Arc::new(second)), ..self };
        contrast::check(&both, None).map(|()| both)
    }

    /// The elastic body that presses on the top face in place of a rigid punch, if there is one.
    pub fn second(&self) -> Option<&Self> {
        self.second.as_deref()
    }

    /// Plane, and in which way, or axisymmetric.
    pub fn geometry(&self) -> Geometry {
        self.geometry
    }

    /// The plane problem whose transformed equations hold.
    pub fn plane(&self) -> Plane {
        self.geometry.plane()
    }

    /// The pressure everywhere on the top face, also under a punch, in stress; 0 if there is none.
    pub fn pressure_on_top(&self) -> f64 {
        self.pressure_on_top
    }

    /// The free laminates from the top down; none if everything is joined to the foundation.
    pub fn laminates(&self) -> &[Laminate] {
        &self.laminates
    }

    /// The base below the laminates.
    pub fn base(&self) -> &Base {
        &self.base
    }

    /// The laminates from the top down, then the base.
    pub(crate) fn groups(&self) -> impl Iterator<Item = Group<'_>> {
        let Base { joined, foundation } = &self.base;
        let free = self.laminates.iter().map(|joined| Group { joined, foundation: None });
        free.chain([Group { joined, foundation: Some(foundation) }])
    }

    /// Layers left out because their thickness is zero.
    pub fn dropped(&self) -> &[Placed] {
        &self.dropped
    }

    /// The contacts from the top down: the punch, then every receding interface.
    pub fn contacts(&self) -> Vec<Interface> {
        let tops = self.groups().skip(1).filter_map(|below| below.bodies().next());
        let bottoms = self.laminates.iter().filter_map(|above| above.layers.last());
        let receding = bottoms.zip(tops).map(|(above, (below, _))| Interface::Between { above: above.number, below });
        [Interface::Punch].into_iter().chain(receding).collect()
    }

    /// The gaps at contacts before anything is loaded, and how the top face is curved then.
    pub(crate) fn gaps(&self) -> Gaps {
        let curvatures = self.residual().map_or_else(Vec::new, |residual| residual.curvatures);
        let bent = |i: usize| curvatures.get(i).copied().unwrap_or(0.0);
        let below = self.laminates.iter().enumerate();
        let below = below.map(|(i, above)| Gap { punch: above.gap.clone(), curvature: bent(i) - bent(i + 1) });
        let gaps = std::iter::once(Gap { punch: None, curvature: -bent(0) }).chain(below);
        let all = self.contacts().into_iter().zip(gaps);
        Gaps(all.filter(|(_, gap)| gap.punch.is_some() || gap.curvature != 0.0).collect())
    }

    /// Thickness of all layers without the half-plane, in length; 0 for a half-plane alone.
    pub fn total_thickness(&self) -> f64 {
        self.groups().map(|group| group.joined.thickness()).sum()
    }
}
