//! A scene as JSON, to be read again, and the JSON Schema of all scenes.
use recede_layers::description::{schema_of, without_ranges};
use recede_layers::{Registry, read_ron};
use serde_json::{Map, Value, json};

use super::read::schema_of_scene;
use super::round::{RoundLoad, RoundPunch};
use super::text::{fields, members, name_and_rest, without_comments};
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
        let text = self.to_ron();
        // the name of a scene is not needed, as there is nothing else
        let scene = match value(&text) {
            Value::Object(mut named) => named.remove("Scene").unwrap_or(Value::Object(named)),
            other => other,
        };
        visible_json(&format!("{scene:#}\n"))
    }
}

/// A value in RON as JSON.
fn value(text: &str) -> Value {
    let text = without_comments(text).trim_end();
    if text.starts_with('"') {
        return read_ron::<String>(text).map_or(Value::Null, Value::String);
    }
    let (name, rest) = name_and_rest(text).map_or((None, text), |(name, rest)| (Some(name), without_comments(rest)));
    let fields = fields(text);
    let inner = match (name, &fields[..]) {
        (Some("true"), _) => return Value::Bool(true),
        (Some("false"), _) => return Value::Bool(false),
        (Some(name), _) if rest.is_empty() => return Value::String(name.to_owned()),
        (None, []) if !rest.starts_with(['(', '[']) => return number(text),
        (_, []) => {
            let mut members: Vec<Value> = members(text).into_iter().map(value).collect();
            // the one thing that a name stands for
            if name.is_some() && members.len() == 1 { members.remove(0) } else { Value::Array(members) }
        }
        (_, fields) => fields.iter().map(|(name, inner)| (name.clone(), value(inner))).collect::<Map<_, _>>().into(),
    };
    match name {
        Some(name) => Value::Object([(name.to_owned(), inner)].into_iter().collect()),
        None => inner,
    }
}

fn number(text: &str) -> Value {
    text.parse::<i64>().map(Value::from).or_else(|_| text.parse::<f64>().map(Value::from)).unwrap_or(Value::Null)
}

/// The JSON Schema of scenes whose layers are those of `registry`, for editors and for programs that write scenes.
///
/// ```
/// use recede::{Registry, scene_schema};
/// let schema = scene_schema(&Registry::default());
/// assert_eq!(schema["properties"]["geometry"]["oneOf"][0]["const"], "PlaneStrain");
/// ```
pub fn scene_schema(registry: &Registry) -> Value {
    let (interfaces, rigid) = Item::forms();
    let plain = interfaces.iter().chain([&rigid]).filter(|form| form.value.is_none());
    let names = plain.map(|form| json!({"const": form.name, "description": form.meaning}));
    let item = |name: &str, meaning: &str, inner: Value| json!({"type": "object", "description": meaning, "properties": {name: inner}, "required": [name], "additionalProperties": false});
    let springs = interfaces.iter().filter(|form| form.value.is_some());
    let springs = springs.map(|form| item(&form.name, &form.meaning, schema_of::<Spring>().to_value()));
    let layers = registry.iter().map(|entry| {
        let fields = entry.schema.map_or_else(|| json!({"type": "object"}), |schema| schema().to_value());
        item(entry.name, entry.summary, fields)
    });
    let mut schema = schema_of_scene().to_value();
    // about the axis punches and loads have other names
    let round = json!({"punch": schema_of::<RoundPunch>().to_value(), "load": schema_of::<RoundLoad>().to_value()});
    let mut plane = json!({});
    for field in ["punch", "load"] {
        plane[field] = schema["properties"][field].take();
        schema["properties"][field] = json!({});
    }
    let of = |names: &[&str], fields: Value| {
        let mut fields = fields;
        fields["geometry"] = json!({"enum": names});
        json!({"properties": fields})
    };
    schema["anyOf"] = json!([of(&["PlaneStrain", "PlaneStress"], plane), of(&["Axisymmetric"], round)]);
    schema["properties"]["stack"]["type"] = "array".into();
    schema["properties"]["stack"]["items"] = json!({"oneOf": layers.chain(springs).chain(names).collect::<Vec<_>>()});
    // a scene may name its schema, for editors
    schema["properties"]["$schema"] = json!({"type": "string"});
    without_ranges(&mut schema);
    schema
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_all_kinds_have_their_forms() {
        let text = "Several([(at: 0, share: 1e0, load: Line), (at: -1.5, load: Uniform(half_width: 2))])";
        let expected = json!({"Several": [
            {"at": 0, "share": 1.0, "load": "Line"},
            {"at": -1.5, "load": {"Uniform": {"half_width": 2}}},
        ]});
        assert_eq!(value(text), expected);
        assert_eq!(value("Table([(0, 1), (0.5, 2)])"), json!({"Table": [[0, 1], [0.5, 2]]}));
        assert_eq!(value("/* a */ Constant(3) // b"), json!({"Constant": 3}));
        assert_eq!(value("\"a \\\"b\\\"\""), json!("a \"b\""));
    }
}
