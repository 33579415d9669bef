//! An elastic cylinder, as it is written.
use recede_layers::{ElasticConstants, Isotropic, LayerError, Poisson, Positive, described};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::ValueError;

/// A circular cylinder of an elastic material, see [`Punch::ElasticCylinder`](crate::Punch::ElasticCylinder).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "ElasticCylinderFields", into = "ElasticCylinderFields")]
pub struct ElasticCylinder {
    fields: ElasticCylinderFields,
    constants: ElasticConstants,
}

/// The fields as written in a scene, before they are checked together.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "ElasticCylinder")]
struct ElasticCylinderFields {
    /// Radius R, in length.
    radius: Positive,
    /// Shear modulus of the cylinder, in stress; or in its place `young`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    shear_modulus: Option<Positive>,
    /// Young's modulus of the cylinder, in stress; or in its place `shear_modulus`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    young: Option<Positive>,
    /// Poisson's ratio of the cylinder, dimensionless.
    poisson: Poisson,
}

described!(ElasticCylinder by ElasticCylinderFields);

impl TryFrom<ElasticCylinderFields> for ElasticCylinder {
    type Error = LayerError;

    fn try_from(fields: ElasticCylinderFields) -> Result<Self, LayerError> {
        let ElasticCylinderFields { shear_modulus, young, poisson, .. } = fields;
        Ok(Self { fields, constants: ElasticConstants::read(shear_modulus, young, poisson)? })
    }
}

impl From<ElasticCylinder> for ElasticCylinderFields {
    fn from(cylinder: ElasticCylinder) -> Self {
        cylinder.fields
    }
}

impl ElasticCylinder {
    /// A cylinder of radius R > 0 (length), shear modulus μ > 0 (stress) and Poisson's ratio −1 < ν ≤ 1/2.
    pub(super) fn new(radius: f64, shear_modulus: f64, poisson: f64) -> Result<Self, ValueError> {
        let fields = ElasticCylinderFields {
            radius: ValueError::checked("radius", radius)?,
            shear_modulus: Some(ValueError::checked("shear_modulus", shear_modulus)?),
            young: None,
            poisson: ValueError::checked("poisson", poisson)?,
        };
        Ok(Self::try_from(fields)?)
    }

    /// Radius R, in length.
    pub fn radius(&self) -> f64 {
        self.fields.radius.get()
    }

    /// Its material.
    pub fn material(&self) -> Isotropic {
        self.constants.isotropic()
    }
}
