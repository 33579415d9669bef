//! What the user should know about a result.
use std::fmt;

/// A warning: what is special about a result, in a sentence, with a code that stays the same when the sentence changes.
///
/// ```
/// use recede::{HalfPlane, Model, Plane, Punch, Stack, WarningCode};
/// let stack = Stack::builder(Plane::Strain).layer(HalfPlane::new(1.0, 0.25)?).build()?;
/// let solution = Model::new(stack)?.press(&Punch::parabola(1.0)?, 0.2)?;
/// assert_eq!(solution.warnings()[0].code, WarningCode::LongContact);
/// assert_eq!(solution.warnings()[0].code.as_str(), "long_contact");
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// What kind of warning this is.
    pub code: WarningCode,
    /// The sentence.
    pub message: String,
}

impl Warning {
    pub(crate) fn new(code: WarningCode, message: String) -> Self {
        Self { code, message }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

/// The kinds of warnings. Each has an entry in `docs/troubleshooting.md`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum WarningCode {
    /// The contact is long compared with the radius of the punch: strains are no longer small.
    LongContact,
    /// The punch is steep where it touches: slopes are no longer small.
    SteepPunch,
    /// The mean pressure of a contact is no longer small compared with its modulus.
    LargePressure,
    /// The errors are larger than the tolerance.
    ToleranceNotMet,
    /// The tolerance is smaller than rounding errors.
    BeyondDoublePrecision,
    /// The end of a contact is hardly known, or not at all; nothing depends on it.
    EndNotKnown,
    /// The bodies touch again farther out, with a negligible force that is left out.
    RecontactLeftOut,
    /// A layer is so thin that it is left out.
    ThinLayerLeftOut,
    /// The errors are about one per cent.
    LowAccuracy,
}

impl WarningCode {
    /// Whether it is about the theory, which holds for small strains and slopes; all others are about the numbers.
    pub fn is_about_theory(self) -> bool {
        matches!(self, Self::LongContact | Self::SteepPunch | Self::LargePressure)
    }

    /// The code as it stands in JSON.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::LongContact => "long_contact",
            Self::SteepPunch => "steep_punch",
            Self::LargePressure => "large_pressure",
            Self::ToleranceNotMet => "tolerance_not_met",
            Self::BeyondDoublePrecision => "beyond_double_precision",
            Self::EndNotKnown => "end_not_known",
            Self::RecontactLeftOut => "recontact_left_out",
            Self::ThinLayerLeftOut => "thin_layer_left_out",
            Self::LowAccuracy => "low_accuracy",
        }
    }
}
