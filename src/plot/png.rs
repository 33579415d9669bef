//! A picture as pixels.
use tiny_skia::{Color, FillRule, Paint, PathBuilder, Pixmap, Stroke as Pen, StrokeDash, Transform};

use super::file::PlotError;
use super::letters::{Piece, PlacedLetter, letters};
use super::picture::{Anchor, Colour, Picture, Shape};

/// Pixels per point: 216 to the inch.
const PIXELS: f64 = 3.0;
/// Pixels at most, four bytes each: larger pictures have fewer pixels per point.
const MOST_PIXELS: f64 = 3e7;

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
        let points = Transform::from_scale(scale as f32, scale as f32);
        for shape in &self.shapes {
            draw(&mut pixmap, shape, points);
        }
        pixmap.encode_png().map_err(|error| failed(&error))
    }
}

/// Draws one shape; one without extent is left out.
fn draw(pixmap: &mut Pixmap, shape: &Shape, points: Transform) {
    let mut path = PathBuilder::new();
    match shape {
        Shape::Line { points: corners, stroke } => {
            outline(&mut path, corners);
            let dash = stroke.dash.and_then(|(dash, space)| StrokeDash::new(vec![dash as f32, space as f32], 0.0));
            let pen = Pen { width: stroke.width as f32, dash, ..Pen::default() };
            if let Some(path) = path.finish() {
                pixmap.stroke_path(&path, &paint(stroke.colour), &pen, points, None);
            }
        }
        Shape::Area { rings, colour } => {
            for ring in rings {
                outline(&mut path, ring);
                path.close();
            }
            if let Some(path) = path.finish() {
                pixmap.fill_path(&path, &paint(*colour), FillRule::EvenOdd, points, None);
            }
        }
        Shape::Text { at, text, size, colour, anchor } => {
            letters(text, *size, *anchor).iter().for_each(|letter| write(&mut path, letter));
            let turn = if *anchor == Anchor::Upwards { -90.0 } else { 0.0 };
            let place = points.pre_translate(at.0 as f32, at.1 as f32).pre_concat(Transform::from_rotate(turn));
            if let Some(path) = path.finish() {
                pixmap.fill_path(&path, &paint(*colour), FillRule::Winding, place, None);
            }
        }
    }
}

fn paint(colour: Colour) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(colour.r, colour.g, colour.b, 255);
    paint
}

fn outline(path: &mut PathBuilder, points: &[(f64, f64)]) {
    for (i, (x, y)) in points.iter().map(|(x, y)| (*x as f32, *y as f32)).enumerate() {
        if i == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
    }
}

fn write(path: &mut PathBuilder, PlacedLetter { letter, scale, at }: &PlacedLetter) {
    let place = |[x, y]: [f64; 2]| ((at.0 + scale * x) as f32, (at.1 - scale * y) as f32);
    for piece in letter.outline() {
        match piece {
            Piece::Move(to) => {
                let (x, y) = place(to);
                path.move_to(x, y);
            }
            Piece::Line(to) => {
                let (x, y) = place(to);
                path.line_to(x, y);
            }
            Piece::Quadratic(points) => {
                let [(a, b), (x, y)] = points.map(place);
                path.quad_to(a, b, x, y);
            }
            Piece::Cubic(points) => {
                let [(a, b), (c, d), (x, y)] = points.map(place);
                path.cubic_to(a, b, c, d, x, y);
            }
            Piece::Close => path.close(),
        }
    }
}
