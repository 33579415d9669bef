//! The full model of "Double contact analysis of multilayered elastic structures involving functionally graded materials":
//! what its text says about the half-lengths, and what is computed here.
//!
//! `cargo run --release --example full_model`
//!
//! The paper shows curves and prints no table of the full model, so there is no number to compare with. Its parameters
//! are h1 = h2, mu1 = mu3, mu1 h1/P = 500, R/h1 = 500 and 1000, beta h2 from -3 to 1 (nu = 1/4, plane strain).
use std::path::Path;

use recede::{Error, Exponential, Item, Model, Punch, Scene, Stack};

const RADII: [f64; 3] = [250.0, 500.0, 1000.0];
const STEEPNESS: [f64; 10] = [-3.0, -2.5, -2.0, -1.5, -1.0, -0.5, 0.001, 0.25, 0.5, 1.0];

/// Prints the table and checks it.
pub fn main() -> Result<(), Error> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scenes/strip_fgm_half_plane.ron");
    let scene = Scene::read(file)?;
    let model = |beta: f64| {
        let mut items = scene.stack.clone();
        items[2] = Item::layer(Exponential::new(1.0, 1.0, 0.25, beta)?);
        Model::new(Stack::from_items(scene.geometry, &items)?)
    };
    let half_lengths = |model: &Model, radius: f64| -> Result<[f64; 2], Error> {
        let solution = model.press(&Punch::cylinder(radius)?, scene.force)?;
        Ok([0, 1].map(|i| solution.contacts()[i].half_length().unwrap()))
    };

    println!("The full model: a strip on a graded layer on a half-plane\n");
    println!("    βh2 │  R/h1 = 250      │  R/h1 = 500      │  R/h1 = 1000");
    println!("        │  a/h1     b/h1   │  a/h1     b/h1   │  a/h1     b/h1");
    println!("────────┼──────────────────┼──────────────────┼─────────────────");
    let mut rows = Vec::new();
    for beta in STEEPNESS {
        let model = model(beta)?;
        let mut row = Vec::new();
        for radius in RADII {
            row.push(half_lengths(&model, radius)?);
        }
        let cells: Vec<String> = row.iter().map(|[a, b]| format!("{a:8.5} {b:8.5}")).collect();
        println!("{beta:7} │{} ", cells.join(" │"));
        rows.push(row);
    }

    // b is smallest somewhere between: bisect for the place where it neither falls nor grows
    let mut critical = Vec::new();
    for radius in RADII {
        let (mut low, mut high) = (-3.0f64, 0.0f64);
        while high - low > 1e-3 {
            let middle = 0.5 * (low + high);
            let [left, right] = [middle - 1e-3, middle + 1e-3].map(|beta| half_lengths(&model(beta)?, radius));
            if left?[1] > right?[1] { low = middle } else { high = middle }
        }
        critical.push(0.5 * (low + high));
    }

    println!();
    let columns = |i: usize, contact: usize| rows.iter().map(move |row: &Vec<[f64; 2]>| row[i][contact]);
    claim("a falls as the graded layer gets stiffer", (0..3).all(|i| columns(i, 0).is_sorted_by(|x, y| x > y)));
    claim(
        "both contacts are longer under larger punches",
        rows.iter().all(|row| row.is_sorted_by(|x, y| x[0] < y[0] && x[1] < y[1])),
    );
    claim("the receding contact is longer than the advancing one", rows.iter().flatten().all(|[a, b]| a < b));
    let inside = |i: usize| columns(i, 1).skip(1).fold(f64::INFINITY, f64::min);
    claim("b has a minimum in between", (0..3).all(|i| inside(i) < rows[0][i][1] && inside(i) < rows[9][i][1]));
    claim("the minimum lies at a larger βh2 for larger punches", critical.is_sorted_by(|x, y| x < y));
    println!("        it lies at βh2 = {}", critical.iter().map(|x| format!("{x:.2}")).collect::<Vec<_>>().join(", "));
    Ok(())
}

/// Prints a claim of the paper that holds.
fn claim(text: &str, holds: bool) {
    assert!(holds, "does not hold: {text}");
    println!("holds:  {text}");
}
