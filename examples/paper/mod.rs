//! "Double contact analysis of multilayered elastic structures involving functionally graded materials": its model with one
//! of the two layers missing, what it prints for it, and what is computed here.
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use recede::{Error, Exponential, Item, Model, Punch, Scene, Stack};

/// One entry of a table, in units of the layer's thickness and modulus.
#[derive(Clone, Debug, serde::Deserialize)]
#[allow(dead_code, reason = "a test that compares with a reference of many digits needs little of it")]
pub struct Entry {
    /// R/h.
    pub radius: f64,
    /// μh/P.
    pub load: f64,
    /// βh of a graded layer; `None` is a homogeneous strip.
    pub graded: Option<f64>,
    /// a/h as printed.
    pub a: f64,
    /// b/h as printed.
    pub b: f64,
    /// What it quotes for a/h and b/h from an earlier paper.
    #[serde(default)]
    pub kahya: Option<(f64, f64)>,
    /// Whether b cannot be meant.
    #[serde(default)]
    pub misprinted_b: bool,
}

/// An entry, and a/h and b/h as computed.
#[derive(Clone, Debug)]
#[allow(dead_code, reason = "as before")]
pub struct Row {
    /// As printed.
    pub entry: Entry,
    /// a/h and b/h.
    pub computed: [f64; 2],
    /// The solver's estimates of their errors.
    pub errors: [f64; 2],
}

/// A table as printed, and the scene that it varies.
#[derive(serde::Deserialize)]
struct Printed {
    scene: String,
    entries: Vec<Entry>,
}

/// Computes `table1` (a homogeneous strip on a half-plane) or `table2` (a graded layer on a half-plane) again.
///
/// # Errors
/// Those of reading and solving a scene.
pub fn table(name: &str) -> Result<Vec<Row>, Error> {
    let Printed { scene, entries } = printed(name);
    let scene = Scene::read(root().join("examples/scenes").join(scene))?;
    let mut rows = Vec::new();
    // entries of one stack follow each other: its kernels serve them all
    for entries in entries.chunk_by(|one, other| one.graded == other.graded) {
        let mut items = scene.stack.clone();
        if let Some(beta) = entries[0].graded {
            items[2] = Item::layer(Exponential::new(1.0, 1.0, 0.25, beta)?);
        }
        let model = Model::new(Stack::from_items(scene.geometry, &items)?)?;
        for entry in entries {
            let solution = model.press(&Punch::cylinder(entry.radius)?, 1.0 / entry.load)?;
            let contact = |i: usize| &solution.contacts()[i];
            rows.push(Row {
                entry: entry.clone(),
                computed: [0, 1].map(|i| contact(i).half_length().unwrap()),
                errors: [0, 1].map(|i| contact(i).half_length_error().unwrap()),
            });
        }
    }
    Ok(rows)
}

fn printed(name: &str) -> Printed {
    let text = std::fs::read_to_string(root().join("tests/data/paper_tables.ron")).expect("the paper's tables");
    let mut tables: BTreeMap<String, Printed> = ron::from_str(&text).expect("the paper's tables");
    tables.remove(name).expect("a table of the paper")
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_owned()
}
