//! Curves on doubly logarithmic axes, as SVG.
use std::ops::Range;
use std::path::Path;

use recede::plot::{self, Anchor, Chart, Colour, Frame, Labels, Picture, PlotError, Scale, Stroke, style};

/// A curve and its name.
pub struct Curve {
    pub name: &'static str,
    pub points: Vec<(f64, f64)>,
}

/// A diagram: exponents of ten on both axes.
pub struct Diagram {
    pub title: String,
    pub x: Range<i32>,
    pub y: Range<i32>,
    pub x_name: &'static str,
    pub y_name: &'static str,
    pub curves: Vec<Curve>,
}

/// Distinct also without colours by their order of darkness.
const COLOURS: [Colour; 3] =
    [Colour { r: 213, g: 94, b: 0 }, Colour { r: 0, g: 114, b: 178 }, Colour { r: 20, g: 20, b: 20 }];
/// Size of a diagram with its labels, in points.
const SIZE: (f64, f64) = (400.0, 250.0);
/// The part of it that the curves have.
const FRAME: Frame = Frame { left: 64.0, top: 26.0, right: 265.0, bottom: 205.0 };

/// Draws diagrams into one picture, a given number in a row.
pub fn draw(path: &Path, diagrams: &[Diagram], columns: usize) -> Result<(), PlotError> {
    let mut picture = Picture::new(SIZE.0 * columns as f64, SIZE.1 * diagrams.len().div_ceil(columns) as f64);
    for (i, diagram) in diagrams.iter().enumerate() {
        let (left, top) = (SIZE.0 * (i % columns) as f64, SIZE.1 * (i / columns) as f64);
        let frame = Frame {
            left: left + FRAME.left,
            top: top + FRAME.top,
            right: left + FRAME.right,
            bottom: top + FRAME.bottom,
        };
        let middle = 0.5 * (frame.left + frame.right);
        picture.text((middle, frame.top - 12.0), &diagram.title, style::TEXT, style::INK, Anchor::Centre);
        diagram.chart(frame).draw(&mut picture);
    }
    plot::save(path, &picture.fitted())
}

impl Diagram {
    fn chart(&self, frame: Frame) -> Chart {
        let power = |exponent: i32| 10f64.powi(exponent);
        let scale = |range: &Range<i32>| Scale::around([power(range.start), power(range.end)]).logarithmic();
        let (low, high) = (power(self.y.start), power(self.y.end));
        // what is no number is as wrong as can be
        let shown = |(x, y): &(f64, f64)| (*x, if y.is_nan() { high } else { y.clamp(low, high) });
        let curves = self.curves.iter().zip(COLOURS).map(|(curve, colour)| plot::Curve {
            points: curve.points.iter().map(shown).collect(),
            stroke: Stroke { colour, width: style::BOLD, dash: None },
            label: if self.curves.len() > 1 { curve.name.to_owned() } else { String::new() },
        });
        Chart {
            frame,
            x: scale(&self.x).of(self.x_name, None),
            y: scale(&self.y).of(self.y_name, None),
            curves: curves.collect(),
            labels: Labels::Listed,
        }
    }
}
