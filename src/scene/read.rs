//! Reading a scene from RON: every error names its line and column.
//!
//! The scene is read in two steps. The first finds the text of the punch and of every item of the stack; the second
//! reads each of them on its own, a layer through the [`Registry`]. So each has a place in the text from the start.
use std::borrow::Cow;
use std::io::{self, Read};
use std::ops::Range;
#[cfg(feature = "files")]
use std::path::Path;
use std::sync::Arc;

use recede_layers::description::{Field, Value, schema_of};
use recede_layers::{Positive, ReadError, Registry, read_ron};
use ron::error::Position;
use ron::value::RawValue;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::Deserialize;
use serde::de::IgnoredAny;

use super::explain::{At, Subject, explain, place, token};
use super::hints::instead_of;
use super::item::SPRING;
use super::origin::{Origin, Places, SceneError};
use super::round::{RoundLoad, RoundPunch};
use super::text::{Part, field, name_and_rest, part, without_comments};
use super::{Force, Item, Load, MAX_BYTES, MAX_ITEMS, Punch, Scene, Spring, Units, quoted_list};
use crate::geometry::Geometry;

/// The scene with punch and stack still unread.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Scene")]
struct Draft<'a> {
    /// A name for reports.
    #[serde(default)]
    name: Option<String>,
    /// What the scene shows.
    #[serde(default)]
    description: Option<String>,
    /// Labels of the units; nothing is converted.
    #[serde(default)]
    units: Option<Units>,
    /// Plane, and in which way, or axisymmetric.
    geometry: Geometry,
    /// The punch on top, if there is no `load`.
    #[serde(borrow, default)]
    #[schemars(with = "Option<Punch>")]
    punch: Option<&'a RawValue>,
    /// In place of a punch: a given pressure on top, with the force as its resultant.
    #[serde(borrow, default)]
    #[schemars(with = "Option<Load>")]
    load: Option<&'a RawValue>,
    /// Line load P that presses the punch down, or resultant of the load: force per unit length out of the plane; the whole force in axisymmetric scenes.
    #[serde(default)]
    force: Option<Positive>,
    /// In place of the force: half-length of the contact under the punch, or its radius, for which the force is found; in length.
    #[serde(default)]
    half_length: Option<Positive>,
    /// In place of the force: how far the punch sinks, for which the force is found; in length. In plane scenes the base has to be rigid, or springs.
    #[serde(default)]
    depth: Option<Positive>,
    /// Layers and the interfaces between them from the top down, ending in a base.
    #[serde(borrow)]
    #[schemars(with = "StackText")]
    stack: &'a RawValue,
}

/// The form of a stack in a scene.
struct StackText;

impl JsonSchema for StackText {
    fn schema_name() -> Cow<'static, str> {
        "Stack".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        Value::plain_schema("a list in `[` and `]` of layers and interfaces in turn")
    }
}

/// The JSON Schema of a scene, whose stack is a list of anything.
pub(super) fn schema_of_scene() -> Schema {
    schema_of::<Draft>()
}

/// The fields of a scene.
pub(super) fn fields_of_scene() -> Vec<Field> {
    match Value::of_schema(&schema_of_scene()) {
        Value::Fields(fields) => fields,
        _ => Vec::new(),
    }
}

impl Scene {
    /// Reads a scene from RON with the layer types that ship.
    ///
    /// # Errors
    /// [`SceneError`] with line and column: unknown, missing or repeated fields, wrong types, numbers out of range,
    /// unknown layers. Whether the items of the stack fit together is checked by [`Scene::stack`].
    pub fn from_ron(text: &str) -> Result<Self, SceneError> {
        Self::from_ron_with(text, &Registry::default())
    }

    /// Reads a scene from RON with the layer types of `registry`.
    ///
    /// # Errors
    /// As [`Scene::from_ron`].
    pub fn from_ron_with(text: &str, registry: &Registry) -> Result<Self, SceneError> {
        Self::from_reader("scene", text.as_bytes(), registry)
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
        Self::read_with(path, &Registry::default())
    }

    /// Reads a scene from a file with the layer types of `registry`.
    ///
    /// # Errors
    /// As [`Scene::read`].
    #[cfg(feature = "files")]
    pub fn read_with(path: impl AsRef<Path>, registry: &Registry) -> Result<Self, SceneError> {
        let path = path.as_ref();
        let reader = std::fs::File::open(path).map_err(|cause| SceneError::unreadable(path, cause))?;
        Self::from_reader(&path.display().to_string(), reader, registry)
    }

    /// Reads a scene from anything that yields bytes; `file` is what it is called in messages.
    ///
    /// # Errors
    /// As [`Scene::from_ron`], and if it cannot be read or is longer than [`MAX_BYTES`].
    pub fn from_reader(file: &str, reader: impl Read, registry: &Registry) -> Result<Self, SceneError> {
        let mut origin = Origin { registry: registry.clone(), ..read_text(file, reader)? }.translated()?;
        let (scene, places) = parse(&origin)?;
        origin.places = places;
        Ok(Self { origin: Some(Arc::new(origin)), ..scene })
    }
}

/// Reads a text in RON that is not a scene; `owner` is what it is called in messages.
#[cfg(feature = "files")]
pub(crate) fn read_document<T: serde::de::DeserializeOwned>(
    file: &str,
    reader: impl Read,
    owner: &str,
) -> Result<T, SceneError> {
    let origin = read_text(file, reader)?;
    let text = &origin.text[..];
    let name_at = text.len() - without_comments(text).len();
    let whole = Part { text, offset: 0, name_at, owner: owner.into() };
    read_ron(text).map_err(|error| whole.error(&origin, error))
}

#[cfg(feature = "files")]
impl SceneError {
    /// A file could not be opened.
    pub(crate) fn unreadable(path: &Path, cause: io::Error) -> Self {
        unreadable(&Origin { file: path.display().to_string(), ..Origin::default() }, cause)
    }
}

/// The text of a file, and nothing else of it.
fn read_text(file: &str, reader: impl Read) -> Result<Origin, SceneError> {
    let mut bytes = Vec::new();
    let mut origin = Origin { file: file.to_owned(), ..Origin::default() };
    match reader.take(MAX_BYTES as u64 + 1).read_to_end(&mut bytes) {
        Err(cause) => return Err(unreadable(&origin, cause)),
        Ok(length) if length > MAX_BYTES => {
            let message = format!("the text is larger than {MAX_BYTES} bytes, the most that is read");
            return Err(origin.error(None, message, Some("is this a scene file?".into())));
        }
        Ok(_) => {}
    }
    origin.text = decoded(&origin, bytes)?;
    Ok(origin)
}

fn unreadable(origin: &Origin, cause: io::Error) -> SceneError {
    origin.error(None, format!("cannot be read: {cause}"), None).because(cause)
}

/// The bytes as text, without the mark that some editors put first.
fn decoded(origin: &Origin, bytes: Vec<u8>) -> Result<String, SceneError> {
    let text = String::from_utf8(bytes).map_err(|cause| {
        let valid = cause.utf8_error().valid_up_to();
        let found = cause.as_bytes().get(valid).copied().unwrap_or_default();
        let text = String::from_utf8_lossy(&cause.as_bytes()[..valid]).into_owned();
        let origin = Origin { file: origin.file.clone(), text, ..Origin::default() };
        let hint = Some("a scene is a text file in UTF-8".into());
        origin.error(Some(valid), format!("the byte 0x{found:02X} is no UTF-8 text"), hint).because(cause)
    })?;
    Ok(text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text))
}

impl Part<'_> {
    /// Its bytes in the scene's text, from its name on.
    fn place(&self) -> Range<usize> {
        self.name_at..self.offset + self.text.len()
    }

    fn error(&self, origin: &Origin, error: ReadError) -> SceneError {
        self.error_of(None, origin, error)
    }

    /// The error, with what may be written there.
    fn error_of(&self, form: Option<&Value>, origin: &Origin, error: ReadError) -> SceneError {
        let name = name_and_rest(self.text).map_or("", |(name, _)| name);
        let form = form.and_then(|form| match form {
            Value::OneOf(forms) => forms.iter().find(|form| form.name == name)?.value.as_ref(),
            form => Some(form),
        });
        let subject =
            Subject { owner: &self.owner, field: error.field.as_deref(), form: form.map(|form| (name, form)) };
        let span = &error.cause.span;
        let at = match place(&error.cause.code, &subject) {
            At::Token => self.offset + offset_of(self.text, span.start),
            At::Next => self.offset + offset_of(self.text, span.end),
            At::Owner => self.name_at,
        };
        let (message, hint) = explain(&error.cause.code, &subject, &origin.text[at..]);
        origin.error(Some(at), message, hint).because(error)
    }
}

/// Byte offset of a line and column, both counted from 1.
fn offset_of(text: &str, position: Position) -> usize {
    let lines: usize = text.split_inclusive('\n').take(position.line.saturating_sub(1)).map(str::len).sum();
    let column = text[lines..].char_indices().nth(position.col.saturating_sub(1));
    column.map_or(text.len(), |(bytes, _)| lines + bytes)
}

/// Reads the text of `origin`, whose places are not yet known.
pub(super) fn parse(origin: &Origin) -> Result<(Scene, Places), SceneError> {
    let text = &origin.text[..];
    if text.trim().is_empty() {
        let hint = "a scene begins with `Scene(geometry: PlaneStrain, punch: ..., force: ..., stack: [...])`";
        return Err(origin.error(None, "the text is empty".into(), Some(hint.into())));
    }
    let start = text.len() - without_comments(text).len();
    let whole = Part { text, offset: 0, name_at: start, owner: "the scene".into() };
    let draft: Draft = read_ron(text).map_err(|error| {
        // a text with a mistake in its punctuation is read with its units: the mistake is told, not the first number with a unit
        let span = &error.cause.span;
        let is_quoted = [span.start, span.end].into_iter().any(|position| {
            let rest = text.get(offset_of(text, position)..).unwrap_or_default();
            rest.trim_start().starts_with('"')
        });
        let syntax = is_quoted.then(|| read_ron::<IgnoredAny>(text).err()).flatten();
        let mut error = syntax.unwrap_or(error);
        // punch and stack are only skipped here: what is wrong within them is wrong with the text
        error.field = error.field.filter(|field| !matches!(&field[..], "punch" | "load" | "stack"));
        whole.error_of(Some(&Value::of_schema(&schema_of_scene())), origin, error)
    })?;
    let (owner, top) = what_presses(&draft, &whole, origin)?;
    let force = force(&draft, &whole, origin)?;
    let punch = Part { owner: owner.into(), ..part(text, top.get_ron()) };
    let list = Part { owner: "the stack".into(), ..part(text, draft.stack.get_ron()) };
    let items: Vec<&RawValue> = read_ron(list.text).map_err(|error| list.error(origin, error))?;
    if items.len() > MAX_ITEMS {
        let message = format!("the stack has {} items; allowed are at most {MAX_ITEMS}", items.len());
        return Err(origin.error(Some(list.name_at), message, None));
    }
    let items: Vec<Part> = items.into_iter().map(|item| part(text, item.get_ron())).collect();
    let places = Places { punch: punch.place(), stack: list.place(), items: items.iter().map(Part::place).collect() };

    let given = draft.load.is_some();
    let form = || form_of_top(given, draft.geometry);
    let read = read_top(punch.text, given, draft.geometry);
    let punch = read.map_err(|error| punch.error_of(Some(&form()), origin, error))?;
    let mut stack = Vec::with_capacity(items.len());
    let mut layers = 0;
    for item in items {
        let item = read_item(item, layers + 1, origin, &origin.registry)?;
        layers += usize::from(!item.is_interface());
        stack.push(item);
    }
    let Draft { name, description, units, geometry, .. } = draft;
    Ok((Scene { name, description, units, ..Scene::new(geometry, punch, force, stack) }, places))
}

/// What presses on top, and what it is called in messages.
fn what_presses<'a>(
    draft: &Draft<'a>,
    whole: &Part,
    origin: &Origin,
) -> Result<(&'static str, &'a RawValue), SceneError> {
    let text = &origin.text[..];
    match (draft.punch, draft.load) {
        (Some(punch), None) => Ok(("the punch", punch)),
        (None, Some(load)) => Ok(("the load", load)),
        (Some(_), Some(load)) => {
            let at = part(text, load.get_ron()).name_at;
            let hint = "a load takes the place of a punch: remove one of them";
            Err(origin.error(Some(at), "the scene has `punch` and `load`".into(), Some(hint.into())))
        }
        (None, None) => {
            let hint = "add `punch: ...` or, for a given pressure, `load: ...` between its parentheses";
            let message = "`punch` is missing in the scene".into();
            Err(origin.error(Some(whole.name_at), message, Some(hint.into())))
        }
    }
}

/// The force, or what it is found for.
fn force(draft: &Draft, whole: &Part, origin: &Origin) -> Result<Force, SceneError> {
    let given = |force: fn(f64) -> Force, number: Option<Positive>| number.map(|number| force(number.get()));
    let all = [
        given(Force::Given, draft.force),
        given(Force::ForHalfLength, draft.half_length),
        given(Force::ForDepth, draft.depth),
    ];
    let given: Vec<Force> = all.into_iter().flatten().collect();
    let (other, name, hint) = match given[..] {
        [Force::Given(force)] => return Ok(Force::Given(force)),
        [found] if draft.load.is_none() => return Ok(found),
        [found] => ("load", found.field(), "no force changes how far a load reaches: give its resultant, `force: ...`"),
        [] => {
            let hint = "add `force: ...` or, for a punch, `half_length: ...` or `depth: ...` between its parentheses";
            let message = "`force` is missing in the scene".into();
            return Err(origin.error(Some(whole.name_at), message, Some(hint.into())));
        }
        [first, second, ..] => (
            first.field(),
            second.field(),
            "`force` is given, or found for `half_length` or `depth`: remove one of them",
        ),
    };
    let at = field(&origin.text, name).map_or(whole.name_at, |value| part(&origin.text, value).name_at);
    let message = format!("the scene has `{other}` and `{name}`");
    Err(origin.error(Some(at), message, Some(hint.into())))
}

/// Reads a punch, or the load that is `given` in its place.
pub(super) fn read_top(text: &str, given: bool, geometry: Geometry) -> Result<Punch, ReadError> {
    match (geometry, given) {
        (Geometry::Axisymmetric, true) => read_ron::<RoundLoad>(text).map(|load| Punch::Given(load.into())),
        (Geometry::Axisymmetric, false) => read_ron::<RoundPunch>(text).map(Punch::from),
        (_, true) => read_ron(text).map(Punch::Given),
        (_, false) => read_ron(text),
    }
}

/// What may be written there.
fn form_of_top(given: bool, geometry: Geometry) -> Value {
    match (geometry, given) {
        (Geometry::Axisymmetric, true) => Value::of::<RoundLoad>(),
        (Geometry::Axisymmetric, false) => Value::of::<RoundPunch>(),
        (_, true) => Value::of::<Load>(),
        (_, false) => Value::of::<Punch>(),
    }
}

/// Reads the item that is, or would be, layer `number`.
pub(super) fn read_item(item: Part, number: usize, origin: &Origin, registry: &Registry) -> Result<Item, SceneError> {
    let names = || Item::names(registry);
    let Some((name, fields)) = name_and_rest(item.text) else {
        let message = format!("a layer or an interface is expected, found {}", token(&origin.text[item.name_at..]));
        let hint = format!("allowed are {}", quoted_list(&names()));
        return Err(origin.error(Some(item.name_at), message, Some(hint)));
    };
    if let Some(plain) = Item::plain(name) {
        let fields = without_comments(fields);
        if fields.is_empty() {
            return Ok(plain);
        }
        let at = item.offset + item.text.len() - fields.len();
        let message = format!("`{name}` has no fields, found {}", token(fields));
        return Err(origin.error(Some(at), message, Some(format!("write `{name}` alone"))));
    }
    let fields = |owner: String| {
        let offset = item.offset + item.text.len() - fields.len();
        Part { text: fields, offset, name_at: item.name_at, owner }
    };
    if name == SPRING {
        let fields = fields(format!("the springs below layer {}", number - 1));
        let form = || Value::of::<Spring>();
        return read_ron(fields.text).map(Item::Spring).map_err(|error| fields.error_of(Some(&form()), origin, error));
    }
    let Some(entry) = registry.get(name) else {
        let message = format!("no layer or interface is called `{name}`; allowed are {}", quoted_list(&names()));
        return Err(origin.error(Some(item.name_at), message, instead_of(name, &names())));
    };
    let fields = fields(format!("layer {number} ({name})"));
    match (entry.read)(fields.text) {
        Ok(body) => Ok(Item::of(body)),
        Err(error) => Err(fields.error_of(entry.describe().as_ref(), origin, error)),
    }
}
