//! The work-precision diagram as SVG: one panel per scene, time upwards, error to the left.
use std::fmt::Write as _;

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

const COLOURS: [&str; 4] = ["#b2182b", "#762a83", "#e08214", "#2166ac"];
const COLUMNS: usize = 3;
const PANEL: [f64; 2] = [300.0, 230.0];
const MARGIN: [f64; 2] = [58.0, 44.0];
/// Decades shown: of the error, and of the time in seconds.
const ERRORS: [i32; 2] = [-13, 0];
const TIMES: [i32; 2] = [-4, 2];

/// The diagram of all scenes.
pub fn svg(panels: &[(&str, &[Curve])]) -> String {
    let rows = panels.len().div_ceil(COLUMNS);
    let (width, height) = (COLUMNS as f64 * PANEL[0], rows as f64 * PANEL[1] + 30.0);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" \
         font-size=\"11\" fill=\"#222\">\n<rect width=\"{width}\" height=\"{height}\" fill=\"white\"/>\n"
    );
    for (k, (title, curves)) in panels.iter().enumerate() {
        let corner = [(k % COLUMNS) as f64 * PANEL[0], (k / COLUMNS) as f64 * PANEL[1]];
        panel(&mut out, corner, title, curves);
    }
    if let Some((_, curves)) = panels.first() {
        for (k, curve) in curves.iter().enumerate() {
            let (x, y) = (MARGIN[0] + 200.0 * k as f64, height - 12.0);
            let colour = COLOURS[k % COLOURS.len()];
            put(&mut out, format!("<circle cx=\"{x}\" cy=\"{}\" r=\"4\" fill=\"{colour}\"/>", y - 4.0));
            put(&mut out, format!("<text x=\"{}\" y=\"{y}\">{}</text>", x + 10.0, curve.name));
        }
    }
    out + "</svg>\n"
}

fn panel(out: &mut String, corner: [f64; 2], title: &str, curves: &[Curve]) {
    let inner = [PANEL[0] - MARGIN[0] - 14.0, PANEL[1] - MARGIN[1] - 26.0];
    let x = |error: f64| {
        let part = (error.max(1e-20).log10() - f64::from(ERRORS[0])) / f64::from(ERRORS[1] - ERRORS[0]);
        corner[0] + MARGIN[0] + inner[0] * part.clamp(0.0, 1.0)
    };
    let y = |seconds: f64| {
        let part = (seconds.log10() - f64::from(TIMES[0])) / f64::from(TIMES[1] - TIMES[0]);
        corner[1] + 26.0 + inner[1] * (1.0 - part.clamp(0.0, 1.0))
    };
    let (left, right) = (x(10f64.powi(ERRORS[0])), x(10f64.powi(ERRORS[1])));
    let (bottom, top) = (y(10f64.powi(TIMES[0])), y(10f64.powi(TIMES[1])));
    put(out, format!("<text x=\"{left}\" y=\"{}\" font-weight=\"bold\">{title}</text>", top - 8.0));
    for decade in (ERRORS[0] + 1..=ERRORS[1]).step_by(3) {
        let at = x(10f64.powi(decade));
        put(out, format!("<path d=\"M{at:.1} {bottom:.1}V{top:.1}\" stroke=\"#ddd\"/>"));
        put(out, format!("<text x=\"{at:.1}\" y=\"{:.1}\" text-anchor=\"middle\">1e{decade}</text>", bottom + 14.0));
    }
    for decade in (TIMES[0]..=TIMES[1]).step_by(2) {
        let at = y(10f64.powi(decade));
        put(out, format!("<path d=\"M{left:.1} {at:.1}H{right:.1}\" stroke=\"#ddd\"/>"));
        put(
            out,
            format!("<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">1e{decade} s</text>", left - 5.0, at + 4.0),
        );
    }
    let middle = 0.5 * (left + right);
    put(
        out,
        format!("<text x=\"{middle:.1}\" y=\"{:.1}\" text-anchor=\"middle\">relative error</text>", bottom + 28.0),
    );
    for (k, curve) in curves.iter().enumerate() {
        let colour = COLOURS[k % COLOURS.len()];
        let places: Vec<[f64; 2]> = curve.points.iter().map(|point| [x(point.error), y(point.seconds)]).collect();
        let line: Vec<String> = places.iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
        put(out, format!("<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\"/>", line.join(" ")));
        for [x, y] in places {
            put(out, format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3\" fill=\"{colour}\"/>"));
        }
    }
}

fn put(out: &mut String, line: String) {
    writeln!(out, "{line}").expect("a string takes all");
}
