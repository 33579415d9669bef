//! Springs between layers, as they are written.
use super::text::written;
use super::value::ValueError;
use recede_layers::Positive;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Springs that join two layers, in both directions: they neither open nor slide freely.
///
/// ```
/// use recede::Spring;
/// let glue = Spring::new(100.0, Some(40.0))?;
/// assert_eq!((glue.normal(), glue.tangential()), (100.0, 40.0));
/// assert_eq!(Spring::new(100.0, None)?.tangential(), 0.0);
/// assert!(Spring::new(0.0, None).is_err());
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spring {
    /// Stress σ_yy per length by which the layers separate.
    normal: Positive,
    /// Stress σ_xy per length by which the layers slide on each other; none if it is not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    tangential: Option<Positive>,
}

impl Spring {
    /// Springs of this normal and, if there is one, tangential stiffness, both > 0, in stress per length.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if a stiffness is not positive and finite.
    pub fn new(normal: f64, tangential: Option<f64>) -> Result<Self, ValueError> {
        let tangential = tangential.map(|stiffness| ValueError::checked("tangential", stiffness)).transpose()?;
        Ok(Self { normal: ValueError::checked("normal", normal)?, tangential })
    }

    /// Normal stiffness, in stress per length.
    pub fn normal(&self) -> f64 {
        self.normal.get()
    }

    /// Tangential stiffness, in stress per length; 0 if there is none.
    pub fn tangential(&self) -> f64 {
        self.tangential.map_or(0.0, Positive::get)
    }

    /// The stiffnesses as written in a scene.
    pub(crate) fn parameters(&self) -> String {
        written(self).trim_matches(['(', ')']).to_owned()
    }
}
