//! The shapes of a picture: lines, areas and text, in points, y downwards.
use crate::scene::visible;

/// Where italics begin and end.
const ITALIC: char = '\u{e000}';
/// Where an index begins and ends.
const INDEX: char = '\u{e001}';

/// Corners of a circle, which is a few points wide.
const CORNERS: u32 = 24;

/// A colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour {
    /// Red, from 0 to 255; so the others.
    pub r: u8,
    /// Green.
    pub g: u8,
    /// Blue.
    pub b: u8,
}

/// White.
pub(super) const WHITE: Colour = Colour { r: 255, g: 255, b: 255 };

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// The colour of the line.
    pub colour: Colour,
    /// The width of the line, in points.
    pub width: f64,
    /// Length of dashes and of the space between, in points.
    pub dash: Option<(f64, f64)>,
}

/// Which point of a text is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// Middle of its left end.
    Left,
    /// The middle of the text.
    Centre,
    /// Middle of its right end.
    Right,
    /// The middle of a text that runs upwards.
    Upwards,
}

/// A picture: its size, and all that is drawn on a white ground, the last on top.
#[derive(Clone, Debug)]
pub struct Picture {
    pub(super) size: (f64, f64),
    pub(super) shapes: Vec<DrawnShape>,
}

/// One thing that is drawn.
#[derive(Clone, Debug)]
pub(super) enum DrawnShape {
    Line { points: Vec<(f64, f64)>, stroke: Stroke },
    Area { rings: Vec<Vec<(f64, f64)>>, colour: Colour },
    Text { at: (f64, f64), text: String, size: f64, colour: Colour, anchor: Anchor },
}

/// A symbol, set in italics.
pub fn italic(symbol: &str) -> String {
    format!("{ITALIC}{symbol}{ITALIC}")
}

/// An index, set small and low.
pub fn subscript(index: &str) -> String {
    format!("{INDEX}{index}{INDEX}")
}

/// How a piece of a text is set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct TypeFace {
    pub(super) italic: bool,
    pub(super) index: bool,
}

/// The pieces of a text that are set alike, none of them empty.
pub(super) fn pieces(text: &str) -> impl Iterator<Item = (TypeFace, &str)> {
    let mut face = TypeFace::default();
    let pieces = text.split_inclusive([ITALIC, INDEX]).map(move |piece| {
        let own = face;
        face.italic ^= piece.ends_with(ITALIC);
        face.index ^= piece.ends_with(INDEX);
        (own, piece.trim_end_matches([ITALIC, INDEX]))
    });
    pieces.filter(|(_, piece)| !piece.is_empty())
}

/// A text without the marks of how it is set.
pub(super) fn plain(text: &str) -> String {
    pieces(text).map(|(_, piece)| piece).collect()
}

impl Picture {
    /// An empty one of this size, in points.
    pub fn new(width: f64, height: f64) -> Self {
        Self { size: (width, height), shapes: Vec::new() }
    }

    /// A line through points.
    pub fn line(&mut self, points: &[(f64, f64)], stroke: Stroke) {
        self.shapes.push(DrawnShape::Line { points: points.to_vec(), stroke });
    }

    /// A filled area.
    pub fn area(&mut self, points: &[(f64, f64)], colour: Colour) {
        self.rings(vec![points.to_vec()], colour);
    }

    /// The area inside an odd number of rings.
    pub fn rings(&mut self, rings: Vec<Vec<(f64, f64)>>, colour: Colour) {
        self.shapes.push(DrawnShape::Area { rings, colour });
    }

    /// A filled rectangle from one corner to the other.
    pub fn rectangle(&mut self, from: (f64, f64), to: (f64, f64), colour: Colour) {
        self.area(&[from, (to.0, from.1), to, (from.0, to.1)], colour);
    }

    /// A circle about a point.
    pub(super) fn circle(&mut self, (x, y): (f64, f64), radius: f64, stroke: Stroke) {
        let turns = (0..=CORNERS).map(|k| std::f64::consts::TAU * f64::from(k) / f64::from(CORNERS));
        let points: Vec<_> = turns.map(|phi| (x + radius * phi.cos(), y + radius * phi.sin())).collect();
        self.line(&points, stroke);
    }

    /// A text of letters `size` points high.
    pub fn text(&mut self, at: (f64, f64), text: &str, size: f64, colour: Colour, anchor: Anchor) {
        self.shapes.push(DrawnShape::Text { at, text: visible(text).into_owned(), size, colour, anchor });
    }

    /// Whether all coordinates are numbers.
    pub fn is_finite(&self) -> bool {
        let all = |points: &[(f64, f64)]| points.iter().all(|(x, y)| x.is_finite() && y.is_finite());
        self.shapes.iter().all(|shape| match shape {
            DrawnShape::Line { points, .. } => all(points),
            DrawnShape::Area { rings, .. } => rings.iter().all(|ring| all(ring)),
            DrawnShape::Text { at, .. } => all(&[*at]),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_falls_into_pieces_that_are_set_alike() {
        let text = format!("half-length {}{} = 1", italic("b"), subscript("12"));
        let face = |italic, index| TypeFace { italic, index };
        let expected = [
            (face(false, false), "half-length "),
            (face(true, false), "b"),
            (face(false, true), "12"),
            (face(false, false), " = 1"),
        ];
        assert_eq!(pieces(&text).collect::<Vec<_>>(), expected);
        assert_eq!(pieces("").count(), 0);
    }
}
