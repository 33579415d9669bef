//! Everything in examples/ does what it says.
//!
//! Goal: every scene is read and solved, says in its first line what it shows, and is unlike the others; every program
//! runs and asserts its own answer.
use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use recede::Scene;

#[path = "../examples/custom_layer.rs"]
mod custom_layer;
#[path = "../examples/figures.rs"]
#[allow(dead_code, reason = "its main function writes into docs/")]
mod figures;
#[path = "../examples/full_model.rs"]
mod full_model;
#[path = "../examples/library.rs"]
mod library;
#[path = "../examples/published_tables.rs"]
#[allow(dead_code, reason = "its main function writes into docs/")]
mod published_tables;

fn files(folder: &str, ending: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<PathBuf> =
        entries.filter(|file| file.extension().is_some_and(|found| found == ending)).collect();
    files.sort();
    files
}

/// The main function of an example.
type Program = fn() -> Result<(), Box<dyn Error>>;

#[test]
fn scenes_are_solved() {
    let scenes = files("examples/scenes", "ron");
    assert!(scenes.len() >= 8, "{scenes:?}");
    for file in scenes {
        let scene = Scene::read(&file).unwrap_or_else(|error| panic!("{error}"));
        let solution = recede::solve(&scene).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        assert_eq!(solution.warnings(), [], "{}", file.display());
        for contact in solution.contacts() {
            for interval in contact.intervals() {
                let error = interval.left_error.max(interval.right_error);
                assert!(error <= 1e-10 * contact.reach(), "{}: {contact:?}", file.display());
            }
            assert!((contact.resultant / solution.force() - 1.0).abs() < 1e-12, "{}: {contact:?}", file.display());
        }
    }
}

#[test]
fn scenes_say_what_they_show() {
    let mut shown = BTreeMap::new();
    for file in files("examples/scenes", "ron") {
        let text = fs::read_to_string(&file).unwrap();
        let first = text.lines().next().unwrap_or_default().to_owned();
        let sentence = first.strip_prefix("// ").unwrap_or_else(|| panic!("{}: no comment first", file.display()));
        assert!(sentence.len() > 20 && sentence.ends_with('.'), "{}: {sentence}", file.display());
        if let Some(other) = shown.insert(sentence.to_owned(), file.clone()) {
            panic!("{} shows what {} does", file.display(), other.display());
        }
    }
}

#[test]
fn programs_assert_their_answers() {
    let programs: [(&str, Program); 6] = [
        ("custom_layer", || Ok(custom_layer::main()?)),
        ("figures", figures_as_in_the_documents),
        ("full_model", || Ok(full_model::main()?)),
        ("gallery", crate::gallery::page_as_in_the_documents),
        ("library", || Ok(library::main()?)),
        ("published_tables", tables_as_in_the_documents),
    ];
    let names = files("examples", "rs");
    let names: Vec<&str> = names.iter().map(|file| file.file_stem().unwrap().to_str().unwrap()).collect();
    assert_eq!(names, programs.map(|(name, _)| name), "a program that is not run here");
    for (name, main) in programs {
        main().unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

/// Draws the paper's figures aside, and compares what is said of them with docs/figures.
fn figures_as_in_the_documents() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("figures");
    figures::draw(&folder)?;
    let documents = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/figures");
    let said = |folder: &Path| fs::read_to_string(folder.join("README.md"));
    assert_eq!(said(&folder)?, said(&documents)?, "cargo run --release --example figures");
    for number in 3..=12 {
        assert!(documents.join(format!("figure_{number:02}.svg")).exists(), "figure {number}");
    }
    Ok(())
}

/// Computes published numbers again, and compares what is written of them with docs/published_tables.md.
fn tables_as_in_the_documents() -> Result<(), Box<dyn Error>> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/published_tables.md");
    assert_eq!(
        published_tables::written()?,
        fs::read_to_string(file)?,
        "cargo run --release --example published_tables"
    );
    Ok(())
}
