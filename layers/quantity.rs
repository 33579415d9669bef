//! Checked numbers: rejected with a reason where they are read, so that a scene's error names its column.
#[cfg(feature = "read")]
use std::borrow::Cow;
use std::f64::consts::FRAC_PI_2;
use std::fmt;

#[cfg(feature = "read")]
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

use crate::Parameter;
#[cfg(feature = "read")]
use crate::description::Value;

/// A number outside the range of its quantity.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("found {found:?}, allowed is {allowed}")]
pub struct OutOfRange {
    /// The offending value.
    pub found: f64,
    /// What is allowed, in words.
    pub allowed: &'static str,
}

macro_rules! quantity {
    ($(#[$doc:meta])* $name:ident, $allowed:literal, $range:tt, $test:expr) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, PartialOrd, Serialize, Deserialize)]
        #[serde(try_from = "f64", into = "f64")]
        pub struct $name(f64);

        #[cfg(feature = "read")]
        impl JsonSchema for $name {
            fn schema_name() -> Cow<'static, str> {
                stringify!($name).into()
            }

            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                // a text is a number with a unit
                let mut schema = schemars::json_schema!($range);
                schema.insert("type".to_owned(), serde_json::json!(["number", "string"]));
                Value::described($allowed, schema)
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Debug::fmt(&self.0, f)
            }
        }

        impl $name {
            /// The number itself.
            pub fn get(self) -> f64 {
                self.0
            }
        }

        impl Parameter for $name {
            fn written(&self) -> String {
                self.0.written()
            }
        }

        impl TryFrom<f64> for $name {
            type Error = OutOfRange;
            fn try_from(found: f64) -> Result<Self, OutOfRange> {
                let legal: fn(f64) -> bool = $test;
                if legal(found) { Ok(Self(found)) } else { Err(OutOfRange { found, allowed: $allowed }) }
            }
        }

        impl From<$name> for f64 {
            fn from(value: $name) -> f64 {
                value.0
            }
        }
    };
}

quantity!(
    /// A positive number, such as a shear modulus, a radius or a force.
    Positive, "a finite number > 0", {"exclusiveMinimum": 0}, |x| x > 0.0 && x.is_finite());
quantity!(
    /// A thickness: zero means "not there".
    Thickness, "a finite number >= 0 (0 means: not there)", {"minimum": 0}, |x| x >= 0.0 && x.is_finite());

impl Positive {
    /// 1.
    pub const ONE: Self = Self(1.0);
}

impl Finite {
    /// 0.
    pub const ZERO: Self = Self(0.0);
}

impl From<Thickness> for Finite {
    fn from(value: Thickness) -> Self {
        Self(value.0)
    }
}

impl From<Positive> for Thickness {
    fn from(value: Positive) -> Self {
        Self(value.0)
    }
}

quantity!(
    /// A pressure, or a weight per volume, that does not pull.
    Pressing, "a finite number >= 0", {"minimum": 0}, |x| x >= 0.0 && x.is_finite());
quantity!(
    /// A force that presses; 0 is none, which only weights allow.
    Compressive, "a finite number > 0", {"minimum": 0}, |x| x >= 0.0 && x.is_finite());
quantity!(
    /// Poisson's ratio of an isotropic material.
    Poisson, "-1 < poisson <= 0.5", {"exclusiveMinimum": -1, "maximum": 0.5}, |x| x > -1.0 && x <= 0.5);
quantity!(
    /// Any finite number, such as a grading exponent.
    Finite, "a finite number", {}, f64::is_finite);
quantity!(
    /// How fast a half-plane stiffens with depth.
    Stiffening, "a finite number >= 0 (a half-plane that softens without end carries no force)", {"minimum": 0},
    |x| x >= 0.0 && x.is_finite());
quantity!(
    /// The power of the depth with which the modulus of a half-plane varies.
    Carrying, "a finite number > -1 (a half-plane that softens faster carries no force)", {"exclusiveMinimum": -1},
    |x| x > -1.0 && x.is_finite());
quantity!(
    /// An exponent, such as n of a profile |x|^n.
    Exponent, "a number from 1 to 100", {"minimum": 1, "maximum": 100}, |x| (1.0..=100.0).contains(&x));
quantity!(
    /// Half of the angle at the tip of a wedge or a cone, in radians.
    HalfAngle, "an angle > 0 and < pi/2, in radians or with its unit, such as \"70.3 deg\"",
    {"exclusiveMinimum": 0, "exclusiveMaximum": FRAC_PI_2}, |x| x > 0.0 && x < FRAC_PI_2);
