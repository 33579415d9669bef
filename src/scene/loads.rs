//! Lists of given pressures that press at once, checked where they are read.
use std::borrow::Cow;

use recede_layers::description::Value;
use recede_layers::{Positive, Thickness};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

use super::load::Load;

/// Most loads in a list.
const MOST: usize = 1000;

/// A list of loads that is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LoadsError {
    /// Too few or too many of them.
    #[error("there are {0} loads; allowed are 1 to {MOST}")]
    Count(usize),
    /// A list within a list.
    #[error("`Several` stands within `Several`; allowed are `Line`, `Uniform`, `Parabolic`, `Elliptic`")]
    Nested,
}

/// One of several loads, and its mirror image if it is not in the middle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Part {
    /// Distance of its middle from x = 0, in length.
    pub(super) at: Thickness,
    /// Its part of the force, mirror image included, in relation to the other parts.
    pub(super) share: Positive,
    /// What presses there.
    pub(super) load: Load,
}

/// Loads that press at once.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<Part>", into = "Vec<Part>")]
pub struct Loads(Vec<Part>);

impl Loads {
    /// Distance of each from x = 0, its part of the force, of which all are 1 together, and what it is.
    pub(super) fn parts(&self) -> Vec<(f64, f64, &Load)> {
        // shares may be so large that their sum is not finite
        let largest = self.0.iter().fold(0.0, |largest: f64, part| largest.max(part.share.get()));
        let sum: f64 = self.0.iter().map(|part| part.share.get() / largest).sum();
        self.0.iter().map(|part| (part.at.get(), part.share.get() / largest / sum, &part.load)).collect()
    }
}

impl From<Loads> for Vec<Part> {
    fn from(loads: Loads) -> Self {
        loads.0
    }
}

impl TryFrom<Vec<Part>> for Loads {
    type Error = LoadsError;

    fn try_from(parts: Vec<Part>) -> Result<Self, LoadsError> {
        if parts.is_empty() || parts.len() > MOST {
            return Err(LoadsError::Count(parts.len()));
        }
        if parts.iter().any(|part| matches!(part.load, Load::Several(_))) {
            return Err(LoadsError::Nested);
        }
        Ok(Self(parts))
    }
}

impl JsonSchema for Loads {
    fn schema_name() -> Cow<'static, str> {
        "Loads".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        Value::plain_schema(
            "[(at: x, share: s, load: ...), ...], one or more loads with their distances x >= 0 and shares s > 0",
        )
    }
}
