//! Lists of heights that describe a punch, checked where they are read.
use std::borrow::Cow;
use std::fmt;

use recede_layers::description::Value;
use recede_layers::{Finite, Thickness};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

use super::shape::{Piece, end_of_rise, smooth};

/// Most rows of a table, and most powers of a polynomial.
const MOST: usize = 1000;

/// Heights that do not describe a punch.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum HeightsError {
    /// Too few or too many of them.
    #[error("there are {found} heights; allowed are {least} to {MOST}")]
    Count {
        /// How many there are.
        found: usize,
        /// The least allowed.
        least: usize,
    },
    /// Nothing rises.
    #[error("all heights are the same; allowed are heights that rise from the tip")]
    Flat,
    /// Powers that fall everywhere.
    #[error("the punch falls on either side of its middle without end; allowed are heights some of which are positive")]
    Falling,
    /// Distances so short, or heights so large, that slopes are not finite.
    #[error("the heights rise too steeply for double precision")]
    Steep,
    /// The first distance is not that of the tip.
    #[error("the table begins at {0:?}; allowed is 0, the tip")]
    Begin(f64),
    /// A distance that is not beyond the one before.
    #[error("in the table {beyond:?} follows {before:?}; allowed are increasing distances from the tip")]
    Order {
        /// The distance before, in length.
        before: f64,
        /// The distance, in length.
        beyond: f64,
    },
}

/// The heights h₁, h₂, ... of a polynomial Σ h_k s^(2k).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<Finite>", into = "Vec<Finite>")]
pub struct PolynomialHeights(Vec<Finite>);

impl PolynomialHeights {
    /// Exponents and coefficients.
    pub(super) fn terms(&self) -> Vec<(f64, f64)> {
        self.0.iter().enumerate().map(|(k, height)| ((2 * k + 2) as f64, height.get())).collect()
    }

    /// The s at which the polynomial begins to fall for good, if it does.
    pub(super) fn end(&self) -> Option<f64> {
        end_of_rise(&self.terms()).filter(|end| end.is_finite())
    }
}

impl From<PolynomialHeights> for Vec<Finite> {
    fn from(heights: PolynomialHeights) -> Self {
        heights.0
    }
}

impl TryFrom<Vec<Finite>> for PolynomialHeights {
    type Error = HeightsError;

    fn try_from(heights: Vec<Finite>) -> Result<Self, HeightsError> {
        count(heights.len(), 1)?;
        if heights.iter().all(|height| height.get() == 0.0) {
            return Err(HeightsError::Flat);
        }
        let heights = Self(heights);
        if end_of_rise(&heights.terms()).is_none() { Err(HeightsError::Falling) } else { Ok(heights) }
    }
}

impl JsonSchema for PolynomialHeights {
    fn schema_name() -> Cow<'static, str> {
        "PolynomialHeights".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        Value::plain_schema("[height, height, ...], one or more finite numbers that are not all 0")
    }
}

/// Heights at distances from the tip, with the smooth curve through them.
#[derive(Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<(Thickness, Finite)>", into = "Vec<(Thickness, Finite)>")]
pub struct Heights {
    rows: Vec<(Thickness, Finite)>,
    pieces: Vec<Piece>,
}

impl Heights {
    pub(super) fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The last distance.
    pub(super) fn end(&self) -> f64 {
        self.rows.last().map_or(0.0, |(x, _)| x.get())
    }
}

impl fmt::Debug for Heights {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.rows.fmt(f)
    }
}

impl From<Heights> for Vec<(Thickness, Finite)> {
    fn from(heights: Heights) -> Self {
        heights.rows
    }
}

impl TryFrom<Vec<(Thickness, Finite)>> for Heights {
    type Error = HeightsError;

    fn try_from(rows: Vec<(Thickness, Finite)>) -> Result<Self, HeightsError> {
        count(rows.len(), 2)?;
        if let Some((first, _)) = rows.first().filter(|(x, _)| x.get() != 0.0) {
            return Err(HeightsError::Begin(first.get()));
        }
        for pair in rows.windows(2) {
            let (before, beyond) = (pair[0].0.get(), pair[1].0.get());
            if beyond <= before {
                return Err(HeightsError::Order { before, beyond });
            }
        }
        let plain: Vec<(f64, f64)> = rows.iter().map(|(x, height)| (x.get(), height.get())).collect();
        if plain.iter().all(|(_, height)| *height == plain[0].1) {
            return Err(HeightsError::Flat);
        }
        let pieces = smooth(&plain);
        if pieces.iter().any(|piece| piece.coefficients.iter().any(|c| !c.is_finite())) {
            return Err(HeightsError::Steep);
        }
        Ok(Self { rows, pieces })
    }
}

impl JsonSchema for Heights {
    fn schema_name() -> Cow<'static, str> {
        "Heights".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        Value::plain_schema("[(x, height), ...], two or more with increasing distances x, the first 0")
    }
}

fn count(found: usize, least: usize) -> Result<(), HeightsError> {
    if (least..=MOST).contains(&found) { Ok(()) } else { Err(HeightsError::Count { found, least }) }
}
