//! Orders and signs of the sine series of what is even.
//!
//! p(x) = Σ c_j sin jφ with x = a cos φ and j = 2m + 1.

/// (−1)^m, the sign of the test functions and modes of order 2m + 1.
pub(crate) fn alternating(m: usize) -> f64 {
    if m.is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// Order j of mode m.
pub(crate) fn order(m: usize) -> f64 {
    (2 * m + 1) as f64
}
