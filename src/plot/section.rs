//! Parts of all pictures of a stack: interfaces with their contacts, labels beside them, and the hatching of the rigid ground.
use std::borrow::Cow;

use super::chart::beside;
use super::letters::width;
use super::names::{reach, symbols};
use super::picture::{Anchor, Picture, Stroke};
use super::style::{FAINT, INK, SMALL, hair};
use crate::scene::Scene;
use crate::solution::{Contact, Interface, Interval, Solution, Strip};

/// Distance of the strokes of the ground, and how far they reach down, in points.
const APART: f64 = 9.0;
/// Distance of a label from the side of the drawing, and where a line to what it names ends, in points.
pub(super) const ASIDE: f64 = 9.0;
const LINE: f64 = 7.0;
/// Width of the drawing, without what is left and right of it, in points.
pub(super) const WIDTH: f64 = 340.0;
/// Room for the sign of what does not move, in points.
pub(super) const GROUND: f64 = 12.0;

/// The line of a face where bodies are apart.
pub(super) fn dashed() -> Stroke {
    Stroke { dash: Some((2.5, 2.5)), ..hair(INK) }
}

/// Strokes below a line at the height `y`: what does not move.
pub(super) fn hatching(picture: &mut Picture, y: f64) {
    let mut x = 0.0;
    while x < WIDTH {
        let end = (x + APART).min(WIDTH);
        picture.line(&[(end, y), (end - APART, y + APART)], hair(INK));
        x += APART;
    }
}

/// A line through points of the drawing, from its left side to its right one.
pub(super) type Outline = Vec<(f64, f64)>;

/// A straight one at a height.
pub(super) fn level(y: f64) -> Outline {
    vec![(0.0, y), (WIDTH, y)]
}

/// The height of an outline of two points or more at a place.
pub(super) fn height_at(outline: &[(f64, f64)], x: f64) -> f64 {
    let after = outline.partition_point(|(at, _)| *at < x).clamp(1, outline.len() - 1);
    let ((from, start), (to, end)) = (outline[after - 1], outline[after]);
    start + (end - start) * (x - from) / (to - from)
}

/// An outline between two places.
fn part(outline: &[(f64, f64)], from: f64, to: f64) -> Outline {
    let inside = outline.iter().copied().filter(|(x, _)| *x > from && *x < to);
    let end = |x: f64| (x, height_at(outline, x));
    [end(from)].into_iter().chain(inside).chain([end(to)]).collect()
}

/// The contacts as they are seen along y: loads about axes of their own as one, of those behind each other the nearest to y = 0.
fn side_view(solution: &Solution) -> Cow<'_, [Contact]> {
    let mut all: Vec<(&Contact, &[f64; 2])> = solution.contacts.iter().zip(&solution.axes).collect();
    all.sort_by(|(_, [_, a]), (_, [_, b])| a.abs().total_cmp(&b.abs()));
    let mut seen: Vec<Contact> = Vec::new();
    for (contact, [x, _]) in all {
        let contact = contact.clone().moved(*x);
        let [left, right] = contact.ends();
        if seen.iter().map(Contact::ends).all(|[from, to]| right <= from || left >= to) {
            seen.push(contact);
        }
    }
    seen.sort_by(|a, b| a.ends()[0].total_cmp(&b.ends()[0]));
    let Some(first) = seen.first() else {
        // without a load there is none
        return solution.contacts.iter().filter(|contact| contact.resultant != 0.0).cloned().collect();
    };
    let (intervals, strips) = seen.iter().map(|own| (own.intervals.clone(), own.strips.clone())).unzip();
    let (intervals, strips): (Vec<Vec<Interval>>, Vec<Vec<Strip>>) = (intervals, strips);
    let none = [0.0; 2];
    vec![Contact::new(first.interface, intervals.concat(), strips.concat(), None, none, Vec::new())].into()
}

/// A section through a stack in a drawing that reaches from 0 to its [`WIDTH`], with the top face of the stack at height 0.
pub(super) struct Section<'a> {
    pub(super) scene: &'a Scene,
    pub(super) force: f64,
    /// From the top down; a punch is drawn as deep as it touches.
    pub(super) contacts: Cow<'a, [Contact]>,
    /// The symbols of their half-lengths and pressures, and then the ones of interfaces that weights press together.
    pub(super) symbols: Vec<(String, String)>,
    /// Points per length.
    pub(super) scale: f64,
    /// Where x = 0 is.
    pub(super) middle: f64,
    /// The top face of the stack.
    pub(super) top: Outline,
    /// The lower sides of all punches, not finite where there is none, of a stack that is drawn with its displacements.
    pub(super) punches: Option<Outline>,
}

impl<'a> Section<'a> {
    pub(super) fn new(scene: &'a Scene, solution: &'a Solution, scale: f64, middle: f64) -> Self {
        let (force, contacts) = (solution.force(), side_view(solution));
        let closed = solution.closed().iter().map(|own| own.interface);
        let symbols = symbols(contacts.iter().map(|contact| contact.interface).chain(closed));
        Self { scene, force, contacts, symbols, scale, middle, top: level(0.0), punches: None }
    }

    pub(super) fn x(&self, x: f64) -> f64 {
        self.middle + self.scale * x
    }

    pub(super) fn sees(&self, x: f64) -> bool {
        (0.0..=WIDTH).contains(&x)
    }

    /// Which contact each interface of layers with these numbers is, from the top face down to the lower face of the last layer.
    pub(super) fn contacts_at(&self, numbers: &[usize]) -> Vec<Option<usize>> {
        let is_at = |interface: Interface, face: usize| match interface {
            Interface::Punch => face == 0,
            // the ground below the last layer is none of the layers
            Interface::Between { above, .. } if face == numbers.len() => numbers.last() == Some(&above),
            Interface::Between { below, .. } => numbers[face] == below,
        };
        let of = |face| self.contacts.iter().position(|contact| is_at(contact.interface, face));
        (0..=numbers.len()).map(of).collect()
    }

    /// An interface, which is a contact if one is found there, from side to side along a face: as bold as `touching` where bodies touch,
    /// dashed where they have opened. Returns the height at the left with a label of a contact, which says how far bodies touch.
    pub(super) fn interface(
        &self,
        picture: &mut Picture,
        found: Option<usize>,
        face: &[(f64, f64)],
        touching: Stroke,
    ) -> Option<(f64, String)> {
        let contact = found.map(|i| &self.contacts[i]);
        let mut open = match contact.map(|contact| contact.interface) {
            Some(Interface::Between { .. }) => dashed(),
            Some(Interface::Punch) | None => hair(INK),
        };
        open.width = open.width.min(touching.width);
        let intervals = contact.map_or(&[][..], Contact::intervals);
        let ends: Vec<[f64; 2]> = intervals.iter().map(|Interval { left, right, .. }| [*left, *right]).collect();
        self.spans(picture, &ends, face, [touching, open]);
        found.map(|i| (height_at(face, 0.0), reach(self.scene, &self.contacts[i], &self.symbols[i].0)))
    }

    /// A face from side to side, one way between these places along x, another way beside them.
    pub(super) fn spans(
        &self,
        picture: &mut Picture,
        spans: &[[f64; 2]],
        face: &[(f64, f64)],
        [inside, beside]: [Stroke; 2],
    ) {
        let mut from = 0.0;
        for ends in spans {
            let [start, stop] = ends.map(|x| self.x(x).clamp(0.0, WIDTH));
            picture.line(&part(face, from, start), beside);
            picture.line(&part(face, start, stop), inside);
            from = stop;
        }
        picture.line(&part(face, from, WIDTH), beside);
    }
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
    let mut farthest: f64 = 0.0;
    for (at, y, text) in beside(labels, top, bottom, more) {
        if (y - at).abs() > 2.0 {
            picture.line(&[(side + out, at), (side + out * LINE, y)], hair(FAINT));
        }
        picture.text((side + out * ASIDE, y), &text, SMALL, INK, anchor);
        farthest = farthest.max(ASIDE + width(&text, SMALL));
    }
    farthest
}
