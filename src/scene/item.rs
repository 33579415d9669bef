//! The items of a stack as written: layers, and the interfaces between them.
use std::any::Any;
use std::sync::Arc;

use recede_layers::description::{Form, Value};
use recede_layers::{Body, Layer, Positive, Registry, Support};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::covered::{Cover, Covered};
use super::punch::Punch;
use super::text::written;
use super::value::ValueError;
use crate::geometry::Geometry;

/// The interfaces that have fields.
pub(super) const SPRING: &str = "Spring";
pub(super) const RECEDING: &str = "Receding";

/// One line of the stack in a scene.
#[derive(Clone, Debug)]
pub enum Item {
    /// An elastic layer, or the half-plane at the bottom.
    Layer(Arc<dyn Layer>),
    /// A support at the bottom that is no elastic body.
    Support(Arc<dyn Support>),
    /// Interface that transmits everything: u, v, σ_yy and σ_xy are continuous.
    Bonded,
    /// Interface without friction that does not open: v and σ_yy are continuous, σ_xy = 0.
    Sliding,
    /// Interface of springs: σ_yy and σ_xy are continuous, and proportional to the jumps of v and u.
    Spring(Spring),
    /// Interface without friction or adhesion, free to open: where it is closed it transmits pressure only.
    Receding,
    /// The same between layers that are apart by a gap before they are loaded, of the shape of a punch about x = 0.
    RecedingGap(Punch),
    /// Rigid base at the bottom.
    Rigid,
}

/// Springs that join two layers, in both directions: they neither open nor slide freely.
///
/// ```
/// use recede::Spring;
/// let glue = Spring::new(100.0, Some(40.0))?;
/// assert_eq!((glue.normal(), glue.tangential()), (100.0, 40.0));
/// assert_eq!(Spring::new(100.0, None)?.tangential(), 0.0);
/// assert!(Spring::new(0.0, None).is_err());
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spring {
    /// Stress σ_yy per length by which the layers separate.
    normal: Positive,
    /// Stress σ_xy per length by which the layers slide on each other; none if it is not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    tangential: Option<Positive>,
}

impl Spring {
    /// Springs of this normal and, if there is one, tangential stiffness, both > 0, in stress per length.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if a stiffness is not positive and finite.
    pub fn new(normal: f64, tangential: Option<f64>) -> Result<Self, ValueError> {
        let tangential = tangential.map(|stiffness| ValueError::checked("tangential", stiffness)).transpose()?;
        Ok(Self { normal: ValueError::checked("normal", normal)?, tangential })
    }

    /// Normal stiffness, in stress per length.
    pub fn normal(&self) -> f64 {
        self.normal.get()
    }

    /// Tangential stiffness, in stress per length; 0 if there is none.
    pub fn tangential(&self) -> f64 {
        self.tangential.map_or(0.0, Positive::get)
    }
}

impl Item {
    /// The item that was read by a registered name.
    pub(super) fn of(body: Body) -> Self {
        match body {
            Body::Layer(layer) => Self::Layer(layer),
            Body::Support(support) => Self::Support(support),
        }
    }

    /// A layer as an item.
    pub fn layer(layer: impl Layer) -> Self {
        Self::Layer(Arc::new(layer))
    }

    /// A support as an item.
    pub fn support(support: impl Support + 'static) -> Self {
        Self::Support(Arc::new(support))
    }

    /// The name by which the item is written, e.g. `Homogeneous`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Layer(layer) => layer.notation().kind,
            Self::Support(support) => support.notation().kind,
            Self::Bonded => "Bonded",
            Self::Sliding => "Sliding",
            Self::Spring(_) => SPRING,
            Self::Receding | Self::RecedingGap(_) => RECEDING,
            Self::Rigid => "Rigid",
        }
    }

    /// The name that the layer or support was given, if it has one.
    pub fn own_name(&self) -> Option<&str> {
        match self {
            Self::Layer(layer) => layer.name(),
            Self::Support(support) => support.name(),
            _ => None,
        }
    }

    /// The layer that it is, if it is one.
    pub(crate) fn elastic(&self) -> Option<&Arc<dyn Layer>> {
        if let Self::Layer(layer) = self { Some(layer) } else { None }
    }

    /// Whether the item is an interface, which joins or divides layers.
    pub fn is_interface(&self) -> bool {
        matches!(self, Self::Bonded | Self::Sliding | Self::Spring(_)) || self.is_receding()
    }

    /// Whether the item is an interface that may open.
    pub(crate) fn is_receding(&self) -> bool {
        matches!(self, Self::Receding | Self::RecedingGap(_))
    }

    /// The item as it is written in a scene of this geometry.
    pub(super) fn written(&self, geometry: Geometry) -> String {
        match self {
            Self::Layer(layer) => layer.notation().to_string(),
            Self::Support(support) => support.notation().to_string(),
            Self::Spring(spring) => format!("{SPRING}{}", written(spring)),
            Self::RecedingGap(gap) => format!("{RECEDING}(gap: {})", gap.written_in(geometry)),
            Self::Bonded | Self::Sliding | Self::Receding | Self::Rigid => self.name().to_owned(),
        }
    }

    /// The items written by a name alone, with what they mean.
    fn plain_items() -> [(Self, &'static str); 4] {
        [
            (Self::Bonded, "All displacements and stresses are continuous."),
            (Self::Sliding, "No friction, but no opening either: only v and σ_yy are continuous."),
            (
                Self::Receding,
                "No friction, no adhesion, free to open: where closed it transmits pressure only. Where layers are apart before they are loaded, \
                 `Receding(gap: ...)` with the shape of a punch.",
            ),
            (Self::Rigid, "A rigid base, to which the layer above is joined or on which it lies loose."),
        ]
    }

    /// The item written by a name alone, if there is one of that name.
    pub(super) fn plain(name: &str) -> Option<Self> {
        Self::plain_items().into_iter().map(|(item, _)| item).find(|item| item.name() == name)
    }

    /// The items that are no layers: interfaces, with springs as the last of them, and the rigid base.
    pub(super) fn forms() -> Vec<Form> {
        let meaning = "Springs that neither open nor slide freely: σ_yy = normal · [v], σ_xy = tangential · [u].";
        let [bonded, sliding, receding, rigid] =
            Self::plain_items().map(|(item, meaning)| (item.name(), meaning, None));
        let all = [bonded, sliding, receding, (SPRING, meaning, Some(Value::of::<Spring>())), rigid];
        let form = |(name, meaning, value): (&str, &str, _)| Form {
            name: name.to_owned(),
            meaning: meaning.to_owned(),
            value,
        };
        all.map(form).to_vec()
    }

    /// All names that may stand in a stack.
    pub(super) fn names(registry: &Registry) -> Vec<&'static str> {
        let plain = Self::plain_items().map(|(item, _)| item.name());
        registry.iter().map(|entry| entry.name).chain(plain).chain([SPRING]).collect()
    }
}

impl Cover for Vec<Item> {
    fn written(&self, geometry: Geometry) -> [String; 2] {
        // the last layer is bonded to the core unless another interface is written
        let (layers, core) = match &self[..] {
            [layers @ .., Item::Bonded, core] | [layers @ .., core] => (layers, core.written(geometry)),
            [] => (&[][..], String::new()),
        };
        let layers: Vec<String> = layers.iter().map(|item| item.written(geometry)).collect();
        [layers.join(", "), core]
    }
}

impl Punch {
    /// A circular cylinder of radius R > 0, in length, with layers on its core: items as of a stack from the outer face inwards, ending in the core. Its layers are
    /// part of the stack on which it presses, see [`Stack::under`](crate::Stack::under).
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if the radius is not positive and finite.
    pub fn covered(radius: f64, items: Vec<Item>) -> Result<Self, ValueError> {
        Ok(Self::Covered(Covered { radius: ValueError::checked("radius", radius)?, cover: Arc::new(items) }))
    }

    /// The layers of a covered punch with its core, from the outer face inwards; `None` of others.
    pub fn cover(&self) -> Option<&[Item]> {
        let Self::Covered(Covered { cover, .. }) = self else { return None };
        let any: &dyn Any = &**cover;
        any.downcast_ref::<Vec<Item>>().map(|items| &items[..])
    }
}

/// `` `a`, `b`, `c` ``.
pub(crate) fn quoted_list(names: &[&str]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}
