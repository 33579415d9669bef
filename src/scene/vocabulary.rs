//! All that may be written in a scene, from the definitions that read it.
use recede_layers::description::{Field, Form, Value, schema_of, without_ranges};
use recede_layers::{Entry, Registry};
use serde_json::{Value as Json, json};

use super::item::RECEDING;
use super::read::Draft;
use super::read_item::{CommonFields, NAME, Receding};
use super::read_top::TOPS;
use super::round::{RoundLoad, RoundPunch};
use super::{Item, Load, Punch, Spring};

/// The field that a layer has and a base has not.
const THICKNESS: &str = "thickness";

/// Names that may be written in a scene, with their fields and what they mean. Made of the definitions that read scenes, so
/// that it says what they do.
///
/// ```
/// use recede::{Registry, Vocabulary};
/// let vocabulary = Vocabulary::new(&Registry::default());
/// assert!(vocabulary.layers.iter().any(|layer| layer.name == "Homogeneous"));
/// assert!(vocabulary.interfaces.iter().any(|interface| interface.name == "Sliding"));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Vocabulary {
    /// The fields of a scene.
    pub scene: Vec<Field>,
    /// Punches.
    pub punches: Vec<Form>,
    /// Pressures that may be given in place of a punch.
    pub loads: Vec<Form>,
    /// Punches of axisymmetric scenes.
    pub round_punches: Vec<Form>,
    /// Loads of axisymmetric scenes.
    pub round_loads: Vec<Form>,
    /// Layers of finite thickness.
    pub layers: Vec<Form>,
    /// Interfaces between layers.
    pub interfaces: Vec<Form>,
    /// What may stand last in a stack.
    pub bases: Vec<Form>,
}

impl Vocabulary {
    /// The words of scenes with the layers of `registry`. A type without a field `thickness` counts as a base, and of
    /// one that was registered without a [description](Registry::register_described) only the name is known.
    pub fn new(registry: &Registry) -> Self {
        let registered = registry.iter().map(|entry| Form {
            name: entry.name.to_owned(),
            meaning: entry.summary.to_owned(),
            value: schema_of_entry(entry).and_then(|schema| Some(Value::of_schema(&schema.try_into().ok()?))),
        });
        let is_base = |form: &Form| match &form.value {
            Some(Value::Fields(fields)) => fields.iter().all(|field| field.name != THICKNESS),
            _ => false,
        };
        let (mut bases, layers): (Vec<Form>, Vec<Form>) = registered.partition(is_base);
        let mut interfaces = Item::forms();
        // the last is the rigid base
        bases.extend(interfaces.pop());
        Self {
            scene: if let Value::Fields(fields) = Value::of::<Draft>() { fields } else { Vec::new() },
            punches: alternatives(Value::of::<Punch>()),
            loads: alternatives(Value::of::<Load>()),
            round_punches: alternatives(Value::of::<RoundPunch>()),
            round_loads: alternatives(Value::of::<RoundLoad>()),
            layers,
            interfaces,
            bases,
        }
    }
}

/// What stands in place of a value of several forms.
fn alternatives(value: Value) -> Vec<Form> {
    if let Value::OneOf(forms) = value { forms } else { Vec::new() }
}

/// The JSON Schema of the fields of a layer or base, with the common ones; `None` if the type has none.
fn schema_of_entry(entry: &Entry) -> Option<Json> {
    let mut fields = entry.schema?().to_value();
    let is_thick = fields["properties"].get(THICKNESS).is_some();
    if let Json::Object(common) = schema_of::<CommonFields>().to_value()["properties"].take() {
        let own = common.into_iter().filter(|(name, _)| is_thick || name == NAME);
        own.for_each(|(name, field)| fields["properties"][name] = field);
    }
    Some(fields)
}

/// The JSON Schema of scenes with the layers of `registry`, for editors and for programs that write scenes.
///
/// ```
/// use recede::{Registry, scene_schema};
/// let schema = scene_schema(&Registry::default());
/// assert_eq!(schema["properties"]["geometry"]["oneOf"][0]["const"], "PlaneStrain");
/// ```
pub fn scene_schema(registry: &Registry) -> Json {
    let (plain, springs): (Vec<Form>, Vec<Form>) = Item::forms().into_iter().partition(|form| form.value.is_none());
    let names = plain.iter().map(|form| json!({"const": form.name, "description": form.meaning}));
    let item = |name: &str, meaning: &str, inner: Json| json!({"type": "object", "description": meaning, "properties": {name: inner}, "required": [name], "additionalProperties": false});
    let springs = springs.iter().map(|form| item(&form.name, &form.meaning, schema_of::<Spring>().to_value()));
    // the gap of a receding interface is of the shape of a punch, in the plane or about an axis
    let mut gap = schema_of::<Receding>().to_value();
    gap["properties"]["gap"] = json!({
        "description": gap["properties"]["gap"]["description"],
        "anyOf": [schema_of::<Punch>().to_value(), schema_of::<RoundPunch>().to_value()],
    });
    let gap = item(RECEDING, "", gap);
    let layers = registry.iter().map(|entry| {
        item(entry.name, entry.summary, schema_of_entry(entry).unwrap_or_else(|| json!({"type": "object"})))
    });
    let mut schema = schema_of::<Draft>().to_value();
    // about the axis punches and loads have other names
    let (punch, load) = (schema_of::<RoundPunch>().to_value(), schema_of::<RoundLoad>().to_value());
    let loads = schema["properties"]["loads"].clone();
    let round =
        json!({"punch": punch, "punches": false, "load": load, "loads": loads, "geometry": {"enum": ["Axisymmetric"]}});
    let mut plane = json!({});
    for field in TOPS {
        plane[field] = schema["properties"][field].take();
        schema["properties"][field] = json!({});
    }
    plane["geometry"] = json!({"enum": ["PlaneStrain", "PlaneStress"]});
    schema["anyOf"] = json!([{"properties": plane}, {"properties": round}]);
    schema["properties"]["stack"]["type"] = "array".into();
    schema["properties"]["stack"]["items"] =
        json!({"oneOf": layers.chain(names).chain(springs).chain([gap]).collect::<Vec<_>>()});
    // a scene may name its schema, for editors
    schema["properties"]["$schema"] = json!({"type": "string"});
    without_ranges(&mut schema);
    schema
}
