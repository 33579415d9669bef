//! The letters of all pictures: their outlines and widths, so that SVG, PNG and PDF show the same on any computer.
use std::sync::LazyLock;

use tiny_skia::{Path, PathBuilder};
use ttf_parser::{Face as Font, GlyphId, OutlineBuilder};

use super::picture::{Anchor, pieces};

/// Upright and in italics; the licence stands beside the files.
const FILES: [&[u8]; 2] = [include_bytes!("font/DejaVuSans.ttf"), include_bytes!("font/DejaVuSans-Oblique.ttf")];
static FONTS: LazyLock<Vec<Font<'static>>> =
    LazyLock::new(|| FILES.iter().filter_map(|file| Font::parse(file, 0).ok()).collect());

/// Half the height of a small letter, in heights of the font.
const MIDDLE: f64 = 0.27;
/// Size of an index, and how far it is lowered, in heights of the font.
const INDEX: [f64; 2] = [0.7, 0.14];
/// A letter of one of the two fonts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Letter {
    /// 1 in italics.
    pub(super) font: usize,
    pub(super) glyph: u16,
}

/// A letter where it stands: units of the font are multiplied by `scale`, and begin at a point of the text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PlacedLetter {
    pub(super) letter: Letter,
    pub(super) scale: f64,
    pub(super) at: (f64, f64),
}

/// The letters of a text that begins at x = 0, their base line at y = 0, y downwards; and its width.
fn placed(text: &str, size: f64) -> (Vec<PlacedLetter>, f64) {
    let (mut letters, mut x) = (Vec::new(), 0.0);
    for (face, piece) in pieces(text) {
        let index = usize::from(face.italic);
        let Some(font) = FONTS.get(index) else { continue };
        let [share, low] = if face.index { INDEX } else { [1.0, 0.0] };
        let scale = share * size / f64::from(font.units_per_em());
        for c in piece.chars() {
            // a letter that the font does not have is an empty box
            let glyph = font.glyph_index(c).unwrap_or_default();
            letters.push(PlacedLetter { letter: Letter { font: index, glyph: glyph.0 }, scale, at: (x, low * size) });
            x += scale * f64::from(font.glyph_hor_advance(glyph).unwrap_or_default());
        }
    }
    (letters, x)
}

/// The letters of a text relative to its point, the base line in place; a text that runs upwards is turned by the writer.
pub(super) fn letters(text: &str, size: f64, anchor: Anchor) -> Vec<PlacedLetter> {
    let (mut letters, width) = placed(text, size);
    let before = match anchor {
        Anchor::Left => 0.0,
        Anchor::Right => width,
        Anchor::Centre | Anchor::Upwards => 0.5 * width,
    };
    for letter in &mut letters {
        letter.at.0 -= before;
        letter.at.1 += MIDDLE * size;
    }
    letters
}

/// The width of a text, in points.
pub fn width(text: &str, size: f64) -> f64 {
    placed(text, size).1
}

/// The text, or as much of its beginning as has this width, and three dots.
pub(super) fn shortened(text: &str, size: f64, most: f64) -> String {
    if width(text, size) <= most {
        return text.to_owned();
    }
    let mut short: String = text.chars().take((most / (0.2 * size)) as usize).collect();
    while width(&short, size) + size > most && short.pop().is_some() {}
    short + "…"
}

impl Letter {
    /// The outline of the letter in units of the font, y upwards; `None` for a space.
    pub(super) fn outline(self) -> Option<Path> {
        let mut outline = Outline::default();
        FONTS.get(self.font)?.outline_glyph(GlyphId(self.glyph), &mut outline)?;
        outline.0.finish()
    }
}

/// Takes down an outline.
#[derive(Default)]
struct Outline(PathBuilder);

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.0.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.0.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.0.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.0.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::italic;

    #[test]
    fn texts_have_widths() {
        assert_eq!(FONTS.len(), FILES.len());
        assert!((width("iiii", 10.0) - 4.0 * width("i", 10.0)).abs() < 1e-9 && width("m", 10.0) > width("i", 10.0));
        assert_eq!((width("", 10.0), letters(" ", 9.0, Anchor::Left)[0].letter.outline()), (0.0, None));
        assert_ne!(letters(&italic("a"), 9.0, Anchor::Left), letters("a", 9.0, Anchor::Left));
        let short = shortened(&"long ".repeat(1000), 10.0, 100.0);
        assert!(short.ends_with('…') && (60.0..=100.0).contains(&width(&short, 10.0)), "{short}");
    }
}
