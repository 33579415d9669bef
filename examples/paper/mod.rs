//! "Double contact analysis of multilayered elastic structures involving functionally graded materials": its model with one
//! of the two layers missing, and what it prints for it.
use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};

use recede::{Error, Exponential, Item, Model, Punch, Scene, Stack};

/// How far the paper's half-lengths of the advancing contact are off, relative.
const LOOSE_A: f64 = 5e-3;
/// How far the paper's half-lengths of the receding contact are off, relative.
const LOOSE_B: f64 = 1.5e-2;

/// Why the last digits differ.
const WHY: &str = "\
The paper stops its iteration when the resultants of the pressures are met to 1e-5, which hardly constrains b: it
contradicts itself where P R, and hence the contact, is the same (load 500 on R = 250, load 1000 on R = 500).";

/// One entry of a table, in units of the layer's thickness and modulus.
#[derive(Clone, Debug, serde::Deserialize)]
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
    /// Whether b cannot be meant.
    #[serde(default)]
    misprinted_b: bool,
}

/// A table as printed, and the scene that it varies.
#[derive(serde::Deserialize)]
struct Printed {
    title: String,
    scene: String,
    entries: Vec<Entry>,
}

/// A table of the paper, computed again.
pub struct Table {
    title: String,
    /// Entries as printed, and a/h and b/h as computed.
    pub rows: Vec<(Entry, [f64; 2])>,
}

/// Computes `table1` (a homogeneous strip on a half-plane) or `table2` (a graded layer on a half-plane) again.
///
/// # Errors
/// Those of reading and solving a scene.
pub fn table(name: &str) -> Result<Table, Error> {
    let Printed { title, scene, entries } = printed(name);
    let scene = Scene::read(root().join("examples/scenes").join(scene))?;
    let mut rows = Vec::new();
    // entries of one stack follow each other: its kernels serve them all
    for entries in entries.chunk_by(|one, other| one.graded == other.graded) {
        let mut items = scene.stack.clone();
        if let Some(beta) = entries[0].graded {
            items[2] = Item::layer(Exponential::new(1.0, 1.0, 0.25, beta)?);
        }
        let model = Model::new(Stack::from_items(scene.plane, &items)?)?;
        for entry in entries {
            let solution = model.press(&Punch::cylinder(entry.radius)?, 1.0 / entry.load)?;
            let half_length = |i: usize| solution.contacts()[i].half_length().unwrap();
            rows.push((entry.clone(), [half_length(0), half_length(1)]));
        }
    }
    Ok(Table { title, rows })
}

impl Table {
    /// Entries that are further off than the paper's method explains; misprints are not counted.
    pub fn wrong(&self) -> Vec<String> {
        let off = |(entry, [a, b]): &&(Entry, [f64; 2])| {
            (entry.a / a - 1.0).abs() > LOOSE_A || (entry.b / b - 1.0).abs() > LOOSE_B && !entry.misprinted_b
        };
        self.rows.iter().filter(off).map(|(entry, computed)| format!("{entry:?}: computed {computed:?}")).collect()
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\n", self.title)?;
        writeln!(f, "   R/h  μh/P     βh │  a/h paper  computed    diff │  b/h paper  computed    diff")?;
        writeln!(f, "────────────────────┼──────────────────────────────┼─────────────────────────────")?;
        for (entry, [a, b]) in &self.rows {
            let beta = entry.graded.map_or("-".to_owned(), |beta| beta.to_string());
            write!(f, "{:6}{:6}{beta:>7} │", entry.radius, entry.load)?;
            write!(f, "{:11.4}{a:10.4}{:+7.2}% │", entry.a, 100.0 * (entry.a / a - 1.0))?;
            write!(f, "{:11.4}{b:10.4}{:+7.2}%", entry.b, 100.0 * (entry.b / b - 1.0))?;
            writeln!(f, "{}", if entry.misprinted_b { "  misprint" } else { "" })?;
        }
        write!(f, "\n{WHY}")
    }
}

fn printed(name: &str) -> Printed {
    let text = std::fs::read_to_string(root().join("tests/data/paper_tables.ron")).expect("the paper's tables");
    let mut tables: BTreeMap<String, Printed> = ron::from_str(&text).expect("the paper's tables");
    tables.remove(name).expect("a table of the paper")
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_owned()
}
