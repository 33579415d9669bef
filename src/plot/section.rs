//! Parts of all pictures of a stack: interfaces with their contacts, labels beside them, and the hatching of the rigid ground.
use super::chart::beside;
use super::letters::width;
use super::picture::{Anchor, Picture, Stroke};
use super::style::{FAINT, INK, SMALL, hair};
use crate::solution::{Contact, Interface, Interval};

/// Distance of the strokes of the ground, and how far they reach down, in points.
const APART: f64 = 9.0;
/// Distance of a label from the side of the drawing, and where a line to what it names ends, in points.
pub(super) const ASIDE: f64 = 9.0;
const LINE: f64 = 7.0;
/// Width of the drawing, without what is left and right of it, in points.
pub(super) const WIDTH: f64 = 340.0;

/// Strokes below a line at the height `y`: what does not move.
pub(super) fn hatching(picture: &mut Picture, y: f64) {
    let mut x = 0.0;
    while x < WIDTH {
        let end = (x + APART).min(WIDTH);
        picture.line(&[(end, y), (end - APART, y + APART)], hair(INK));
        x += APART;
    }
}

/// Which contact each interface of layers with these numbers is, from the top face down to the lower face of the last layer.
pub(super) fn contacts_at(contacts: &[Contact], numbers: &[usize]) -> Vec<Option<usize>> {
    let is_at = |interface: Interface, face: usize| match interface {
        Interface::Punch => face == 0,
        // the ground below the last layer is none of the layers
        Interface::Between { above, .. } if face == numbers.len() => numbers.last() == Some(&above),
        Interface::Between { below, .. } => numbers[face] == below,
    };
    (0..=numbers.len()).map(|face| contacts.iter().position(|contact| is_at(contact.interface, face))).collect()
}

/// An interface from side to side of a drawing at the height `y`: as bold as `touching` where bodies touch, dashed where they have opened.
pub(super) fn interface(
    picture: &mut Picture,
    contact: Option<&Contact>,
    y: f64,
    place: impl Fn(f64) -> f64,
    touching: Stroke,
) {
    let open = match contact.map(|contact| contact.interface) {
        Some(Interface::Between { .. }) => Stroke { dash: Some((2.5, 2.5)), ..hair(INK) },
        Some(Interface::Punch) | None => hair(INK),
    };
    let mut from = 0.0;
    for Interval { left: start, right: stop, .. } in contact.map_or(&[][..], Contact::intervals) {
        let [start, stop] = [*start, *stop].map(|x| place(x).clamp(0.0, WIDTH));
        picture.line(&[(from, y), (start, y)], open);
        picture.line(&[(start, y), (stop, y)], touching);
        from = stop;
    }
    picture.line(&[(from, y), (WIDTH, y)], open);
}

/// Labels on the left (anchored at their right ends) or on the right of a drawing between two heights, with lines to what they name unless that is next to them; of too many the first
/// and the last, and how many more there are of what `more` calls them. Returns how far they reach from there.
pub(super) fn labels(
    picture: &mut Picture,
    labels: Vec<(f64, String)>,
    anchor: Anchor,
    [top, bottom]: [f64; 2],
    more: &str,
) -> f64 {
    let (side, out) = if anchor == Anchor::Right { (0.0, -1.0) } else { (WIDTH, 1.0) };
    let mut reach: f64 = 0.0;
    for (at, y, text) in beside(labels, top, bottom, more) {
        if (y - at).abs() > 2.0 {
            picture.line(&[(side + out, at), (side + out * LINE, y)], hair(FAINT));
        }
        picture.text((side + out * ASIDE, y), &text, SMALL, INK, anchor);
        reach = reach.max(ASIDE + width(&text, SMALL));
    }
    reach
}
