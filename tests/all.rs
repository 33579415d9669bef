//! All tests that can share a program, so that the library is linked once: one file is one promise.
//!
//! `cargo test --test all NAME::` runs those of the file `NAME.rs`.
#![allow(clippy::duplicate_mod, reason = "examples and tests bring along what they share")]

mod closed_forms;
#[path = "support/contact.rs"]
mod contact;
#[path = "support/scenario.rs"]
mod scenario;
mod support;

mod anywhere;
mod approach;
mod below_loose_layers;
mod boundary_layers;
mod cli;
mod collocation;
mod convergence;
mod corners;
mod covers;
mod deformed;
mod dents;
mod determinism;
mod discs;
mod docs;
mod eigenstrains;
mod estimates;
mod exact;
mod examples;
mod extremes;
mod far_fields;
mod field;
mod flat;
mod gallery;
mod gaps;
mod half_length;
mod half_planes;
mod hard_scenes;
mod help;
mod hostile;
mod input;
mod install;
mod interfaces;
mod intervals;
mod invariance;
mod json;
mod kinds;
mod laws;
mod layers;
mod ledger;
mod list;
mod loads;
mod many_loads;
mod maps;
mod merge;
mod moved_loads;
mod near_and_far;
mod neighbours;
#[cfg(unix)]
mod outputs;
mod pages;
mod paper;
mod parquet;
mod parts;
mod placed_punches;
mod plies;
mod plot;
mod prescribed;
mod profile;
mod punches;
mod random_openings;
mod reference;
mod rejected;
mod rings;
mod rival;
mod round;
mod round_reports;
mod settings;
mod singular;
mod singular_extremes;
mod skips;
mod strains;
mod sweep;
mod system;
mod thin_layers;
mod translation;
mod validity;
mod visible;
mod wedges;
mod weight_laws;
mod weights;
mod workers;

#[test]
fn every_file_is_run() {
    let (together, manifest) = (include_str!("all.rs"), include_str!("../Cargo.toml"));
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    for file in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        let name = file.file_stem().unwrap().to_string_lossy().into_owned();
        let shared = together.contains(&format!("\nmod {name};\n"));
        let alone = manifest.contains(&format!("\n[[test]]\nname = \"{name}\"\n"));
        assert!(
            shared || alone || file.extension().is_none_or(|ending| ending != "rs"),
            "{name} is neither in tests/all.rs nor a test in Cargo.toml"
        );
    }
}
