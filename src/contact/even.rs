//! What is even: what was found of a contact for x ≥ 0, and its mirror image about x = 0.
use crate::solution::{Interval, Strip};

/// An interval of x ≥ 0, with the absolute errors of its ends; together with its mirror image, where the bodies of a contact touch.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct RightInterval {
    pub(crate) from: f64,
    pub(crate) from_error: f64,
    pub(crate) to: f64,
    pub(crate) to_error: f64,
}

/// All pressures and intervals of a contact, from left to right: what was found for x ≥ 0, and its mirror image.
pub(crate) fn whole(strips: Vec<Strip>, parts: Vec<RightInterval>) -> (Vec<Strip>, Vec<Interval>) {
    let images = strips.iter().rev().filter(|strip| strip.at > 0.0).map(Strip::mirrored);
    let strips = images.chain(strips.iter().cloned()).collect();
    let beside = |RightInterval { from, from_error, to, to_error }: &RightInterval| {
        Interval::new([*from, *from_error], [*to, *to_error])
    };
    let around = |RightInterval { to, to_error, .. }: &RightInterval| Interval::new([-to, *to_error], [*to, *to_error]);
    let images = parts.iter().rev().filter(|part| part.from > 0.0).map(|part| beside(part).mirrored());
    let intervals = parts.iter().map(|part| if part.from > 0.0 { beside(part) } else { around(part) });
    (strips, images.chain(intervals).collect())
}
