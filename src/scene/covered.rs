//! A cylinder or sphere with elastic layers on its core, as it is written.
use std::any::Any;
use std::fmt::Debug;
use std::sync::Arc;

use recede_layers::description::Value;
use recede_layers::{Positive, described};
use schemars::{JsonSchema, json_schema};
use serde::de::{self, IgnoredAny};
use serde::{Deserialize, Deserializer, Serialize, Serializer, ser};

use crate::geometry::Geometry;

/// A circular cylinder with elastic layers on its core, see [`Punch::Covered`](crate::Punch::Covered).
#[derive(Clone, Debug)]
pub struct Covered {
    pub(super) radius: Positive,
    pub(super) cover: Arc<dyn Cover>,
}

/// Layers on a core: items of a stack, whose interfaces may have gaps of the shape of a punch, so that a punch knows no more of them.
pub(super) trait Cover: Any + Debug + Send + Sync {
    /// Layers and core, in this order, as they are written in a scene of this geometry.
    fn written(&self, geometry: Geometry) -> [String; 2];
}

/// The fields as written in a scene.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Covered")]
#[expect(dead_code, reason = "layers and core are read from the tree")]
pub(super) struct CoveredFields {
    /// Radius R of the outer face, in length.
    pub(super) radius: Positive,
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
pub(super) const LAYERS: &str = "layers";
pub(super) const CORE: &str = "core";
/// What may be a core.
pub(super) const BASE: &str = "a base, as at the bottom of a stack";

impl Covered {
    /// Radius R of the outer face, in length.
    pub fn radius(&self) -> f64 {
        self.radius.get()
    }

    /// As it is written in a scene of this geometry.
    pub(super) fn written(&self, geometry: Geometry) -> String {
        let [layers, core] = self.cover.written(geometry);
        format!("Covered(radius: {:?}, {LAYERS}: [{layers}], {CORE}: {core})", self.radius())
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
