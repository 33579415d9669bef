//! A picture as pixels.
use tiny_skia::{Color, FillRule, Paint, Pixmap, Stroke as Pen, StrokeDash, Transform};

use super::file::PlotError;
use super::picture::{Colour, DrawnShape, Picture};

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
fn draw(pixmap: &mut Pixmap, shape: &DrawnShape, points: Transform) {
    let Some(path) = shape.path() else { return };
    match shape {
        DrawnShape::Line { stroke, .. } => {
            let dash = stroke.dash.and_then(|(dash, space)| StrokeDash::new(vec![dash as f32, space as f32], 0.0));
            let pen = Pen { width: stroke.width as f32, dash, ..Pen::default() };
            pixmap.stroke_path(&path, &paint(stroke.colour), &pen, points, None);
        }
        DrawnShape::Area { colour, .. } => pixmap.fill_path(&path, &paint(*colour), FillRule::EvenOdd, points, None),
        DrawnShape::Text { colour, .. } => pixmap.fill_path(&path, &paint(*colour), FillRule::Winding, points, None),
    }
}

fn paint(colour: Colour) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(colour.r, colour.g, colour.b, 255);
    paint
}
