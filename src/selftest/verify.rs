//! Error estimates compared with true errors: an answer against a stricter one.
use serde::{Deserialize, Serialize};

use crate::errors::Error;
use crate::model::Model;
use crate::options::Options;
use crate::scene::Scene;
use crate::solution::Solution;

/// Relative error below which an answer to a contact problem is rounding, which no estimate has to cover.
pub const ROUNDING: f64 = 1e-13;
/// The strictest tolerance there is.
const STRICTEST: f64 = 1e-13;

/// One number of an answer: its estimated and its true error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Comparison {
    /// The name of the contact.
    pub contact: String,
    /// The name of the number: `half-length`, `left end` or `pressure`.
    pub quantity: String,
    /// Difference from the stricter answer, relative; infinite if it is no number.
    pub error: f64,
    /// The answer's own estimate of its error, relative.
    pub estimate: f64,
    /// The stricter answer's own estimate of its error, relative: smaller errors cannot be measured.
    pub blur: f64,
}

impl Comparison {
    /// True error over estimate, where an error below rounding, or below the error of the stricter answer, counts as none.
    pub fn excess(&self) -> f64 {
        // a given number has no error
        let unseen = ROUNDING + self.blur;
        if self.error <= unseen { 0.0 } else { (self.error - unseen) / self.estimate }
    }

    /// Estimate over true error, where a smaller error than rounding counts as rounding.
    pub fn caution(&self) -> f64 {
        self.estimate / self.error.max(ROUNDING)
    }
}

/// Compares the numbers of an answer to a scene with the numbers of the strictest answer.
///
/// # Errors
/// As [`Model::press_with`], if there is no stricter answer.
pub fn compare(scene: &Scene, solution: &Solution) -> Result<Vec<Comparison>, Error> {
    let options = Options { tolerance: STRICTEST };
    let strict = Model::new(scene.stack()?)?.press_with(&scene.top, scene.force, &options)?;
    let mut comparisons = Vec::new();
    // a prescribed traction has no error
    let given = usize::from(scene.top.loads().is_some());
    for (found, strict) in solution.contacts().iter().zip(strict.contacts()).skip(given) {
        let (own, truth) = (found.innermost(), strict.innermost());
        // what is not even has no half-length
        let half = strict.about.map_or(0.5 * (truth.right - truth.left), |about| truth.right - about);
        let all = [
            ("half-length", [own.right, own.right_error], [truth.right, truth.right_error], half),
            ("left end", [own.left, own.left_error], [truth.left, truth.left_error], half),
            ("pressure", found.middle_pressure, strict.middle_pressure, strict.middle_pressure[0]),
        ];
        for (quantity, [value, estimate], [truth, blur], size) in all {
            // an open middle and an infinite pressure have no error
            let is_known = value.is_infinite() && truth.is_infinite() || value == 0.0 && truth == 0.0;
            if is_known || quantity == "left end" && strict.about.is_some() {
                continue;
            }
            let error = ((value - truth) / size).abs();
            comparisons.push(Comparison {
                contact: found.interface.to_string(),
                quantity: quantity.to_owned(),
                error: if error.is_nan() { f64::INFINITY } else { error },
                estimate: estimate / size,
                blur: blur / size,
            });
        }
    }
    Ok(comparisons)
}
