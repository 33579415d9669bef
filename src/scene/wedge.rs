//! The inclination of a wedge or a cone, as it is written.
use std::borrow::Cow;

use recede_layers::{HalfAngle, LayerError, Positive};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

use super::ValueError;

/// How steep the faces of a [`Punch::Wedge`](crate::Punch::Wedge) are, by their slope or by their angle with the axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Fields", into = "Fields")]
pub struct Wedge {
    fields: Fields,
    slope: Positive,
}

/// The fields as written in a scene, before they are checked together.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Wedge")]
struct Fields {
    /// Slope s of its surface, dimensionless: the tangent of its angle with the stack; or in its place `half_angle`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    slope: Option<Positive>,
    /// Angle of its surface with the axis x = 0, half of the angle at the tip; or in its place `slope`, its cotangent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    half_angle: Option<HalfAngle>,
}

impl JsonSchema for Wedge {
    fn schema_name() -> Cow<'static, str> {
        "Wedge".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        Fields::json_schema(generator)
    }
}

impl TryFrom<Fields> for Wedge {
    type Error = LayerError;

    fn try_from(fields: Fields) -> Result<Self, LayerError> {
        let either_or = |found| LayerError::EitherOr { found, fields: ["slope", "half_angle"] };
        let slope = match (fields.slope, fields.half_angle) {
            (Some(slope), None) => slope,
            (None, Some(angle)) => LayerError::checked("half_angle", libm::tan(angle.get()).recip())?,
            (None, None) => return Err(either_or("none")),
            (Some(_), Some(_)) => return Err(either_or("both")),
        };
        Ok(Self { fields, slope })
    }
}

impl From<Wedge> for Fields {
    fn from(wedge: Wedge) -> Self {
        wedge.fields
    }
}

impl Wedge {
    /// Of this slope > 0, dimensionless.
    pub(super) fn of_slope(slope: f64) -> Result<Self, ValueError> {
        let slope = ValueError::checked("slope", slope)?;
        Ok(Self { fields: Fields { slope: Some(slope), half_angle: None }, slope })
    }

    /// Of this angle with the axis, 0 < angle < π/2, in radians.
    pub(super) fn of_half_angle(angle: f64) -> Result<Self, ValueError> {
        let half_angle = Some(ValueError::checked("half_angle", angle)?);
        Ok(Self::try_from(Fields { slope: None, half_angle })?)
    }

    /// Slope of its faces, dimensionless.
    pub fn slope(&self) -> f64 {
        self.slope.get()
    }
}
