//! Names of layers.
#[cfg(feature = "read")]
use std::borrow::Cow;
use std::sync::Arc;

use nalgebra::Matrix4x2;
#[cfg(feature = "read")]
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;

#[cfg(feature = "read")]
use crate::description::Value;
use crate::{Key, LayerError, Notation, Parameter, Support, Wave};

/// Most characters of a name.
const LONGEST: usize = 40;
/// What a name may be.
const ALLOWED: &str = "a text of 1 to 40 characters in one line that is no number";

/// The name of a layer, by which reports and pictures call it.
///
/// ```
/// use recede_layers::Name;
/// assert_eq!(Name::new("asphalt")?.as_str(), "asphalt");
/// assert!(["", "2", " "].iter().all(|text| Name::new(text).is_err()));
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
pub struct Name(Arc<str>);

impl Name {
    /// A name; white space around it is left out.
    ///
    /// # Errors
    /// [`LayerError::Name`] if it is empty, a number, longer than 40 characters or more than one line.
    pub fn new(text: &str) -> Result<Self, LayerError> {
        let name = text.trim();
        let is_legal = (1..=LONGEST).contains(&name.chars().count())
            && !name.contains(char::is_control)
            && name.parse::<f64>().is_err();
        if is_legal { Ok(Self(name.into())) } else { Err(LayerError::Name { found: text.into(), allowed: ALLOWED }) }
    }

    /// The text.
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

impl TryFrom<String> for Name {
    type Error = LayerError;

    fn try_from(text: String) -> Result<Self, LayerError> {
        Self::new(&text)
    }
}

#[cfg(feature = "read")]
impl JsonSchema for Name {
    fn schema_name() -> Cow<'static, str> {
        "Name".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        Value::described(ALLOWED, json_schema!({"type": "string", "minLength": 1, "maxLength": LONGEST}))
    }
}

impl Parameter for Name {
    fn written(&self) -> String {
        format!("\"{}\"", self.0.replace('\\', "\\\\").replace('"', "\\\""))
    }
}

/// What a layer is called in reports and pictures: `layer 2`, or with a name `layer 2 "sand"`.
pub fn layer_label(number: usize, name: Option<&str>) -> String {
    name.map_or_else(|| format!("layer {number}"), |name| format!("layer {number} \"{name}\""))
}

/// A support with a name; all else is the support's own.
#[derive(Clone, Debug)]
pub struct NamedSupport {
    /// The support.
    pub support: Arc<dyn Support>,
    /// Its name.
    pub name: Name,
}

// A provided method that is not passed on would answer for the wrapped support with what is provided: clippy finds each one.
#[deny(clippy::missing_trait_methods)]
impl Support for NamedSupport {
    fn face_states(&self, wave: &Wave) -> Matrix4x2<f64> {
        self.support.face_states(wave)
    }

    fn notation(&self) -> Notation {
        self.support.notation().named(&self.name)
    }

    fn key(&self) -> Option<Key> {
        self.support.key()
    }

    fn name(&self) -> Option<&str> {
        Some(self.name.as_str())
    }
}
