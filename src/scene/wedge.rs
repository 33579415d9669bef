//! The inclination of a wedge or a cone, as it is written.
use recede_layers::{HalfAngle, LayerError, Positive, described};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::ValueError;

/// How steep the faces of a [`Punch::Wedge`](crate::Punch::Wedge) are, by their slope or by their angle with the axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "WedgeFields", into = "WedgeFields")]
pub struct Wedge {
    fields: WedgeFields,
    slope: Positive,
}

/// The fields as written in a scene, before they are checked together.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Wedge")]
struct WedgeFields {
    /// Slope s of its surface, dimensionless: the tangent of its angle with the stack; or in its place `half_angle`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    slope: Option<Positive>,
    /// Angle of its surface with the axis x = 0, half of the angle at the tip; or in its place `slope`, its cotangent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    half_angle: Option<HalfAngle>,
    /// Slope of its surface on the left, x < 0, if that is not as steep as `slope` on the right; dimensionless.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    left: Option<Positive>,
}

/// A wedge about the axis, which is as steep on all sides.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
#[serde(try_from = "ConeFields", into = "ConeFields")]
pub(super) struct Cone(pub(super) Wedge);

/// The fields of a cone as written in a scene.
#[derive(Clone, Copy, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Cone")]
struct ConeFields {
    /// Slope s of its surface, dimensionless: the tangent of its angle with the stack; or in its place `half_angle`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    slope: Option<Positive>,
    /// Angle of its surface with the axis, half of the angle at the tip; or in its place `slope`, its cotangent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    half_angle: Option<HalfAngle>,
}

described!(Wedge by WedgeFields);
described!(Cone by ConeFields);

impl TryFrom<WedgeFields> for Wedge {
    type Error = LayerError;

    fn try_from(fields: WedgeFields) -> Result<Self, LayerError> {
        let either_or = |found, fields| LayerError::EitherOr { found, fields };
        let slope = match (fields.slope, fields.half_angle) {
            (Some(slope), None) => slope,
            (None, Some(_)) if fields.left.is_some() => return Err(either_or("both", ["half_angle", "left"])),
            (None, Some(angle)) => LayerError::checked("half_angle", libm::tan(angle.get()).recip())?,
            (None, None) => return Err(either_or("none", ["slope", "half_angle"])),
            (Some(_), Some(_)) => return Err(either_or("both", ["slope", "half_angle"])),
        };
        Ok(Self { fields, slope })
    }
}

impl TryFrom<ConeFields> for Cone {
    type Error = LayerError;

    fn try_from(ConeFields { slope, half_angle }: ConeFields) -> Result<Self, LayerError> {
        WedgeFields { slope, half_angle, left: None }.try_into().map(Self)
    }
}

impl From<Wedge> for WedgeFields {
    fn from(wedge: Wedge) -> Self {
        wedge.fields
    }
}

impl From<Cone> for ConeFields {
    fn from(Cone(Wedge { fields: WedgeFields { slope, half_angle, .. }, .. }): Cone) -> Self {
        Self { slope, half_angle }
    }
}

impl Wedge {
    /// A wedge of this slope > 0, dimensionless, and with another slope > 0 on the left, if there is one.
    pub(super) fn of_slope(slope: f64, left: Option<f64>) -> Result<Self, ValueError> {
        let slope = ValueError::checked("slope", slope)?;
        let left = left.map(|left| ValueError::checked("left", left)).transpose()?;
        Ok(Self { fields: WedgeFields { slope: Some(slope), half_angle: None, left }, slope })
    }

    /// A wedge with this angle to the axis, 0 < angle < π/2, in radians.
    pub(super) fn of_half_angle(angle: f64) -> Result<Self, ValueError> {
        let half_angle = Some(ValueError::checked("half_angle", angle)?);
        Ok(Self::try_from(WedgeFields { slope: None, half_angle, left: None })?)
    }

    /// Slope of its faces, dimensionless; where they are not as steep, of the one on the right.
    pub fn slope(&self) -> f64 {
        self.slope.get()
    }

    /// Slope of its face on the left, dimensionless, counted outwards.
    pub fn left(&self) -> f64 {
        self.fields.left.map_or(self.slope(), Positive::get)
    }
}
