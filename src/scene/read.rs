//! Reading a scene: every error names its line and column.
//!
//! The text, in RON or in JSON, is read once, into a tree of values that know their places. The fields of the scene, its punch
//! and every item of its stack are then read from their parts of the tree, a layer through the [`Registry`].
use std::io::{self, Read};
use std::sync::Arc;
#[cfg(feature = "files")]
use std::{fs::File, path::Path};

use recede_layers::description::Value;
use recede_layers::tree::{Fault, Form, Kind, Node, ReadError};
use recede_layers::{Compressive, Positive, Pressing, Registry, described};
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::{DeserializeOwned, IgnoredAny};

use super::origin::{Origin, SceneError};
use super::read_item::read_item;
use super::read_top::{only_top, read_top, tops};
use super::units::without_units;
use super::{Force, Load, Loads, MAX_BYTES, MAX_ITEMS, Punch, Punches, Scene, Top, Units};
use crate::geometry::Geometry;

/// The field of the pressure on top.
pub(super) const PRESSURE_ON_TOP: &str = "pressure_on_top";

/// The name of a scene in messages.
pub(super) const THE_SCENE: &str = "the scene";

/// The scene with punch and stack still unread.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Scene")]
#[expect(dead_code, reason = "what presses and the stack are read from the tree")]
pub(super) struct Draft {
    /// A name for reports.
    name: Option<String>,
    /// What the scene shows.
    description: Option<String>,
    /// Labels of the units; nothing is converted.
    units: Option<Units>,
    /// Plane, and in which way, or axisymmetric.
    geometry: Geometry,
    /// The punch on top, if there are no loads.
    #[schemars(with = "Option<Punch>")]
    punch: Option<IgnoredAny>,
    /// In place of one punch: several, each anywhere on x with a force of its own, or a `depth`, or the place where its contact ends, `left` or `right`. Without `tilt` a punch cannot turn; `tilt: Fixed(angle)` turns it by a small
    /// angle, and `tilt: Free(eccentricity: e)` lets it turn freely under a force that acts at x + e.
    #[schemars(with = "Option<Punches>")]
    punches: Option<IgnoredAny>,
    /// In place of a punch: a given pressure on top, with the force as its resultant.
    #[schemars(with = "Option<Load>")]
    load: Option<IgnoredAny>,
    /// In place of a punch: several given pressures, each anywhere on x with a force of its own; in axisymmetric scenes each about an axis of its own, `at: (x, y)`.
    #[schemars(with = "Option<Loads>")]
    loads: Option<IgnoredAny>,
    /// Line load P that presses the punch down, or resultant of the `load`: force per unit length out of the plane; the whole force in axisymmetric scenes. 0, as without a punch or
    /// load, if nothing presses but weights.
    force: Option<Compressive>,
    /// In place of the force: half-length of the contact under the punch, or its radius, for which the force is found; in length.
    half_length: Option<Positive>,
    /// In place of the force: how far the punch sinks, for which the force is found; in length. In plane scenes the base has to be rigid, or springs.
    depth: Option<Positive>,
    /// Pressure everywhere on the top face, also under a punch; 0 if it is not given.
    pub(super) pressure_on_top: Option<Pressing>,
    /// Layers and the interfaces between them from the top down, ending in a base.
    #[schemars(with = "StackForm")]
    stack: IgnoredAny,
}

/// The form of a stack in a scene.
struct StackForm;

described!(StackForm in "a list in `[` and `]` of layers and interfaces in turn");

impl Scene {
    /// Reads a scene from RON with the layer types that ship.
    ///
    /// # Errors
    /// [`SceneError`] with line and column: unknown, missing or repeated fields, wrong types, numbers out of range,
    /// unknown layers. Whether the items of the stack fit together is checked by [`Scene::stack`].
    pub fn from_ron(text: &str) -> Result<Self, SceneError> {
        Self::from_reader("scene", text.as_bytes(), &Registry::default())
    }

    /// Reads a scene from JSON, see [`Scene::to_json`], with the layer types that ship. All that reads a scene from RON reads
    /// JSON as well, and tells them apart by the brace with which JSON begins.
    ///
    /// # Errors
    /// As [`Scene::from_ron`].
    pub fn from_json(text: &str) -> Result<Self, SceneError> {
        Self::from_ron(text)
    }

    /// Reads a scene from a file with the layer types that ship.
    ///
    /// # Errors
    /// As [`Scene::from_ron`], and if the file cannot be read or is larger than [`MAX_BYTES`].
    #[cfg(feature = "files")]
    pub fn read(path: impl AsRef<Path>) -> Result<Self, SceneError> {
        let (file, reader) = open(path.as_ref())?;
        Self::from_reader(&file, reader, &Registry::default())
    }

    /// Reads a scene in RON or in JSON from anything that yields bytes, with the layer types of `registry`; `file` is its name in messages.
    ///
    /// # Errors
    /// As [`Scene::from_ron`], and if it cannot be read or is longer than [`MAX_BYTES`].
    pub fn from_reader(file: &str, reader: impl Read, registry: &Registry) -> Result<Self, SceneError> {
        let mut origin = Origin { registry: registry.clone(), ..read_text(file, reader)? };
        let mut tree = read_tree(&origin)?;
        without_units(&mut tree, &origin)?;
        origin.tree = tree;
        read_scene(origin)
    }
}

/// Opens a file; with its name in messages.
#[cfg(feature = "files")]
pub(crate) fn open(path: &Path) -> Result<(String, File), SceneError> {
    let file = path.display().to_string();
    let reader = File::open(path).map_err(|cause| unreadable(&file, cause))?;
    Ok((file, reader))
}

/// Reads a text in RON that is not a scene; `owner` is its name in messages.
#[cfg(feature = "files")]
pub(crate) fn read_document<T: DeserializeOwned>(file: &str, reader: impl Read, owner: &str) -> Result<T, SceneError> {
    let origin = read_text(file, reader)?;
    let tree = Node::from_ron(&origin.text).map_err(|error| origin.explained(&origin.tree, owner, None, error))?;
    tree.read().map_err(|error| origin.explained(&tree, owner, None, error))
}

/// The error of a file that could not be opened or read.
fn unreadable(file: &str, cause: io::Error) -> SceneError {
    let origin = Origin { file: file.to_owned(), ..Origin::default() };
    origin.error(None, format!("cannot be read: {cause}")).because(cause)
}

impl Origin {
    /// The error where a scene has one field beside another.
    pub(super) fn both(&self, first: &str, second: &str, hint: impl AsRef<str>) -> SceneError {
        let node = self.tree.field(second).unwrap_or(&self.tree);
        self.error_at(node, format!("the scene has `{first}` and `{second}`")).hinted(Some(hint))
    }

    /// Reads a part of the scene that is called `owner` in messages.
    pub(super) fn read<T: DeserializeOwned + JsonSchema>(&self, node: &Node, owner: &str) -> Result<T, SceneError> {
        node.read().map_err(|error| self.explained(node, owner, Some(&Value::of::<T>()), error))
    }

    /// The members of a list that is called `owner` in messages.
    pub(super) fn list<'a>(&self, node: &'a Node, owner: &str) -> Result<&'a [Node], SceneError> {
        if let Kind::List(members) = &node.kind {
            return Ok(members);
        }
        Err(self.explained(node, owner, None, Fault::Expected(Form::List).at(node.place.start)))
    }
}

/// The text of a file, without the mark that some editors put first, and nothing else of it.
fn read_text(file: &str, reader: impl Read) -> Result<Origin, SceneError> {
    let mut bytes = Vec::new();
    reader.take(MAX_BYTES as u64 + 1).read_to_end(&mut bytes).map_err(|cause| unreadable(file, cause))?;
    let valid = bytes.utf8_chunks().next().map_or("", |chunk| chunk.valid());
    let text = valid.strip_prefix('\u{feff}').unwrap_or(valid).to_owned();
    let origin = Origin { file: file.to_owned(), text, ..Origin::default() };
    if bytes.len() > MAX_BYTES {
        let message = format!("the text is larger than {MAX_BYTES} bytes, the most that is read");
        return Err(origin.error(None, message).hinted(Some("is this a scene file?")));
    }
    let Err(cause) = str::from_utf8(&bytes) else { return Ok(origin) };
    let message = format!("the byte 0x{:02X} is no UTF-8 text", bytes[valid.len()]);
    let error = origin.error(Some(origin.text.len()), message).because(cause);
    Err(error.hinted(Some("a scene is a text file in UTF-8")))
}

/// Reads the values of a text.
fn read_tree(origin: &Origin) -> Result<Node, SceneError> {
    if origin.text.trim().is_empty() {
        let hint = "a scene begins with `Scene(geometry: PlaneStrain, punch: ..., force: ..., stack: [...])`";
        return Err(origin.error(None, "the text is empty").hinted(Some(hint)));
    }
    // a scene in RON begins with its name or a parenthesis
    let tree = if origin.text.trim_start().starts_with('{') {
        is_json(origin)?;
        Node::from_json(&origin.text)
    } else {
        Node::from_ron(&origin.text)
    };
    tree.map_err(|error| origin.explained(&origin.tree, THE_SCENE, None, error))
}

/// Refuses a text that is no JSON.
fn is_json(origin: &Origin) -> Result<(), SceneError> {
    let text = &origin.text[..];
    serde_json::from_str(text).map(|IgnoredAny| ()).map_err(|error| {
        let lines: usize = text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum();
        let message = error.to_string();
        let message = message.split(" at line ").next().unwrap_or_default();
        let error = origin.error(Some(lines + error.column().saturating_sub(1)), message);
        error.hinted(Some("the text begins with `{`, and is read as JSON"))
    })
}

/// Reads a scene from its tree.
fn read_scene(own: Origin) -> Result<Scene, SceneError> {
    let (origin, tree) = (&own, &own.tree);
    let draft: Draft = origin.read(tree, THE_SCENE)?;
    let (top, force) = match tops(tree).next().is_none() && is_unloaded(&draft) {
        // refused below unless weights press
        true => (Load::Line.into(), Force::Given(0.0)),
        false => {
            let (name, node) = only_top(origin)?;
            let top = read_top(name, node, draft.geometry, origin)?;
            let force = force_of(&draft, name, &top, origin)?;
            (top, force)
        }
    };
    let list = tree.field("stack").unwrap_or(tree);
    let items = origin.list(list, "the stack")?;
    if items.len() > MAX_ITEMS {
        let message = format!("the stack has {} items; allowed are at most {MAX_ITEMS}", items.len());
        return Err(origin.error_at(list, message));
    }
    let mut number = 1;
    let read = |node| {
        read_item(node, number, draft.geometry, origin).inspect(|item| number += usize::from(!item.is_interface()))
    };
    let stack = items.iter().map(read).collect::<Result<Vec<_>, _>>()?;
    let Draft { name, description, units, geometry, pressure_on_top, .. } = draft;
    let pressure_on_top = pressure_on_top.map_or(0.0, Pressing::get);
    let scene = Scene { name, description, units, geometry, top, force, pressure_on_top, stack, origin: None };
    check_force(&scene, origin)?;
    Ok(Scene { origin: Some(Arc::new(own)), ..scene })
}

/// Refuses a force that is 0 unless weights press, and no punch.
pub(super) fn check_force(scene: &Scene, origin: &Origin) -> Result<(), SceneError> {
    if scene.force != Force::Given(0.0) || scene.top.loads().is_some() && scene.is_weighed() {
        return Ok(());
    }
    only_top(origin)?;
    let found = origin.tree.field("force").ok_or_else(|| missing_force(origin))?;
    let Err(error) = found.read::<Positive>() else { return Ok(()) };
    Err(origin.explained(&origin.tree, THE_SCENE, None, ReadError { field: Some("force".to_owned()), ..error }))
}

/// Whether neither a force is given nor a length from which it is found.
fn is_unloaded(draft: &Draft) -> bool {
    draft.force.is_none_or(|force| force.get() == 0.0) && draft.half_length.is_none() && draft.depth.is_none()
}

fn missing_force(origin: &Origin) -> SceneError {
    let hint = "add `force: ...` or, for a punch, `half_length: ...` or `depth: ...` between its parentheses";
    origin.error_at(&origin.tree, "`force` is missing in the scene").hinted(Some(hint))
}

/// The force, or the half-length or depth that it is found for, beside what presses, which stands in this field.
pub(super) fn force_of(draft: &Draft, field: &'static str, top: &Top, origin: &Origin) -> Result<Force, SceneError> {
    let numbers =
        [draft.force.map(Compressive::get), draft.half_length.map(Positive::get), draft.depth.map(Positive::get)];
    let kinds = [Force::Given, Force::ForHalfLength, Force::ForDepth];
    let given: Vec<Force> = kinds.iter().zip(numbers).filter_map(|(kind, number)| number.map(kind)).collect();
    let own = format!("each of the {field} has a force of its own, and the force is their sum: remove it");
    let (other, found, hint) = match (&given[..], field) {
        ([], "punches" | "loads") => {
            return Ok(top.punches().map_or_else(|| Force::Given(top.force()), Punches::pressed_by));
        }
        ([], _) => return Err(missing_force(origin)),
        ([found], "punch") | ([found @ Force::Given(_)], "load") => return Ok(*found),
        ([found, ..], "loads") | ([found @ Force::Given(_), ..], "punches") => (field, found, &own[..]),
        ([found, ..], "punches") => (
            field,
            found,
            "it is for one `punch` only: each of several punches has its `force`, `depth`, `left` or `right`",
        ),
        ([found], _) => (field, found, "no force changes how far a load reaches: give its resultant, `force: ...`"),
        ([first, second, ..], _) => {
            (first.field(), second, "`force` is given, or found for `half_length` or `depth`: remove one of them")
        }
    };
    Err(origin.both(other, found.field(), hint))
}
