//! How a quantity varies with depth, as written in a scene.
#[cfg(feature = "read")]
use std::borrow::Cow;

#[cfg(feature = "read")]
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

#[cfg(feature = "read")]
use crate::description::Value;
use crate::{Finite, Key, LayerError, OutOfRange, Parameter, Positive, TableError, Thickness};

/// Beyond so many widths from its centre, a sigmoid is cut off from where it varies.
const WIDTHS: f64 = 8.0;
/// A table reaches the bottom if it does so to rounding.
const REACHED: f64 = 1.0 - 1e-12;

/// How a quantity such as the shear modulus varies with the depth d below the top face of a layer of thickness h.
///
/// `Q` is the checked number that the quantity is, [`Positive`] or [`Poisson`](crate::Poisson).
///
/// ```
/// use recede_layers::{Positive, Profile};
/// let power = Profile::<Positive>::power(2.0, 0.5, 2.0)?;
/// assert_eq!(power.at(0.5, 1.0), 8.0);
/// let table = Profile::<Positive>::table(&[(0.0, 1.0), (0.5, 3.0), (1.0, 2.0)])?;
/// assert_eq!(table.at(0.75, 1.0), 2.5);
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "read", derive(JsonSchema))]
#[serde(deny_unknown_fields)]
pub enum Profile<Q> {
    /// The same at any depth.
    Constant(Q),
    /// Linear from the top face to the bottom face.
    Linear {
        /// Value at the top face.
        top: Q,
        /// Value at the bottom face.
        bottom: Q,
    },
    /// A power law, surface (1 + d/length)^exponent.
    Power {
        /// Value at the top face.
        surface: Q,
        /// Length over which the value varies first, in length.
        length: Positive,
        /// Exponent m, dimensionless.
        exponent: Finite,
    },
    /// An exponential, surface exp(beta d).
    Exponential {
        /// Value at the top face.
        surface: Q,
        /// Grading exponent, in 1/length; positive: larger with depth.
        beta: Finite,
    },
    /// A smooth step, top + (bottom − top)/(1 + exp((centre − d)/width)).
    Sigmoid {
        /// Value far above the step.
        top: Q,
        /// Value far below the step.
        bottom: Q,
        /// Depth of the middle of the step, in length.
        centre: Finite,
        /// Width of the step, in length.
        width: Positive,
    },
    /// Values at depths from 0 down to the thickness or beyond, linear in between: `[(depth, value), ...]`.
    Table(Table<Q>),
    /// The same with depths in parts of the thickness, from 0 down to 1 or beyond: `[(depth/thickness, value), ...]`.
    RelativeTable(Table<Q>),
}

/// Values at increasing depths, the first of which is 0.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<(Thickness, Q)>", bound(deserialize = "Q: Deserialize<'de>"))]
pub struct Table<Q>(Vec<(Thickness, Q)>);

#[cfg(feature = "read")]
impl<Q> JsonSchema for Table<Q> {
    fn schema_name() -> Cow<'static, str> {
        "Table".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        Value::plain_schema("[(depth, value), ...], two or more with increasing depths, the first 0")
    }
}

impl<Q: Parameter> Parameter for Profile<Q> {
    fn written(&self) -> String {
        let fields = |kind: &str, fields: &[(&str, &dyn Parameter)]| {
            let fields: Vec<String> =
                fields.iter().map(|(name, value)| format!("{name}: {}", value.written())).collect();
            format!("{kind}({})", fields.join(", "))
        };
        match self {
            Self::Constant(value) => format!("Constant({})", value.written()),
            Self::Linear { top, bottom } => fields("Linear", &[("top", top), ("bottom", bottom)]),
            Self::Power { surface, length, exponent } => {
                fields("Power", &[("surface", surface), ("length", length), ("exponent", exponent)])
            }
            Self::Exponential { surface, beta } => fields("Exponential", &[("surface", surface), ("beta", beta)]),
            Self::Sigmoid { top, bottom, centre, width } => {
                fields("Sigmoid", &[("top", top), ("bottom", bottom), ("centre", centre), ("width", width)])
            }
            Self::Table(table) => format!("Table({})", table.written()),
            Self::RelativeTable(table) => format!("RelativeTable({})", table.written()),
        }
    }
}

impl<Q: Parameter> Parameter for Table<Q> {
    fn written(&self) -> String {
        let rows = self.0.iter().map(|(depth, value)| format!("({}, {})", depth.written(), value.written()));
        format!("[{}]", rows.collect::<Vec<_>>().join(", "))
    }
}

impl<Q> TryFrom<Vec<(Thickness, Q)>> for Table<Q> {
    type Error = TableError;

    fn try_from(rows: Vec<(Thickness, Q)>) -> Result<Self, TableError> {
        if rows.len() < 2 {
            return Err(TableError::Rows(rows.len()));
        }
        let mut depths = rows.iter().map(|(depth, _)| depth.get());
        match depths.next() {
            Some(first) if first != 0.0 => return Err(TableError::Begin(first)),
            _ => {}
        }
        for pair in rows.windows(2) {
            let (above, below) = (pair[0].0.get(), pair[1].0.get());
            if below <= above {
                return Err(TableError::Order { above, below });
            }
        }
        Ok(Self(rows))
    }
}

impl<Q: TryFrom<f64, Error = OutOfRange>> Table<Q> {
    fn checked(rows: &[(f64, f64)]) -> Result<Self, LayerError> {
        let checked = rows.iter().map(|(depth, value)| {
            Ok((LayerError::checked("depth in a table", *depth)?, LayerError::checked("value in a table", *value)?))
        });
        Ok(checked.collect::<Result<Vec<_>, LayerError>>()?.try_into()?)
    }
}

impl<Q: Copy + Into<f64> + TryFrom<f64, Error = OutOfRange>> Profile<Q> {
    /// A key with the kind of the profile and its numbers.
    pub(crate) fn keyed(&self, key: Key) -> Key {
        match self {
            Self::Constant(value) => key.with([0.0, (*value).into()]),
            Self::Linear { top, bottom } => key.with([1.0, (*top).into(), (*bottom).into()]),
            Self::Power { surface, length, exponent } => {
                key.with([2.0, (*surface).into(), length.get(), exponent.get()])
            }
            Self::Exponential { surface, beta } => key.with([3.0, (*surface).into(), beta.get()]),
            Self::Sigmoid { top, bottom, centre, width } => {
                key.with([4.0, (*top).into(), (*bottom).into(), centre.get(), width.get()])
            }
            Self::Table(Table(rows)) | Self::RelativeTable(Table(rows)) => {
                let kind = if let Self::Table(_) = self { 5.0 } else { 6.0 };
                let numbers = rows.iter().flat_map(|(depth, value)| [depth.get(), (*value).into()]);
                key.with([kind]).with_list(&numbers.collect::<Vec<f64>>())
            }
        }
    }

    /// Linear from the top face to the bottom face.
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite.
    pub fn linear(top: f64, bottom: f64) -> Result<Self, LayerError> {
        Ok(Self::Linear { top: LayerError::checked("top", top)?, bottom: LayerError::checked("bottom", bottom)? })
    }

    /// The power law surface (1 + d/length)^exponent.
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite.
    pub fn power(surface: f64, length: f64, exponent: f64) -> Result<Self, LayerError> {
        Ok(Self::Power {
            surface: LayerError::checked("surface", surface)?,
            length: LayerError::checked("length", length)?,
            exponent: LayerError::checked("exponent", exponent)?,
        })
    }

    /// The exponential surface exp(beta d).
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite.
    pub fn exponential(surface: f64, beta: f64) -> Result<Self, LayerError> {
        let surface = LayerError::checked("surface", surface)?;
        Ok(Self::Exponential { surface, beta: LayerError::checked("beta", beta)? })
    }

    /// The smooth step top + (bottom − top)/(1 + exp((centre − d)/width)).
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite.
    pub fn sigmoid(top: f64, bottom: f64, centre: f64, width: f64) -> Result<Self, LayerError> {
        Ok(Self::Sigmoid {
            top: LayerError::checked("top", top)?,
            bottom: LayerError::checked("bottom", bottom)?,
            centre: LayerError::checked("centre", centre)?,
            width: LayerError::checked("width", width)?,
        })
    }

    /// Values at increasing depths, the first of which is 0, linear in between.
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite, or if the depths are not in order.
    pub fn table(rows: &[(f64, f64)]) -> Result<Self, LayerError> {
        Table::checked(rows).map(Self::Table)
    }

    /// The same with depths in parts of the thickness: the table fits a layer of any thickness.
    ///
    /// # Errors
    /// As [`Profile::table`].
    pub fn relative_table(rows: &[(f64, f64)]) -> Result<Self, LayerError> {
        Table::checked(rows).map(Self::RelativeTable)
    }

    /// The rows of a table, none of another profile, and the length in which their depths are told in a layer of thickness h.
    fn rows(&self, thickness: f64) -> (&[(Thickness, Q)], f64) {
        match self {
            Self::Table(Table(rows)) => (rows, 1.0),
            Self::RelativeTable(Table(rows)) => (rows, thickness),
            _ => (&[], 1.0),
        }
    }

    /// The value at depth d in a layer of thickness h; below the last row of a table, the value of the last row.
    pub fn at(&self, depth: f64, thickness: f64) -> f64 {
        let between = |above: Q, below: Q, part: f64| {
            let (above, below): (f64, f64) = (above.into(), below.into());
            (1.0 - part) * above + part * below
        };
        let relative = if thickness > 0.0 { depth / thickness } else { 0.0 };
        match self {
            Self::Constant(value) => (*value).into(),
            Self::Linear { top, bottom } => between(*top, *bottom, relative),
            Self::Power { surface, length, exponent } => {
                (*surface).into() * (exponent.get() * (depth / length.get()).ln_1p()).exp()
            }
            Self::Exponential { surface, beta } => (*surface).into() * (beta.get() * depth).exp(),
            Self::Sigmoid { top, bottom, centre, width } => {
                between(*top, *bottom, 1.0 / (1.0 + ((centre.get() - depth) / width.get()).exp()))
            }
            Self::Table(Table(rows)) | Self::RelativeTable(Table(rows)) => {
                let depth = if let Self::Table(_) = self { depth } else { relative };
                let next = rows.partition_point(|(at, _)| at.get() <= depth).clamp(1, rows.len() - 1);
                let ((above, top), (below, bottom)) = (rows[next - 1], rows[next]);
                let part = (depth - above.get()) / (below.get() - above.get());
                between(top, bottom, part.min(1.0))
            }
        }
    }

    /// Depths at which the value is not smooth in a layer of thickness h, or between which it varies much.
    pub(crate) fn kinks(&self, thickness: f64) -> Vec<f64> {
        match self {
            Self::Sigmoid { centre, width, .. } => {
                [-WIDTHS, 0.0, WIDTHS].map(|widths| centre.get() + widths * width.get()).to_vec()
            }
            _ => {
                let (rows, unit) = self.rows(thickness);
                rows.iter().map(|(depth, _)| depth.get() * unit).collect()
            }
        }
    }

    /// Checks the profile of `field` in a layer of thickness h, and returns its values at the two ends of its range.
    pub(crate) fn extremes(&self, field: &'static str, thickness: f64) -> Result<[f64; 2], LayerError> {
        let (rows, unit) = self.rows(thickness);
        if let Some((last, _)) = rows.last()
            && last.get() * unit < REACHED * thickness
        {
            let depth = last.get();
            return Err(match self {
                Self::RelativeTable(_) => LayerError::RelativeTableEnds { field, part: depth },
                _ => LayerError::TableEnds { field, depth, thickness },
            });
        }
        // all are monotonic, or between their rows
        let bottom: Q = LayerError::checked(field, self.at(thickness, thickness))?;
        let ends = [self.at(0.0, thickness), bottom.into()];
        let values = || rows.iter().map(|(_, value)| (*value).into()).chain(ends);
        Ok([values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Poisson;

    #[test]
    fn values_are_those_of_the_formulae() {
        let legal = "legal numbers";
        let linear = Profile::<Positive>::linear(1.0, 3.0).expect(legal);
        assert_eq!([0.0, 0.5, 2.0].map(|d| linear.at(d, 2.0)), [1.0, 1.5, 3.0]);
        let power = Profile::<Positive>::power(2.0, 0.5, -1.0).expect(legal);
        assert_eq!([0.0, 0.5].map(|d| power.at(d, 9.0)), [2.0, 1.0]);
        let sigmoid = Profile::<Poisson>::sigmoid(0.1, 0.3, 0.5, 0.01).expect(legal);
        assert_eq!([-1e3, 0.5, 1e3].map(|d| sigmoid.at(d, 1.0)), [0.1, 0.2, 0.3]);
        let table = Profile::<Positive>::table(&[(0.0, 1.0), (1.0, 3.0), (3.0, 2.0)]).expect(legal);
        assert_eq!([0.0, 0.5, 1.0, 2.0, 3.0, 4.0].map(|d| table.at(d, 3.0)), [1.0, 2.0, 3.0, 2.5, 2.0, 2.0]);
        assert_eq!(table.kinks(3.0), [0.0, 1.0, 3.0]);
    }

    #[test]
    fn a_relative_table_is_the_same_in_any_thickness() {
        let rows = [(0.0, 1.0), (0.25, 3.0), (1.0, 2.0)];
        let relative = Profile::<Positive>::relative_table(&rows).expect("legal");
        for thickness in [0.5, 2.0, 8.0] {
            let table =
                Profile::<Positive>::table(&rows.map(|(part, value)| (part * thickness, value))).expect("legal");
            let at = |profile: &Profile<Positive>| {
                [0.0, 0.125, 0.25, 0.6, 1.0].map(|part| profile.at(part * thickness, thickness))
            };
            assert_eq!(at(&relative), at(&table));
            assert_eq!(relative.kinks(thickness), table.kinks(thickness));
            assert_eq!(relative.extremes("young", thickness), table.extremes("young", thickness));
        }
        let short = Profile::<Positive>::relative_table(&[(0.0, 1.0), (0.5, 2.0)]).expect("legal");
        let error = short.extremes("young", 3.0).expect_err("too short").to_string();
        assert_eq!(error, "young: the table ends at 0.5 of the thickness; allowed is 1 or more");
    }

    #[test]
    fn rows_that_make_no_table_are_refused() {
        for (rows, message) in [
            (&[(0.0, 1.0)][..], "the table has 1 rows; allowed are two or more"),
            (&[(0.5, 1.0), (1.0, 1.0)], "the table begins at depth 0.5; allowed is 0"),
            (
                &[(0.0, 1.0), (0.5, 1.0), (0.5, 2.0)],
                "in the table depth 0.5 follows 0.5; allowed are increasing depths",
            ),
            (&[(0.0, 1.0), (0.5, -1.0)], "value in a table: found -1.0, allowed is a finite number > 0"),
        ] {
            assert_eq!(Profile::<Positive>::table(rows).expect_err(message).to_string(), message);
        }
    }

    #[test]
    fn a_profile_that_leaves_its_range_is_refused() {
        let rising = Profile::<Poisson>::power(0.4, 1.0, 1.0).expect("legal");
        assert!(rising.extremes("poisson", 0.2).is_ok() && rising.extremes("poisson", 0.3).is_err());
        let short = Profile::<Positive>::table(&[(0.0, 1.0), (0.5, 2.0)]).expect("legal");
        let error = short.extremes("shear_modulus", 1.0).expect_err("too short");
        assert_eq!(
            error.to_string(),
            "shear_modulus: the table ends at depth 0.5; allowed is the thickness, 1.0, or more"
        );
    }
}
