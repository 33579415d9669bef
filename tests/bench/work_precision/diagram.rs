//! The work-precision diagram: one panel per scene, time upwards, error to the left.
use recede::plot::{Anchor, Chart, Colour, Curve as Line, Frame, Labels, Picture, Scale, Stroke, style};

/// One method on one scene.
pub struct Curve {
    pub name: &'static str,
    pub points: Vec<Point>,
}

/// One setting of a method.
pub struct Point {
    pub setting: String,
    /// Wall time in seconds.
    pub seconds: f64,
    /// Largest relative error of half-lengths and pressures at x = 0.
    pub error: f64,
}

const COLOURS: [Colour; 4] = [
    Colour { r: 178, g: 24, b: 43 },
    Colour { r: 118, g: 42, b: 131 },
    Colour { r: 224, g: 130, b: 20 },
    Colour { r: 33, g: 102, b: 172 },
];
const COLUMNS: usize = 3;
/// Distance of the panels, and their size, in points.
const PANEL: [f64; 2] = [305.0, 235.0];
const SIZE: [f64; 2] = [228.0, 160.0];
/// Range of the error, and of the time in seconds.
const ERRORS: [f64; 2] = [1e-13, 1.0];
const TIMES: [f64; 2] = [1e-4, 1e2];

/// The diagram of all scenes.
pub fn picture(panels: &[(&str, &[Curve])]) -> Picture {
    let mut picture = Picture::new(PANEL[0], PANEL[1]);
    for (k, (title, curves)) in panels.iter().enumerate() {
        panel(&mut picture, [(k % COLUMNS) as f64 * PANEL[0], (k / COLUMNS) as f64 * PANEL[1]], title, curves);
    }
    if let Some((_, curves)) = panels.first() {
        let y = panels.len().div_ceil(COLUMNS) as f64 * PANEL[1] - 10.0;
        for (k, curve) in curves.iter().enumerate() {
            let x = 210.0 * k as f64;
            dot(&mut picture, (x, y), COLOURS[k % COLOURS.len()]);
            picture.text((x + 10.0, y), curve.name, style::TEXT, style::INK, Anchor::Left);
        }
    }
    picture.fitted()
}

fn panel(picture: &mut Picture, [left, top]: [f64; 2], title: &str, curves: &[Curve]) {
    let shown = |value: f64, [low, high]: [f64; 2]| value.clamp(low, high);
    let points = |curve: &Curve| -> Vec<(f64, f64)> {
        curve.points.iter().map(|point| (shown(point.error, ERRORS), shown(point.seconds, TIMES))).collect()
    };
    let lines = curves.iter().zip(COLOURS.iter().cycle()).map(|(curve, colour)| Line {
        points: points(curve),
        stroke: Stroke { colour: *colour, width: 1.0, dash: None },
        label: String::new(),
    });
    let chart = Chart {
        frame: Frame { left, top, right: left + SIZE[0], bottom: top + SIZE[1] },
        x: Scale::around(ERRORS).logarithmic().of("relative error", None),
        y: Scale::around(TIMES).logarithmic().of("time", Some("s".into())),
        curves: lines.collect(),
        labels: Labels::AtEnds,
    };
    chart.draw(picture);
    for (curve, colour) in curves.iter().zip(COLOURS.iter().cycle()) {
        points(curve).into_iter().for_each(|point| dot(picture, chart.place(point), *colour));
    }
    picture.text((left, top - 12.0), title, style::TEXT, style::INK, Anchor::Left);
}

fn dot(picture: &mut Picture, (x, y): (f64, f64), colour: Colour) {
    let corner = |k: i32| std::f64::consts::TAU * f64::from(k) / 16.0;
    picture
        .area(&(0..16).map(corner).map(|phi| (x + 3.0 * phi.cos(), y + 3.0 * phi.sin())).collect::<Vec<_>>(), colour);
}
