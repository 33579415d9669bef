//! The page of the gallery, made of its cases.
use recede::Geometry;

use super::case::{Case, Found, Value};

const HEAD: &str = "\
# Gallery

Real cases with their units, each a scene in `examples/gallery`: `recede solve examples/gallery/rail_pad.ron`, for example.

Values of materials are typical, not measured on a product. *Idealised* lists what a case leaves out besides
friction. The last three cases are axisymmetric, the others plane strain, with forces and stiffnesses per unit length. The *width* of a contact is twice its half-length, or
its diameter. In brackets follows the place of a pressure that is largest outside the middle, and place and depth of the largest shear stress. [Troubleshooting](troubleshooting.md#warnings) explains the
warnings.
";

const FOOT: &str = "
## How this page is made

`cargo run --release --example gallery` makes it: texts are the first comments of the scenes.
";
/// Paragraphs that begin with one of these words and a colon have it in bold type.
const KINDS: [&str; 3] = ["Learnt", "Idealised", "Values"];

/// How the row of the depth of the largest shear stress begins.
const DEPTH: &str = "its depth";
/// What the rows of an interval have in their names.
const LEFT: &str = ": left end of interval";
const WIDTH: &str = ": width of interval";

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
    // depths are written behind the stress, widths of intervals behind their left ends
    for name in names.into_iter().filter(|name| !name.starts_with(DEPTH) && !name.contains(WIDTH)) {
        let cell = |column: &Found| {
            let depth = column.numbers.iter().find(|(other, _)| other.starts_with(DEPTH)).map(|(_, depth)| *depth);
            let depth = depth.filter(|_| name.starts_with("largest shear stress"));
            let width = name.contains(LEFT).then(|| column.number(&name.replace(LEFT, WIDTH))).flatten();
            if let (Some(left), Some(width)) = (column.number(name), width) {
                return format!("{} to {}", digits(left.number), digits(left.number + width.number));
            }
            column.number(name).map_or("–".to_owned(), |value| written(value, depth, geometry))
        };
        let cells = columns.iter().map(cell).collect();
        text += &row(&escaped(&name.replace(LEFT, ": interval")), cells);
    }
    text
}

/// A bar within a cell of a table.
fn escaped(text: &str) -> String {
    text.replace('|', "\\|")
}

fn digits(x: f64) -> String {
    format!("{x:.3e}").parse::<f64>().map_or(x, |rounded| rounded).to_string()
}

/// Four digits, then in brackets where it is, if that is not the middle, and its depth.
fn written(value: Value, depth: Option<Value>, geometry: Geometry) -> String {
    let number = if value.number.is_finite() { digits(value.number) } else { "infinite".to_owned() };
    let on_both_sides = value.is_mirrored && value.at != 0.0 && geometry != Geometry::Axisymmetric;
    let place = format!("{}{}", if on_both_sides { "±" } else { "" }, digits(value.at));
    match depth {
        Some(depth) => format!("{number} ({place}, {})", digits(depth.number)),
        None if value.at != 0.0 => format!("{number} ({place})"),
        None => number,
    }
}

/// The codes of warnings in a line, with the columns that have them unless all do.
fn warnings(columns: &[Found]) -> String {
    let codes = |column: &Found| column.solution.warnings().iter().map(|warning| warning.code.as_str()).collect();
    let codes: Vec<Vec<&str>> = columns.iter().map(codes).collect();
    let mut distinct: Vec<&str> = Vec::new();
    for code in codes.iter().flatten() {
        if !distinct.contains(code) {
            distinct.push(code);
        }
    }
    let written = distinct.into_iter().map(|code| {
        let warned = columns.iter().zip(&codes).filter(|(_, codes)| codes.contains(&code));
        let labels: Vec<&str> = warned.map(|(column, _)| &column.label[..]).collect();
        if labels.len() == columns.len() { format!("`{code}`") } else { format!("`{code}` ({})", labels.join("; ")) }
    });
    let written: Vec<String> = written.collect();
    if written.is_empty() { String::new() } else { format!("\nWarnings: {}\n", written.join(", ")) }
}
