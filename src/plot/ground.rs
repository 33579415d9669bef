//! The sign for what does not move.
use super::picture::Picture;
use super::style::{INK, hair};

/// Distance of the strokes, and how far they reach down, in points.
const APART: f64 = 9.0;

/// Strokes below a line at the height `y`.
pub(super) fn hatching(picture: &mut Picture, (left, right): (f64, f64), y: f64) {
    let mut x = left;
    while x < right {
        let end = (x + APART).min(right);
        picture.line(&[(end, y), (end - APART, y + APART)], hair(INK));
        x += APART;
    }
}
