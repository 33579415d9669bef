//! Reading the items of a stack, and of the cover of a punch.
use std::mem;
use std::sync::Arc;

use recede_layers::description::Value;
use recede_layers::tree::{Fault, Kind, Node, ReadError, token};
use recede_layers::{Body, Finite, Loaded, Name, NamedSupport, Pressing, layer_label};
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::IgnoredAny;

use super::covered::{BASE, CORE, Covered, CoveredFields, LAYERS};
use super::hints::instead_of;
use super::item::{RECEDING, SPRING};
use super::origin::{Origin, SceneError};
use super::round::RoundPunch;
use super::{Item, Punch, Spring, quoted_list};
use crate::geometry::Geometry;

/// The fields that any layer with a thickness may have besides its own; a base has a name only.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct CommonFields {
    /// A name by which reports and pictures call the layer.
    name: Option<Name>,
    /// The strain that the layer would have in all directions if nothing held it; 0 if it is not given.
    eigenstrain: Option<Finite>,
    /// The weight of the layer, force per volume, by which it presses on what lies below; 0 if it is not given.
    specific_weight: Option<Pressing>,
}

/// The field of the name of a layer.
pub(super) const NAME: &str = "name";
/// The same in the order in which they are told; a base has the first only.
const COMMON: [&str; 3] = [NAME, "eigenstrain", "specific_weight"];

/// Reads the item that is, or would be, layer `number`, of a scene of this geometry.
pub(super) fn read_item(item: &Node, number: usize, geometry: Geometry, origin: &Origin) -> Result<Item, SceneError> {
    let names = || Item::names(&origin.registry);
    let Some(name) = item.name.as_deref() else {
        let found = token(origin.rest(item.place.start));
        let error = origin.error_at(item, format!("a layer or an interface is expected, found {found}"));
        return Err(error.hinted(Some(format!("allowed are {}", quoted_list(&names())))));
    };
    if let Some(plain) = Item::plain(name) {
        if item.kind == Kind::Nothing {
            return Ok(plain);
        }
        if name == RECEDING {
            return read_gap(item, number, geometry, origin);
        }
        let message = format!("`{name}` has no fields, found {}", token(origin.rest(item.inner)));
        return Err(origin.error(Some(item.inner), message).hinted(Some(format!("write `{name}` alone"))));
    }
    if name == SPRING {
        let owner = format!("the springs below layer {}", number - 1);
        let read = item.read_inner().map(Item::Spring);
        return read.map_err(|error| origin.explained(item, &owner, Some(&Value::of::<Spring>()), error));
    }
    let Some(entry) = origin.registry.get(name) else {
        let message = format!("no layer or interface is called `{name}`; allowed are {}", quoted_list(&names()));
        return Err(origin.error_at(item, message).hinted(instead_of(name, &names())));
    };
    let given = item.field(NAME).and_then(|node| node.read::<Name>().ok());
    let owner = format!("{} ({name})", layer_label(number, given.as_ref().map(Name::as_str)));
    let refused = |form: Option<Value>, error| origin.explained(item, &owner, form.as_ref(), error);
    // of these no type of layers knows
    let (mut own, mut given) = (item.clone(), Vec::new());
    if let Kind::Fields(fields) = &mut own.kind {
        given = fields.extract_if(.., |field| COMMON.contains(&&*field.name)).collect();
    }
    let rest = mem::replace(&mut own.kind, Kind::Fields(given));
    let common = own.read_inner::<CommonFields>();
    let common = common.map_err(|error| refused(Some(Value::of::<CommonFields>()), error))?;
    own.kind = rest;
    let read = (entry.read)(&own).map_err(|error| refused(entry.describe(), with_common_fields(error)))?;
    let is_base = read.layer().is_none_or(|layer| layer.thickness().is_none());
    if let Some(load) = item.fields().iter().find(|field| is_base && COMMON[1..].contains(&&*field.name)) {
        let what = if &*load.name == "eigenstrain" { "eigenstrain" } else { "weight" };
        return Err(origin.error_at(&load.value, format!("{owner} is a base, and has no {what}")));
    }
    Ok(common.of(read))
}

/// An error that names the allowed fields of a layer, and the fields that any layer may have.
fn with_common_fields(mut error: ReadError) -> ReadError {
    if let (None, Fault::UnknownField { allowed, .. }) = (&error.field, &mut error.fault) {
        let count = if allowed.contains(&"thickness") { COMMON.len() } else { 1 };
        allowed.extend(&COMMON[..count]);
    }
    error
}

impl CommonFields {
    /// The layer or support with these.
    fn of(self, body: Body) -> Item {
        match (body, self) {
            (Body::Support(support), Self { name: Some(name), .. }) => Item::support(NamedSupport { support, name }),
            (Body::Layer(layer), Self { name, eigenstrain, specific_weight })
                if name.is_some() || eigenstrain.is_some() || specific_weight.is_some() =>
            {
                let layer = Loaded::of(layer).with_eigenstrain(eigenstrain.map_or(0.0, Finite::get));
                let layer = layer.with_specific_weight(specific_weight.map_or(0.0, Pressing::get));
                Item::layer(name.into_iter().fold(layer, Loaded::with_name))
            }
            (body, _) => Item::of(body),
        }
    }
}

/// The fields of a receding interface.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(dead_code, reason = "the gap is read from the tree")]
pub(super) struct Receding {
    /// How far the layers are apart before they are loaded: a shape as of a punch.
    #[schemars(with = "Punch")]
    gap: IgnoredAny,
}

/// Reads the receding interface with a gap below layer `number - 1`.
fn read_gap(item: &Node, number: usize, geometry: Geometry, origin: &Origin) -> Result<Item, SceneError> {
    let owner = format!("the interface below layer {}", number - 1);
    let read = item.read_inner::<Receding>();
    read.map_err(|error| origin.explained(item, &owner, Some(&Value::of::<Receding>()), error))?;
    let (node, owner) = (item.field("gap").unwrap_or(item), format!("the gap below layer {}", number - 1));
    let gap = match geometry.is_axisymmetric() {
        true => Punch::from(origin.read::<RoundPunch>(node, &owner)?),
        false => origin.read::<Punch>(node, &owner)?,
    };
    if gap.material().is_some() {
        let error = origin.error_at(node, format!("{owner} is elastic"));
        return Err(error.hinted(Some("a gap is a shape: write `Cylinder` or `Parabola`, or about an axis `Sphere`")));
    }
    Ok(Item::RecedingGap(gap))
}

/// Reads a covered punch from a scene of this geometry.
pub(super) fn read_covered(node: &Node, geometry: Geometry, origin: &Origin) -> Result<Covered, SceneError> {
    let owner = "the punch";
    let [layers, core] = [LAYERS, CORE].map(|name| node.field(name));
    let layers = layers.map_or(Ok(&[][..]), |list| origin.list(list, &format!("`{LAYERS}` of {owner}")))?;
    if let Some(core) = core.filter(|core| core.name.is_none()) {
        let found = token(origin.rest(core.place.start));
        return Err(origin.error_at(core, format!("`{CORE}` of {owner}: found {found}, allowed is {BASE}")));
    }
    let fields = node.read_inner::<CoveredFields>();
    let CoveredFields { radius, .. } =
        fields.map_err(|error| origin.explained(node, owner, Some(&Value::of::<Covered>()), error))?;
    let mut items = Vec::new();
    for (index, item) in layers.iter().enumerate() {
        items.push(read_item(item, index / 2 + 1, geometry, origin)?);
    }
    if items.last().is_some_and(|last| !last.is_interface()) {
        items.push(Item::Bonded);
    }
    items.push(read_item(core.unwrap_or(node), items.len() / 2 + 1, geometry, origin)?);
    Ok(Covered { radius, cover: Arc::new(items) })
}
