//! A picture as a page of a PDF. Letters are outlines, so that no viewer needs a font.
use pdf_writer::{Content, Filter, Finish, Pdf, Rect, Ref};
use tiny_skia::{Path, PathSegment, Point};

use super::picture::{DrawnShape, Picture, Stroke};

/// Effort of the compression, from 0 to 10.
const EFFORT: u8 = 6;
const THIRD: f32 = 1.0 / 3.0;

impl Picture {
    /// The picture as PDF: one page of its size, the same bytes each time.
    pub fn pdf(&self) -> Vec<u8> {
        let [catalogue, pages, page, drawing] = [1, 2, 3, 4].map(Ref::new);
        let (width, height) = (self.size.0 as f32, self.size.1 as f32);
        let mut content = Content::new();
        // y downwards, as in the picture
        content.transform([1.0, 0.0, 0.0, -1.0, 0.0, height]);
        for shape in &self.shapes {
            draw(&mut content, shape);
        }
        let content = miniz_oxide::deflate::compress_to_vec_zlib(content.finish().as_slice(), EFFORT);
        let mut pdf = Pdf::new();
        pdf.catalog(catalogue).pages(pages);
        pdf.pages(pages).kids([page]).count(1);
        let mut only = pdf.page(page);
        only.media_box(Rect::new(0.0, 0.0, width, height)).parent(pages).contents(drawing);
        only.resources();
        only.finish();
        pdf.stream(drawing, &content).filter(Filter::FlateDecode);
        pdf.finish()
    }
}

/// Draws one shape; one without extent is left out.
fn draw(content: &mut Content, shape: &DrawnShape) {
    let Some(path) = shape.path() else { return };
    let (DrawnShape::Line { stroke: Stroke { colour, .. }, .. }
    | DrawnShape::Area { colour, .. }
    | DrawnShape::Text { colour, .. }) = shape;
    let [r, g, b] = [colour.r, colour.g, colour.b].map(|part| f32::from(part) / 255.0);
    if let DrawnShape::Line { stroke, .. } = shape {
        let dash = stroke.dash.map_or(Vec::new(), |(dash, space)| vec![dash as f32, space as f32]);
        content.set_stroke_rgb(r, g, b).set_line_width(stroke.width as f32).set_dash_pattern(dash, 0.0);
    } else {
        content.set_fill_rgb(r, g, b);
    }
    outline(content, &path);
    match shape {
        DrawnShape::Line { .. } => content.stroke(),
        DrawnShape::Area { .. } => content.fill_even_odd(),
        DrawnShape::Text { .. } => content.fill_nonzero(),
    };
}

fn outline(content: &mut Content, path: &Path) {
    // thousandths of a point are finer than any printer
    let rounded = |point: Point| [point.x, point.y].map(|number| (1e3 * number).round() / 1e3);
    let mut last = Point::zero();
    for segment in path.segments() {
        let (curve, to) = match segment {
            PathSegment::Close => {
                content.close_path();
                continue;
            }
            PathSegment::MoveTo(to) | PathSegment::LineTo(to) => (None, to),
            // the same curve as a cubic one
            PathSegment::QuadTo(by, to) => {
                (Some([last, to].map(|end| (end + by + by) * Point::from_xy(THIRD, THIRD))), to)
            }
            PathSegment::CubicTo(from, towards, to) => (Some([from, towards]), to),
        };
        let [x, y] = rounded(to);
        match curve.map(|controls| controls.map(rounded)) {
            Some([[a, b], [c, d]]) => content.cubic_to(a, b, c, d, x, y),
            None if matches!(segment, PathSegment::MoveTo(_)) => content.move_to(x, y),
            None => content.line_to(x, y),
        };
        last = to;
    }
}
