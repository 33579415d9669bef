//! Why a quantity cannot vary as it is said to.

/// Why something is no axis of a sweep.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{axis}`: {reason}")]
pub struct AxisError {
    /// The axis as written.
    pub axis: String,
    /// What was found, and what is expected.
    pub reason: String,
}
