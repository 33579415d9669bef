//! A scene as JSON, to be read again, and the JSON Schema of all scenes.
use recede_layers::Registry;
use recede_layers::description::{Form, schema_of, without_ranges};
use recede_layers::tree::{Kind, Node};
use serde_json::{Value, json};

use super::read::Draft;
use super::read_top::TOPS;
use super::round::{RoundLoad, RoundPunch};
use super::{Item, Scene, Spring, visible_json};

impl Scene {
    /// The scene in JSON, with the same names as in RON and with all digits: [`Scene::from_json`] reads the same scene from
    /// it. `Homogeneous(thickness: 1.0, ...)` is `{"Homogeneous": {"thickness": 1.0, ...}}`, `Receding` is `"Receding"`.
    ///
    /// ```
    /// use recede::Scene;
    /// let scene = Scene::read("examples/scenes/two_strips.ron")?;
    /// let again = Scene::from_json(&scene.to_json())?;
    /// assert_eq!(again.to_ron(), scene.to_ron());
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn to_json(&self) -> String {
        // the name of a scene is not needed, as there is nothing else
        let scene =
            Node::from_ron(self.to_ron().trim_start_matches("Scene")).map_or(Value::Null, |scene| value(&scene));
        visible_json(&format!("{scene:#}\n"))
    }
}

/// A value as JSON.
fn value(node: &Node) -> Value {
    let inner = match &node.kind {
        Kind::Nothing => Value::Null,
        Kind::Number(number) => json!(number),
        Kind::Text(text) => json!(text),
        Kind::Row(members) if node.name.is_some() && members.len() == 1 => value(&members[0]),
        Kind::List(members) | Kind::Row(members) => members.iter().map(value).collect(),
        Kind::Fields(fields) => fields.iter().map(|field| (field.name.to_string(), value(&field.value))).collect(),
    };
    match (node.name.as_deref(), &node.kind) {
        (None, _) => inner,
        (Some(name @ ("true" | "false")), Kind::Nothing) => Value::Bool(name == "true"),
        (Some(name), Kind::Nothing) => Value::String(name.to_owned()),
        (Some(name), _) => json!({name: inner}),
    }
}

/// The JSON Schema of scenes with the layers of `registry`, for editors and for programs that write scenes.
///
/// ```
/// use recede::{Registry, scene_schema};
/// let schema = scene_schema(&Registry::default());
/// assert_eq!(schema["properties"]["geometry"]["oneOf"][0]["const"], "PlaneStrain");
/// ```
pub fn scene_schema(registry: &Registry) -> Value {
    let (plain, springs): (Vec<Form>, Vec<Form>) = Item::forms().into_iter().partition(|form| form.value.is_none());
    let names = plain.iter().map(|form| json!({"const": form.name, "description": form.meaning}));
    let item = |name: &str, meaning: &str, inner: Value| json!({"type": "object", "description": meaning, "properties": {name: inner}, "required": [name], "additionalProperties": false});
    let springs = springs.iter().map(|form| item(&form.name, &form.meaning, schema_of::<Spring>().to_value()));
    let layers = registry.iter().map(|entry| {
        let fields = entry.schema.map_or_else(|| json!({"type": "object"}), |schema| schema().to_value());
        item(entry.name, entry.summary, fields)
    });
    let mut schema = schema_of::<Draft>().to_value();
    // about the axis punches and loads have other names
    let (punch, load) = (schema_of::<RoundPunch>().to_value(), schema_of::<RoundLoad>().to_value());
    let round =
        json!({"punch": punch, "punches": false, "load": load, "loads": false, "geometry": {"enum": ["Axisymmetric"]}});
    let mut plane = json!({});
    for field in TOPS {
        plane[field] = schema["properties"][field].take();
        schema["properties"][field] = json!({});
    }
    plane["geometry"] = json!({"enum": ["PlaneStrain", "PlaneStress"]});
    schema["anyOf"] = json!([{"properties": plane}, {"properties": round}]);
    schema["properties"]["stack"]["type"] = "array".into();
    schema["properties"]["stack"]["items"] = json!({"oneOf": layers.chain(springs).chain(names).collect::<Vec<_>>()});
    // a scene may name its schema, for editors
    schema["properties"]["$schema"] = json!({"type": "string"});
    without_ranges(&mut schema);
    schema
}
