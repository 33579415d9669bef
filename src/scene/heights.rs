//! Lists of heights that describe a punch, checked where they are read.
use std::borrow::Cow;

use recede_layers::{Finite, Thickness, described};
use serde::{Deserialize, Serialize};

use super::shape::{Piece, Shape, end_of_rise};
use super::spline::smooth;

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
    /// The tip is on the left of the table.
    #[error("the table begins at {0:?}; allowed is 0, the tip, or a place on its left")]
    Begin(f64),
    /// The tip is between two rows, or there is nothing on its right.
    #[error("the table has no height at 0, the tip, or none on its right; allowed are tables with both")]
    Tip,
    /// A place that is not beyond the one before.
    #[error("in the table {beyond:?} follows {before:?}; allowed are increasing places from left to right")]
    Order {
        /// The place before, in length.
        before: f64,
        /// The place, in length.
        beyond: f64,
    },
}

/// The heights h₁, h₂, ... of a polynomial Σ h_k s^(2k).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<Finite>")]
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

described!(PolynomialHeights in "[height, height, ...], one or more finite numbers that are not all 0");

/// Heights at places on x with the tip at 0, with the smooth curve through them. Without places on the left of the tip that is the mirror image.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<(Finite, Finite)>", into = "Vec<(Finite, Finite)>")]
pub struct Heights {
    rows: Vec<(Finite, Finite)>,
    /// The pieces of the curve.
    pieces: Vec<Piece>,
}

/// Heights at distances from the axis, none of which is negative.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(try_from = "Vec<(Thickness, Finite)>", into = "Vec<(Finite, Finite)>")]
pub(super) struct RoundHeights(pub(super) Heights);

impl Heights {
    /// The pieces of the curve as a profile.
    pub(super) fn shape(&self) -> Shape<'_> {
        let end = self.rows.last().map_or(f64::INFINITY, |(x, _)| x.get());
        Shape::Pieces { pieces: Cow::Borrowed(&self.pieces), end }
    }
}

impl From<Heights> for Vec<(Finite, Finite)> {
    fn from(heights: Heights) -> Self {
        heights.rows
    }
}

impl From<RoundHeights> for Vec<(Finite, Finite)> {
    /// The half of an even curve.
    fn from(RoundHeights(heights): RoundHeights) -> Self {
        let is_even = heights.shape().is_even();
        heights.rows.into_iter().filter(|(x, _)| !is_even || x.get() >= 0.0).collect()
    }
}

impl TryFrom<Vec<(Thickness, Finite)>> for RoundHeights {
    type Error = HeightsError;

    fn try_from(rows: Vec<(Thickness, Finite)>) -> Result<Self, HeightsError> {
        let rows: Vec<(Finite, Finite)> = rows.into_iter().map(|(r, height)| (r.into(), height)).collect();
        rows.try_into().map(Self)
    }
}

impl TryFrom<Vec<(Finite, Finite)>> for Heights {
    type Error = HeightsError;

    fn try_from(rows: Vec<(Finite, Finite)>) -> Result<Self, HeightsError> {
        count(rows.len(), 2)?;
        if let Some((first, _)) = rows.first().filter(|(x, _)| x.get() > 0.0) {
            return Err(HeightsError::Begin(first.get()));
        }
        for pair in rows.windows(2) {
            let (before, beyond) = (pair[0].0.get(), pair[1].0.get());
            if beyond <= before {
                return Err(HeightsError::Order { before, beyond });
            }
        }
        let mut plain: Vec<(f64, f64)> = rows.iter().map(|(x, height)| (x.get(), height.get())).collect();
        let tip = plain.iter().position(|(x, _)| *x == 0.0).filter(|tip| tip + 1 < plain.len());
        let tip = tip.ok_or(HeightsError::Tip)?;
        let images = plain.iter().rev().map(|(x, height)| (-x, *height));
        if images.eq(plain.iter().copied()) {
            plain.drain(..tip);
        }
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

described!(Heights in
    "[(x, height), ...], two or more with increasing x: from 0, the tip, on if the left is the mirror image of the right, or from the left \
     end, with a height at 0");
described!(RoundHeights in "[(r, height), ...], two or more with increasing distances r, the first 0");

fn count(found: usize, least: usize) -> Result<(), HeightsError> {
    if (least..=MOST).contains(&found) { Ok(()) } else { Err(HeightsError::Count { found, least }) }
}
