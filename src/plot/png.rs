//! A picture as pixels: the same shapes as in SVG, with letters that the program brings along.
use tiny_skia::{Color, FillRule, Paint, Path, PathBuilder, Pixmap, Stroke as Pen, StrokeDash, Transform};
use ttf_parser::{Face as Font, OutlineBuilder};

use super::file::PlotError;
use super::picture::{Anchor, Colour, Picture, Shape, pieces};

/// The letters of all pictures, upright and in italics; the licence stands beside the files.
const FONTS: [&[u8]; 2] = [include_bytes!("font/DejaVuSans.ttf"), include_bytes!("font/DejaVuSans-Oblique.ttf")];
/// Pixels per point: 216 to the inch.
const PIXELS: f64 = 3.0;
/// Pixels at most, four bytes each: larger pictures have fewer pixels per point.
const MOST_PIXELS: f64 = 3e7;
/// Half the height of a small letter, in heights of the font.
const MIDDLE: f64 = 0.27;
/// Size of an index, and how far it is lowered, in heights of the font.
const INDEX: [f64; 2] = [0.7, 0.14];

impl Picture {
    /// The picture as PNG.
    ///
    /// # Errors
    /// [`PlotError::Drawing`] if it has no size.
    pub fn png(&self) -> Result<Vec<u8>, PlotError> {
        let failed = |error: &dyn std::fmt::Display| PlotError::Drawing(error.to_string());
        let (width, height) = self.size;
        let scale = PIXELS.min((MOST_PIXELS / (width * height)).sqrt());
        let pixels = |points: f64| (scale * points).ceil() as u32;
        let mut pixmap = Pixmap::new(pixels(width), pixels(height)).ok_or_else(|| failed(&"it has no size"))?;
        pixmap.fill(Color::WHITE);
        let [upright, oblique] = FONTS.map(|font| Font::parse(font, 0));
        let fonts = [upright.map_err(|error| failed(&error))?, oblique.map_err(|error| failed(&error))?];
        let points = Transform::from_scale(scale as f32, scale as f32);
        for shape in &self.shapes {
            draw(&mut pixmap, shape, points, &fonts);
        }
        pixmap.encode_png().map_err(|error| failed(&error))
    }
}

/// Draws one shape; one without extent is left out.
fn draw(pixmap: &mut Pixmap, shape: &Shape, points: Transform, fonts: &[Font<'_>; 2]) {
    match shape {
        Shape::Line { points: corners, stroke } => {
            let mut path = PathBuilder::new();
            outline(&mut path, corners);
            let dash = stroke.dash.and_then(|(dash, space)| StrokeDash::new(vec![dash as f32, space as f32], 0.0));
            let pen = Pen { width: stroke.width as f32, dash, ..Pen::default() };
            if let Some(path) = path.finish() {
                pixmap.stroke_path(&path, &paint(stroke.colour, 1.0), &pen, points, None);
            }
        }
        Shape::Area { rings, colour, opacity } => {
            let mut path = PathBuilder::new();
            for ring in rings {
                outline(&mut path, ring);
                path.close();
            }
            if let Some(path) = path.finish() {
                pixmap.fill_path(&path, &paint(*colour, *opacity), FillRule::EvenOdd, points, None);
            }
        }
        Shape::Text { at, text, size, colour, anchor } => {
            let Some((letters, width)) = letters(text, *size, fonts) else { return };
            let before = match anchor {
                Anchor::Left => 0.0,
                Anchor::Right => width,
                Anchor::Centre | Anchor::Upwards => 0.5 * width,
            };
            let turn = if *anchor == Anchor::Upwards { -90.0 } else { 0.0 };
            let place = points
                .pre_translate(at.0 as f32, at.1 as f32)
                .pre_concat(Transform::from_rotate(turn))
                .pre_translate(-before as f32, (MIDDLE * size) as f32);
            pixmap.fill_path(&letters, &paint(*colour, 1.0), FillRule::Winding, place, None);
        }
    }
}

fn paint(colour: Colour, opacity: f64) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(colour.r, colour.g, colour.b, (255.0 * opacity).round() as u8);
    paint
}

fn outline(path: &mut PathBuilder, points: &[(f64, f64)]) {
    for (i, (x, y)) in points.iter().map(|(x, y)| (*x as f32, *y as f32)).enumerate() {
        if i == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
    }
}

/// The outlines of a text that begins on the left at height 0, and its width; `None` for a text without a letter.
fn letters(text: &str, size: f64, fonts: &[Font<'_>; 2]) -> Option<(Path, f64)> {
    let mut pen = Letters { path: PathBuilder::new(), scale: 1.0, x: 0.0, y: 0.0 };
    for (face, piece) in pieces(text) {
        let font = &fonts[usize::from(face.italic)];
        let [share, low] = if face.index { INDEX } else { [1.0, 0.0] };
        (pen.scale, pen.y) = (share * size / f64::from(font.units_per_em()), low * size);
        for c in piece.chars() {
            // a letter that the font does not have is an empty box
            let glyph = font.glyph_index(c).unwrap_or_default();
            font.outline_glyph(glyph, &mut pen);
            pen.x += pen.scale * f64::from(font.glyph_hor_advance(glyph).unwrap_or_default());
        }
    }
    Some((pen.path.finish()?, pen.x))
}

/// Takes down the outlines of letters one behind the other.
struct Letters {
    path: PathBuilder,
    /// Points per unit of the font.
    scale: f64,
    /// Where the present letter begins.
    x: f64,
    y: f64,
}

impl Letters {
    fn place(&self, x: f32, y: f32) -> (f32, f32) {
        ((self.x + self.scale * f64::from(x)) as f32, (self.y - self.scale * f64::from(y)) as f32)
    }
}

impl OutlineBuilder for Letters {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.place(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.place(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.place(x1, y1), self.place(x, y));
        self.path.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = (self.place(x1, y1), self.place(x2, y2), self.place(x, y));
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}
