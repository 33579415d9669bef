//! Wall time against true error: the paper's method taken literally, and vectorised, and the Galerkin
//! solver, on the same scenes, in one run on one thread. Then the times that have targets.
//!
//! ```text
//! cargo bench --bench work_precision                 prints tables
//! cargo bench --bench work_precision -- --docs       also remakes docs/work_precision.svg and the last two tables, in docs/benchmark.md
//! ```
use std::fmt::Write as _;
use std::path::Path;

#[path = "work_precision/cases.rs"]
mod cases;
#[path = "work_precision/diagram.rs"]
mod diagram;
#[path = "literal/mod.rs"]
mod literal;
#[path = "work_precision/stages.rs"]
mod stages;
#[path = "work_precision/timing.rs"]
mod timing;

use cases::{Case, values};
use diagram::{Curve, Point};
use literal::{Collocation, Problem, Settings, Transforms, vectorised};
use recede::{Model, Options, plot};
use timing::{seconds, time};

/// Rounding, times what the equations of the literal method amplify it by: below the lower cut-off k_1 to k_4 would diverge,
/// and what is large in them cancels between the contacts.
const ROUNDING: f64 = 1e-9;
/// The truth is known to that.
const DOUBTFUL: f64 = 1e-13;

fn main() {
    let remake = std::env::args().any(|argument| argument == "--docs");
    let cases = cases::all();
    let measured: Vec<(&Case, Vec<Curve>)> = cases.iter().map(|case| (case, curves(case))).collect();
    let (mut points, mut text) = (String::new(), String::new());
    for (case, curves) in &measured {
        table(&mut points, case, curves);
    }
    comparison(&mut text, &measured);
    stages::table(&mut text);
    println!("{points}{text}");
    if remake {
        let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
        let panels: Vec<(&str, &[Curve])> = measured.iter().map(|(case, curves)| (case.title, &curves[..])).collect();
        plot::save(&docs.join("work_precision.svg"), &diagram::picture(&panels)).expect("docs can be written");
        let path = docs.join("benchmark.md");
        let document = std::fs::read_to_string(&path).expect("docs/benchmark.md");
        std::fs::write(&path, between_marks(&document, &text)).expect("docs can be written");
    }
}

/// The document with the text between its two marks replaced.
fn between_marks(document: &str, text: &str) -> String {
    const MARKS: [&str; 2] = ["<!-- cargo bench: begin -->", "<!-- cargo bench: end -->"];
    let begin = document.find(MARKS[0]).expect("a mark where the tables begin") + MARKS[0].len();
    let end = document.find(MARKS[1]).expect("a mark where the tables end");
    format!("{}\n\n{}\n{}", &document[..begin], text.trim_end(), &document[end..])
}

/// All methods on one scene, each at several settings.
fn curves(case: &Case) -> Vec<Curve> {
    let scene = &case.scene;
    let error = |found: &[f64]| -> f64 {
        let off = found.iter().zip(&case.truth).map(|(found, truth)| (found / truth - 1.0).abs());
        // not a number is no answer
        off.fold(0.0, |worst: f64, off| if off.is_nan() { f64::INFINITY } else { worst.max(off) })
    };
    let solver = |name: &'static str, tolerances: &[f64]| {
        let point = |tolerance: &f64| {
            let options = Options { tolerance: *tolerance };
            let solve = || {
                let model = Model::new(scene.stack().expect("a stack")).expect("a model");
                model.press_with(&scene.top, scene.force, &options).expect("a solution")
            };
            let (seconds, solution) = time(solve);
            let setting = format!("tolerance {tolerance:.0e}: {} modes", solution.modes());
            Point { setting, seconds, error: error(&values(&solution)) }
        };
        Curve { name, points: tolerances.iter().map(point).collect() }
    };
    vec![
        rival("literal", case, literal::collocate, &error),
        rival("vectorised", case, vectorised::collocate, &error),
        solver("Galerkin", &[1e-4, 1e-6, 1e-8, 1e-10, 1e-12]),
    ]
}

/// The paper's method, its equations assembled in one of two ways.
fn rival(name: &'static str, case: &Case, collocation: Collocation, error: &dyn Fn(&[f64]) -> f64) -> Curve {
    let scene = &case.scene;
    // it starts a fifth away from the truth, which is kind
    let start: Vec<f64> = case.truth.iter().step_by(2).map(|a| 1.2 * a).collect();
    let slope = |x: f64| scene.top.punch().expect("a punch").slope(x);
    let force = scene.force.given().expect("a force");
    let transforms: &dyn Transforms = if name == "literal" { case.literal() } else { &case.chains };
    let problem = Problem { transforms, slope: &slope, force, start: &start };
    let usual = Settings::USUAL;
    let settings = [
        Settings { nodes: 20, ..usual },
        usual,
        Settings { low: usual.low / 10.0, ..usual },
        Settings { nodes: 80, low: usual.low / 100.0, residual: 1e-10, ..usual },
    ];
    let scaled = |settings: &Settings| Settings {
        low: settings.low / case.thinnest.max(1.0),
        high: settings.high / case.thinnest,
        ..*settings
    };
    let apart = literal::difference(&Problem { transforms: case.literal(), ..problem }, &scaled(&usual));
    assert!(apart < ROUNDING, "{}: the literal and the vectorised answer differ by {apart:e}", case.title);
    let point = |settings: &Settings| {
        let (seconds, answer) = time(|| literal::solve(&problem, &scaled(settings), collocation));
        let Settings { nodes, low, residual, .. } = settings;
        let mut setting =
            format!("N = {nodes}, λh > {low:.0e}, residual {residual:.0e}: {} systems", answer.iterations);
        if !answer.converged {
            setting += ", not converged";
        }
        Point { setting, seconds, error: error(&answer.values()) }
    };
    Curve { name, points: settings.iter().map(point).collect() }
}

fn table(text: &mut String, case: &Case, curves: &[Curve]) {
    let mut line = |line: String| writeln!(text, "{line}").expect("a string takes all");
    line(format!("### {}\n\n| method | setting | time | error |\n|---|---|---|---|", case.title));
    for curve in curves {
        for Point { setting, seconds: time, error } in &curve.points {
            // below that, digits of the truth itself are in doubt
            let error = if *error < DOUBTFUL { format!("< {DOUBTFUL:.0e}") } else { format!("{error:.0e}") };
            line(format!("| {} | {setting} | {} | {error} |", curve.name, seconds(*time)));
        }
    }
    line(String::new());
}

/// The Galerkin solver, at its default tolerance, against the paper's method at its usual settings.
fn comparison(text: &mut String, measured: &[(&Case, Vec<Curve>)]) {
    let mut line = |line: String| writeln!(text, "{line}").expect("a string takes all");
    line("### Galerkin at 1e-10 against the paper's method at its usual settings\n".to_owned());
    line("| scene | times faster than vectorised | than literal | times less error |\n|---|---|---|---|".to_owned());
    for (case, curves) in measured {
        let [literal, vectorised] = [0, 1].map(|rival| &curves[rival].points[1]);
        let galerkin = &curves[2].points[3];
        let [fast, slow] = [vectorised, literal].map(|rival| rival.seconds / galerkin.seconds);
        let closer = vectorised.error / galerkin.error.max(DOUBTFUL);
        line(format!("| {} | {fast:.0} | {slow:.0} | {closer:.0e} |", case.title));
    }
    line(String::new());
}
