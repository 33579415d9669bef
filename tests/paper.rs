//! The paper's tables against the reference; against what is printed, `examples/published_tables.rs` compares them.
//!
//! Goal: nine digits of what an independent solution in multiple precision gives for the same data; one entry is a misprint; the
//! claims of the paper's text about the full model hold.
//!
//! ```text
//!             P                        source: the tables and section 4 of the source paper;
//!            (_)  R                    tests/data/paper_tables.ron, tests/data/contact.json
//!   ████████████████████  h1, μ1
//!   ▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓  h2, μ3 exp(β depth)      Table 1: h2 = 0, Table 2: h1 = 0
//!   ════════╤══╤════════
//!   ░░░░░░░░░░░░░░░░░░░░  μ3
//! ```
use crate::contact;
#[path = "../examples/paper/mod.rs"]
mod tables;

use contact::{known, scene_file};

/// Relative difference to the reference that is allowed.
const TIGHT: f64 = 1e-9;

fn examine(name: &str, entries: usize) {
    let (rows, known) = (tables::table(name).unwrap(), known());
    assert_eq!(rows.len(), entries);
    let mut worst = 0.0f64;
    for tables::Row { entry, computed, .. } in &rows {
        let grading = entry.graded.map_or(String::new(), |beta| format!("_beta{beta}"));
        let scene = format!("{name}{grading}_R{}_load{}", entry.radius, entry.load);
        let known = &known[&scene];
        for (computed, known) in computed.iter().zip(&known.half_length) {
            let off = (computed / known - 1.0).abs();
            assert!(off < TIGHT, "{scene}: {computed}, known {known}");
            worst = worst.max(off);
        }
    }
    println!("{name}: half-lengths within {worst:.1e} of the reference");
}

#[test]
fn table1() {
    examine("table1", 6);
}

#[test]
fn table2() {
    examine("table2", 27);
}

#[test]
fn the_misprint_is_one() {
    let rows = tables::table("table2").unwrap();
    let find = |radius: f64, load: f64| {
        let same =
            |row: &&tables::Row| (row.entry.radius, row.entry.load, row.entry.graded) == (radius, load, Some(1.0));
        rows.iter().find(same).unwrap()
    };
    // the same P R, hence the same contact but for the circle's deviation from a parabola
    let (misprint, twin) = (find(500.0, 1000.0), find(250.0, 500.0));
    let [_, b] = misprint.computed;
    assert!((b / twin.computed[1] - 1.0).abs() < 1e-6);
    assert!((twin.entry.b / b - 1.0).abs() < 0.005);
    assert!((misprint.entry.b / b - 1.0).abs() > 0.1 && misprint.entry.misprinted_b);
}

/// a and b of a scene of the full model.
fn full(name: &str) -> [f64; 2] {
    let solution = recede::solve(&recede::Scene::read(scene_file(name)).unwrap()).unwrap();
    [0, 1].map(|i| solution.contacts()[i].half_length().unwrap())
}

#[test]
fn claims_about_the_full_model() {
    let betas = ["-3", "-2", "-1", "0.001", "1"];
    let contacts = betas.map(|beta| full(&format!("full_beta{beta}_R500")));
    assert!(contacts.is_sorted_by(|[softer, _], [harder, _]| softer > harder), "a falls with beta: {contacts:?}");
    let receding = contacts.map(|[_, b]| b);
    assert!(receding[0] > receding[1] && receding[1] < receding[2], "b has a minimum: {receding:?}");
    assert!(receding[2..].is_sorted(), "and grows beyond: {receding:?}");
    for beta in ["-1", "0.001", "1"] {
        let [small, large] = ["R500", "R1000"].map(|radius| full(&format!("full_beta{beta}_{radius}")));
        assert!(small[0] < large[0] && small[1] < large[1], "larger punches, longer contacts");
        let [soft, stiff] = ["mu3_0.25", "mu3_4"].map(|modulus| full(&format!("full_beta{beta}_{modulus}")));
        assert!(soft[0] > stiff[0] && soft[1] > stiff[1], "stiffer half-planes, shorter contacts");
        let [thin, middle, thick] = ["h2_0.1", "h2_0.5", "h2_2"].map(|h2| full(&format!("full_beta{beta}_{h2}")));
        assert!(thin[1] < middle[1] && middle[1] < thick[1], "thicker layers, longer receding contacts");
        assert!(thin[0] > middle[0] && middle[0] > thick[0], "and shorter advancing ones");
    }
}
