//! A cylinder or sphere with elastic layers on its core, as it is written.
use recede_layers::description::Value;
use recede_layers::tree::{Node, token};
use recede_layers::{Positive, described};
use schemars::{JsonSchema, json_schema};
use serde::de::{self, IgnoredAny};
use serde::{Deserialize, Deserializer, Serialize, Serializer, ser};

use super::item::Item;
use super::origin::{Origin, SceneError};
use super::read::read_item;
use super::value::ValueError;
use crate::geometry::Geometry;

/// A circular cylinder with elastic layers on its core, see [`Punch::Covered`](crate::Punch::Covered).
#[derive(Clone, Debug)]
pub struct Covered {
    radius: Positive,
    /// From the outer face inwards, ending in the core.
    items: Vec<Item>,
}

/// The fields as written in a scene.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Covered")]
#[expect(dead_code, reason = "layers and core are read from the tree")]
struct CoveredFields {
    /// Radius R of the outer face, in length.
    radius: Positive,
    /// The layers and the interfaces between them, from the outer face inwards; they are thin compared with the radius.
    #[schemars(with = "LayersForm")]
    layers: IgnoredAny,
    /// What the last layer lies on, bonded unless an interface stands between: `Rigid`, or a half-plane for an elastic core.
    #[schemars(with = "CoreForm")]
    core: IgnoredAny,
}

/// The forms of layers and core in a scene.
struct LayersForm;
struct CoreForm;

described!(Covered by CoveredFields);
described!(LayersForm, |_| {
    let items = json_schema!({"type": "array", "items": {"$ref": "#/properties/stack/items"}});
    Value::described("a list in `[` and `]` of layers and interfaces in turn", items)
});
described!(CoreForm, |_| { Value::described(BASE, json_schema!({"$ref": "#/properties/stack/items"})) });

/// Names of the fields.
const LAYERS: &str = "layers";
const CORE: &str = "core";
/// What may be a core.
const BASE: &str = "a base, as at the bottom of a stack";

impl Covered {
    /// A cylinder of radius R > 0, in length, with these items from its outer face inwards, ending in the core, as in a stack.
    pub(super) fn new(radius: f64, items: Vec<Item>) -> Result<Self, ValueError> {
        Ok(Self { radius: ValueError::checked("radius", radius)?, items })
    }

    /// Radius R of the outer face, in length.
    pub fn radius(&self) -> f64 {
        self.radius.get()
    }

    /// The layers and the interfaces between them from the outer face inwards, and the core as the last item.
    pub fn items(&self) -> &[Item] {
        &self.items
    }

    /// Reads the punch from a scene of this geometry.
    pub(super) fn read(node: &Node, geometry: Geometry, origin: &Origin) -> Result<Self, SceneError> {
        let owner = "the punch";
        let [layers, core] = [LAYERS, CORE].map(|name| node.field(name));
        let layers = layers.map_or(Ok(&[][..]), |list| origin.list(list, &format!("`{LAYERS}` of {owner}")))?;
        if let Some(core) = core.filter(|core| core.name.is_none()) {
            let found = token(origin.rest(core.place.start));
            return Err(origin.error_at(core, format!("`{CORE}` of {owner}: found {found}, allowed is {BASE}")));
        }
        let fields = node.read_inner::<CoveredFields>();
        let CoveredFields { radius, .. } =
            fields.map_err(|error| origin.explained(node, owner, Some(&Value::of::<Self>()), error))?;
        let mut items = Vec::new();
        for (index, item) in layers.iter().enumerate() {
            items.push(read_item(item, index / 2 + 1, geometry, origin)?);
        }
        if items.last().is_some_and(|last| !last.is_interface()) {
            items.push(Item::Bonded);
        }
        items.push(read_item(core.unwrap_or(node), items.len() / 2 + 1, geometry, origin)?);
        Ok(Self { radius, items })
    }

    /// As it is written in a scene of this geometry.
    pub(super) fn written(&self, geometry: Geometry) -> String {
        // the last layer is bonded to the core unless another interface is written
        let (layers, core) = match &self.items[..] {
            [layers @ .., Item::Bonded, core] | [layers @ .., core] => (layers, core.written(geometry)),
            [] => (&[][..], String::new()),
        };
        let layers: Vec<String> = layers.iter().map(|item| item.written(geometry)).collect();
        format!("Covered(radius: {:?}, {LAYERS}: [{}], {CORE}: {core})", self.radius(), layers.join(", "))
    }
}

impl PartialEq for Covered {
    /// Whether both are written alike.
    fn eq(&self, other: &Self) -> bool {
        self.written(Geometry::PlaneStrain) == other.written(Geometry::PlaneStrain)
    }
}

impl Serialize for Covered {
    /// Layers are written by their own notation.
    fn serialize<S: Serializer>(&self, _: S) -> Result<S::Ok, S::Error> {
        Err(ser::Error::custom("a covered punch is written by its own notation"))
    }
}

impl<'de> Deserialize<'de> for Covered {
    /// Layers are read through a registry of their types, which only a scene has.
    fn deserialize<D: Deserializer<'de>>(_: D) -> Result<Self, D::Error> {
        Err(de::Error::custom("`Covered` is the only punch of a scene, `punch: Covered(...)`"))
    }
}
