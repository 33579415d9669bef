//! What is drawn on: lines, areas and text, in points, y downwards.
use plotters::coord::Shift;
use plotters::element::{DashedPathElement, PathElement, Polygon, Text};
use plotters::prelude::{
    Color, DrawingArea, FontStyle, FontTransform, IntoDrawingArea, IntoFont, IntoTextStyle, RGBColor, SVGBackend,
    ShapeStyle,
};
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::target::{FAMILY, PlotError};

/// Coordinates of the drawing library are whole numbers: so many to a point.
const FINE: f64 = 20.0;
/// The library takes the height of a line where SVG takes that of the letters.
const LINE: f64 = 1.24;
/// Begin and end of what is set in italics, until the SVG is complete.
const ITALIC: [char; 2] = ['\u{e000}', '\u{e001}'];

/// The same for what is set small and low.
const LOW: [char; 2] = ['\u{e002}', '\u{e003}'];

/// A colour.
pub type Colour = RGBColor;

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Its colour.
    pub colour: Colour,
    /// Its width, in points.
    pub width: f64,
    /// Length of dashes and of the space between, in points.
    pub dash: Option<(f64, f64)>,
}

/// Which point of a text is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// Middle of its left end.
    Left,
    /// Its middle.
    Centre,
    /// Middle of its right end.
    Right,
    /// Its middle, and it runs upwards.
    Upwards,
}

/// A picture that is being drawn.
pub struct Canvas<'a> {
    area: DrawingArea<SVGBackend<'a>, Shift>,
}

/// Draws a picture of this size (in points) as SVG.
///
/// # Errors
/// [`PlotError::Drawing`] if the drawing library fails, and those of `draw`.
pub fn svg(
    width: f64,
    height: f64,
    draw: impl FnOnce(&Canvas<'_>) -> Result<(), PlotError>,
) -> Result<String, PlotError> {
    let mut text = String::new();
    let size = (fine(width) as u32, fine(height) as u32);
    {
        let area = SVGBackend::with_string(&mut text, size).into_drawing_area();
        area.fill(&plotters::style::WHITE).map_err(failed)?;
        let canvas = Canvas { area };
        draw(&canvas)?;
        canvas.area.present().map_err(failed)?;
    }
    let fine = format!("width=\"{}\" height=\"{}\"", size.0, size.1);
    let [begin, end] = ITALIC;
    let points = format!("width=\"{width}\" height=\"{height}\"");
    let text = text.replacen(&fine, &points, 1).replace(begin, "<tspan font-style=\"italic\">");
    let [low, level] = LOW;
    Ok(text.replace(low, "<tspan baseline-shift=\"sub\" font-size=\"70%\">").replace([end, level], "</tspan>"))
}

/// A symbol, set in italics.
pub fn italic(symbol: &str) -> String {
    let [begin, end] = ITALIC;
    format!("{begin}{symbol}{end}")
}

/// An index, set small and low.
pub fn subscript(index: &str) -> String {
    let [begin, end] = LOW;
    format!("{begin}{index}{end}")
}

impl Canvas<'_> {
    /// A line through points.
    ///
    /// # Errors
    /// [`PlotError::Drawing`] if the drawing library fails; so for all of them.
    pub fn line(&self, points: &[(f64, f64)], stroke: Stroke) -> Result<(), PlotError> {
        let style = ShapeStyle { color: stroke.colour.into(), filled: false, stroke_width: fine(stroke.width) as u32 };
        let points: Vec<(i32, i32)> = points.iter().map(|point| place(*point)).collect();
        match stroke.dash {
            None => self.area.draw(&PathElement::new(points, style)),
            Some((dash, space)) => self.area.draw(&DashedPathElement::new(points, fine(dash), fine(space), style)),
        }
        .map_err(failed)
    }

    /// A filled area; `opacity` from 0 to 1.
    ///
    /// # Errors
    /// As [`Canvas::line`].
    pub fn area(&self, points: &[(f64, f64)], colour: Colour, opacity: f64) -> Result<(), PlotError> {
        let points: Vec<(i32, i32)> = points.iter().map(|point| place(*point)).collect();
        self.area.draw(&Polygon::new(points, colour.mix(opacity).filled())).map_err(failed)
    }

    /// A filled rectangle from one corner to the other.
    ///
    /// # Errors
    /// As [`Canvas::line`].
    pub fn rectangle(&self, from: (f64, f64), to: (f64, f64), colour: Colour) -> Result<(), PlotError> {
        self.area(&[from, (to.0, from.1), to, (from.0, to.1)], colour, 1.0)
    }

    /// A text of letters `size` points high.
    ///
    /// # Errors
    /// As [`Canvas::line`].
    pub fn text(&self, at: (f64, f64), text: &str, size: f64, colour: Colour, anchor: Anchor) -> Result<(), PlotError> {
        let horizontal = match anchor {
            Anchor::Left => HPos::Left,
            Anchor::Right => HPos::Right,
            Anchor::Centre | Anchor::Upwards => HPos::Center,
        };
        let turn = if anchor == Anchor::Upwards { FontTransform::Rotate270 } else { FontTransform::None };
        let font = (FAMILY, size * LINE * FINE).into_font().style(FontStyle::Normal).transform(turn);
        let style = font.into_text_style(&self.area).color(&colour).pos(Pos::new(horizontal, VPos::Center));
        self.area.draw(&Text::new(text.to_owned(), place(at), style)).map_err(failed)
    }
}

fn fine(points: f64) -> i32 {
    (points * FINE).round() as i32
}

fn place((x, y): (f64, f64)) -> (i32, i32) {
    (fine(x), fine(y))
}

fn failed(error: impl std::fmt::Display) -> PlotError {
    PlotError::Drawing(error.to_string())
}
