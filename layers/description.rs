//! What may be written in a scene, told by the definitions that read it: names, ranges and documentation of the fields
//! come from the types that serde reads.
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};
use serde_json::Value as Json;

/// The keyword under which a checked number tells its range.
const ALLOWED: &str = "allowed";

/// Describes a type that is read `by` other fields, which are checked together: they are what may be written; or `in` words.
#[macro_export]
macro_rules! described {
    ($name:ident by $fields:ident) => {
        $crate::described!($name, |generator| <$fields as schemars::JsonSchema>::json_schema(generator));
    };
    ($name:ident in $words:literal) => {
        $crate::described!($name, |_| $crate::description::Value::plain_schema($words));
    };
    ($name:ident, $schema:expr) => {
        impl schemars::JsonSchema for $name {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($name).into()
            }

            fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                let schema: fn(&mut schemars::SchemaGenerator) -> schemars::Schema = $schema;
                schema(generator)
            }
        }
    };
}

/// A field of a layer, a punch or a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// Its name, e.g. `shear_modulus`.
    pub name: String,
    /// Its meaning, a sentence.
    pub meaning: String,
    /// Whether it may be left out.
    pub optional: bool,
    /// What may be written.
    pub value: Value,
}

/// What may be written at some place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// A number, a text or a list, in words.
    Plain(String),
    /// Fields in parentheses.
    Fields(Vec<Field>),
    /// One of several names, with what follows them.
    OneOf(Vec<Form>),
}

/// A name that stands for a type or for one of several forms, with what follows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Form {
    /// The name, e.g. `Homogeneous`.
    pub name: String,
    /// Its meaning, a sentence.
    pub meaning: String,
    /// What follows in parentheses; `None` if nothing does.
    pub value: Option<Value>,
}

impl Value {
    /// What a value of type `T` is read from.
    ///
    /// ```
    /// use recede_layers::{Homogeneous, description::Value};
    /// let Value::Fields(fields) = Value::of::<Homogeneous>() else { unreachable!() };
    /// let names: Vec<&str> = fields.iter().map(|field| &field.name[..]).collect();
    /// assert_eq!(names, ["thickness", "shear_modulus", "young", "poisson"]);
    /// ```
    pub fn of<T: JsonSchema>() -> Self {
        Self::of_schema(&schema_of::<T>())
    }

    /// What a value with this schema is read from.
    pub fn of_schema(schema: &Schema) -> Self {
        Self::from_schema(schema.as_value())
    }

    /// The schema of a value that is described in words; for types that implement [`JsonSchema`] themselves.
    pub fn plain_schema(allowed: &str) -> Schema {
        Self::described(allowed, Schema::default())
    }

    /// A schema, with what it allows in words.
    pub fn described(allowed: &str, mut schema: Schema) -> Schema {
        schema.insert(ALLOWED.to_owned(), allowed.into());
        schema
    }

    fn from_schema(schema: &Json) -> Self {
        if let Some(allowed) = schema[ALLOWED].as_str() {
            return Self::Plain(allowed.to_owned());
        }
        if let Some(properties) = schema["properties"].as_object() {
            return Self::Fields(
                properties.iter().map(|(name, value)| field(name, value, &schema["required"])).collect(),
            );
        }
        let choices = ["oneOf", "anyOf"].iter().find_map(|keyword| schema[*keyword].as_array());
        match choices.map(|choices| choices.iter().filter(|choice| choice["type"] != "null").collect::<Vec<_>>()) {
            // a value that may be left out
            Some(choices) if schema["oneOf"].is_null() && choices.len() == 1 => Self::from_schema(choices[0]),
            Some(choices) => Self::OneOf(choices.into_iter().flat_map(forms).collect()),
            None if schema["enum"].is_array() => Self::OneOf(forms(schema)),
            None => Self::Plain("a text in double quotes".to_owned()),
        }
    }
}

/// The JSON Schema of a type, without references. Ranges of checked numbers are told in words, see [`without_ranges`].
pub fn schema_of<T: JsonSchema>() -> Schema {
    let settings = SchemaSettings::default().with(|settings| settings.inline_subschemas = true);
    settings.into_generator().into_root_schema_for::<T>()
}

/// Puts the words that tell a range, which are no keyword of JSON Schema, into the descriptions.
pub fn without_ranges(schema: &mut Json) {
    match schema {
        Json::Object(keywords) => {
            if let Some(Json::String(allowed)) = keywords.remove(ALLOWED) {
                let meaning = keywords.get("description").and_then(Json::as_str).unwrap_or_default();
                let description = format!("{meaning} Allowed: {allowed}.").trim_start().to_owned();
                keywords.insert("description".to_owned(), description.into());
            }
            keywords.values_mut().for_each(without_ranges);
        }
        Json::Array(list) => list.iter_mut().for_each(without_ranges),
        _ => {}
    }
}

fn field(name: &str, schema: &Json, required: &Json) -> Field {
    let required = required.as_array().is_some_and(|names| names.iter().any(|required| required == name));
    Field { name: name.to_owned(), meaning: meaning(schema), optional: !required, value: Value::from_schema(schema) }
}

/// The variants that one alternative of an enumeration stands for.
fn forms(schema: &Json) -> Vec<Form> {
    let plain = |name: &Json| Form {
        name: name.as_str().unwrap_or_default().to_owned(),
        meaning: meaning(schema),
        value: None,
    };
    if let Some(names) = schema["enum"].as_array() {
        return names.iter().filter(|name| name.is_string()).map(plain).collect();
    }
    if schema["const"].is_string() {
        return vec![plain(&schema["const"])];
    }
    let form = |(name, inner): (&String, &Json)| Form {
        name: name.clone(),
        meaning: meaning(schema),
        value: Some(Value::from_schema(inner)),
    };
    schema["properties"].as_object().into_iter().flatten().map(form).collect()
}

/// The first paragraph of the documentation, in one line.
fn meaning(schema: &Json) -> String {
    let text = schema["description"].as_str().unwrap_or_default();
    let first = text.split("\n\n").next().unwrap_or_default();
    first.split_whitespace().collect::<Vec<_>>().join(" ").replace("[`", "`").replace("`]", "`")
}
