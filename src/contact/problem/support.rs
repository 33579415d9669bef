//! Where the contacts are.

/// How far out, in units of L, gaps are looked at.
pub(crate) fn span(half_lengths: &[f64]) -> f64 {
    2.0 * longest(half_lengths) + 2.0
}

/// The highest frequency of waves there, times the waves of a pressure.
pub(crate) fn frequency_of_fields(half_lengths: &[f64], span: f64) -> f64 {
    longest(half_lengths) + span
}

fn longest(half_lengths: &[f64]) -> f64 {
    half_lengths.iter().fold(0.0, |a: f64, b| a.max(*b))
}
