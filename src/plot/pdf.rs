//! A picture as a page of a PDF. Letters are outlines, so that no viewer needs a font.
use pdf_writer::{Content, Filter, Finish, Pdf, Rect, Ref};

use super::letters::{Piece, PlacedLetter, letters};
use super::picture::{Anchor, Colour, Picture, Shape};

/// Effort of the compression, from 0 to 10.
const EFFORT: u8 = 6;

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

fn draw(content: &mut Content, shape: &Shape) {
    match shape {
        Shape::Line { points, stroke } => {
            let [r, g, b] = rgb(stroke.colour);
            let dash = stroke.dash.map_or(Vec::new(), |(dash, space)| vec![dash as f32, space as f32]);
            content.set_stroke_rgb(r, g, b).set_line_width(stroke.width as f32).set_dash_pattern(dash, 0.0);
            path(content, points);
            content.stroke();
        }
        Shape::Area { rings, colour } => {
            let [r, g, b] = rgb(*colour);
            content.set_fill_rgb(r, g, b);
            for ring in rings {
                path(content, ring);
                content.close_path();
            }
            content.fill_even_odd();
        }
        Shape::Text { at, text, size, colour, anchor } => {
            let [r, g, b] = rgb(*colour);
            let (x, y) = (at.0 as f32, at.1 as f32);
            let place = match anchor {
                Anchor::Upwards => [0.0, -1.0, 1.0, 0.0, x, y],
                Anchor::Left | Anchor::Centre | Anchor::Right => [1.0, 0.0, 0.0, 1.0, x, y],
            };
            content.save_state().transform(place).set_fill_rgb(r, g, b);
            letters(text, *size, *anchor).iter().for_each(|letter| write(content, letter));
            content.fill_nonzero().restore_state();
        }
    }
}

fn rgb(colour: Colour) -> [f32; 3] {
    [colour.r, colour.g, colour.b].map(|part| f32::from(part) / 255.0)
}

fn path(content: &mut Content, points: &[(f64, f64)]) {
    for (i, (x, y)) in points.iter().map(|(x, y)| (rounded(*x), rounded(*y))).enumerate() {
        if i == 0 {
            content.move_to(x, y)
        } else {
            content.line_to(x, y)
        };
    }
}

fn write(content: &mut Content, PlacedLetter { letter, scale, at }: &PlacedLetter) {
    let place = |[x, y]: [f64; 2]| [at.0 + scale * x, at.1 - scale * y];
    let mut last = [0.0; 2];
    for piece in letter.outline() {
        let ends = match piece {
            Piece::Move(to) => {
                let [x, y] = place(to).map(rounded);
                content.move_to(x, y);
                to
            }
            Piece::Line(to) => {
                let [x, y] = place(to).map(rounded);
                content.line_to(x, y);
                to
            }
            Piece::Quadratic([control, to]) => {
                // the same curve as a cubic one
                let towards = |end: [f64; 2]| [0, 1].map(|k| (end[k] + 2.0 * control[k]) / 3.0);
                cubic(content, [towards(last), towards(to), to].map(place));
                to
            }
            Piece::Cubic(points) => {
                cubic(content, points.map(place));
                points[2]
            }
            Piece::Close => {
                content.close_path();
                last
            }
        };
        last = ends;
    }
}

fn cubic(content: &mut Content, points: [[f64; 2]; 3]) {
    let [[a, b], [c, d], [x, y]] = points.map(|point| point.map(rounded));
    content.cubic_to(a, b, c, d, x, y);
}

/// Thousandths of a point are finer than any printer.
fn rounded(number: f64) -> f32 {
    ((1e3 * number).round() / 1e3) as f32
}
