//! Curves on doubly logarithmic axes, as SVG.
use std::error::Error;
use std::ops::Range;

use plotters::prelude::*;

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
const COLOURS: [RGBColor; 3] = [RGBColor(213, 94, 0), RGBColor(0, 114, 178), RGBColor(20, 20, 20)];
const WIDTH: u32 = 460;
const HEIGHT: u32 = 320;

/// Draws diagrams into one picture, a given number in a row.
pub fn draw(path: &std::path::Path, diagrams: &[Diagram], columns: u32) -> Result<(), Box<dyn Error>> {
    let rows = (diagrams.len() as u32).div_ceil(columns);
    let root = SVGBackend::new(path, (WIDTH * columns, HEIGHT * rows)).into_drawing_area();
    root.fill(&WHITE)?;
    for (diagram, area) in diagrams.iter().zip(root.split_evenly((rows as usize, columns as usize))) {
        let power = |exponent: i32| 10f64.powi(exponent);
        let mut chart = ChartBuilder::on(&area)
            .caption(&diagram.title, ("sans-serif", 15))
            .margin(10)
            .x_label_area_size(40)
            .y_label_area_size(58)
            .build_cartesian_2d(
                (power(diagram.x.start)..power(diagram.x.end)).log_scale(),
                (power(diagram.y.start)..power(diagram.y.end)).log_scale(),
            )?;
        chart
            .configure_mesh()
            .x_desc(diagram.x_name)
            .y_desc(diagram.y_name)
            .x_labels(9)
            .y_labels(10)
            .x_label_formatter(&exponent)
            .y_label_formatter(&exponent)
            .light_line_style(TRANSPARENT)
            .bold_line_style(RGBColor(220, 220, 220))
            .label_style(("sans-serif", 12))
            .draw()?;
        let (low, high) = (power(diagram.y.start), power(diagram.y.end));
        for (curve, colour) in diagram.curves.iter().zip(COLOURS) {
            // what is no number is as wrong as can be
            let shown = curve.points.iter().map(|(x, y)| (*x, if y.is_nan() { high } else { y.clamp(low, high) }));
            let line = PathElement::new(shown.collect::<Vec<_>>(), colour.stroke_width(2));
            chart
                .draw_series([line])?
                .label(curve.name)
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 16, y)], colour.stroke_width(2)));
        }
        if diagram.curves.len() > 1 {
            chart
                .configure_series_labels()
                .position(SeriesLabelPosition::MiddleLeft)
                .background_style(WHITE.mix(0.0))
                .label_font(("sans-serif", 12))
                .draw()?;
        }
    }
    root.present()?;
    Ok(())
}

fn exponent(value: &f64) -> String {
    format!("1e{}", value.log10().round() as i32)
}
