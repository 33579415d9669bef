//! The page of the gallery, made of its cases.
use recede::Geometry;

use super::case::{Case, Found, Value};

const HEAD: &str = "\
# Gallery

Real cases with their units, each a scene in `examples/gallery` that can be solved, drawn and varied: `recede solve examples/gallery/rail_pad.ron`, for example.

Values of materials are typical and rounded, not measured on a product; where a standard gives one, it is named. Everything is linear and without
friction; *Idealised* lists what a case leaves out. The last three cases are axisymmetric, the others plane strain, with forces and stiffnesses per unit length out of
the plane. The *width* of a contact is the distance from its left end to its right end (twice the half-length), or its diameter. [troubleshooting.md](troubleshooting.md) explains the
codes of warnings.
";

const FOOT: &str = "
## How this page is made

`cargo run --release --example gallery` writes it from the scenes: the texts are their first comments, the pictures are drawn by `recede plot`, and the numbers are
computed. `tests/gallery.rs` repeats this and compares.
";
/// Paragraphs that begin with one of these words and a colon have it in bold type.
const KINDS: [&str; 3] = ["Learnt", "Idealised", "Values"];

/// The whole page: every case with what is found for it.
pub fn markdown(cases: &[(Case, Vec<Found>)]) -> String {
    HEAD.to_owned() + &cases.iter().map(|(case, columns)| section(case, columns)).collect::<String>() + FOOT
}

fn section(case: &Case, columns: &[Found]) -> String {
    let (title, stem) = (case.scene.title(), case.stem());
    let text: Vec<String> = case.paragraphs.iter().map(|paragraph| emphasised(paragraph)).collect();
    format!(
        "\n## {title}\n\n![{title}](pictures/gallery/{stem}.svg)\n\n{}\n\n{}{}\n[{stem}.ron](../examples/gallery/{stem}.ron)\n",
        text.join("\n\n"),
        table(columns, case.scene.geometry),
        warnings(columns),
    )
}

fn emphasised(paragraph: &str) -> String {
    match paragraph.split_once(": ") {
        Some((kind, rest)) if KINDS.contains(&kind) => {
            let (first, rest) = rest.split_at(rest.chars().next().map_or(0, char::len_utf8));
            format!("**{kind}.** {}{rest}", first.to_uppercase())
        }
        _ => paragraph.to_owned(),
    }
}

/// A row for each number that any of the columns has.
fn table(columns: &[Found], geometry: Geometry) -> String {
    let mut names: Vec<&String> = Vec::new();
    for (name, _) in columns.iter().flat_map(|column| &column.numbers) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let row = |first: &str, cells: Vec<String>| format!("| {first} | {} |\n", cells.join(" | "));
    let mut text = row("", columns.iter().map(|column| escaped(&column.label)).collect());
    text += &row("---", columns.iter().map(|_| "---".to_owned()).collect());
    for name in names {
        let cells = columns
            .iter()
            .map(|column| column.number(name).map_or("–".to_owned(), |value| written(value, geometry)))
            .collect();
        text += &row(&escaped(name), cells);
    }
    text
}

/// A bar within a cell of a table.
fn escaped(text: &str) -> String {
    text.replace('|', "\\|")
}

/// Four digits, and where it is if that is not the middle.
fn written(value: Value, geometry: Geometry) -> String {
    let digits = |x: f64| format!("{x:.3e}").parse::<f64>().map_or(x, |rounded| rounded).to_string();
    let number = if value.number.is_finite() { digits(value.number) } else { "infinite".to_owned() };
    let place = match geometry {
        Geometry::Axisymmetric => format!("r = {}", digits(value.at)),
        _ if value.is_mirrored => format!("x = ±{}", digits(value.at)),
        _ => format!("x = {}", digits(value.at)),
    };
    if value.at != 0.0 { format!("{number}, at {place}") } else { number }
}

fn warnings(columns: &[Found]) -> String {
    let lines = columns.iter().filter(|column| !column.solution.warnings().is_empty()).map(|column| {
        let codes: Vec<String> =
            column.solution.warnings().iter().map(|warning| format!("`{}`", warning.code.as_str())).collect();
        format!("\nWarnings, {}: {}\n", column.label, codes.join(", "))
    });
    lines.collect()
}
