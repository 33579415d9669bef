//! The gallery, docs/gallery.md: real cases with their units.
//!
//! Goal: every scene of examples/gallery is solved to the tolerance, has a section and a picture, and says what is learnt and what is
//! idealised; the page has the numbers that are computed, and what its texts say of them holds.
use std::collections::BTreeSet;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

#[path = "../examples/gallery.rs"]
#[allow(dead_code, reason = "its main function writes into docs/")]
mod program;

use program::{Case, Found};

static SOLVED: LazyLock<Vec<(Case, Vec<Found>)>> = LazyLock::new(|| program::solved().unwrap());

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_owned()
}

/// The names of the files in a folder that end so.
fn names(folder: &str, ending: &str) -> BTreeSet<String> {
    let files = fs::read_dir(root().join(folder)).unwrap().map(|entry| entry.unwrap().path());
    let files = files.filter(|file| file.extension().is_some_and(|found| found == ending));
    files.map(|file| file.file_stem().unwrap().to_str().unwrap().to_owned()).collect()
}

/// Makes the page again, and compares it with the one in the documents.
pub fn page_as_in_the_documents() -> Result<(), Box<dyn Error>> {
    let file = root().join("docs/gallery.md");
    assert_eq!(program::page::markdown(&SOLVED), fs::read_to_string(file)?, "cargo run --release --example gallery");
    Ok(())
}

#[test]
fn every_scene_has_a_section_and_a_picture() {
    let listed: BTreeSet<String> = program::SCENES.map(str::to_owned).into();
    assert_eq!(listed.len(), 18);
    assert_eq!(listed, names("examples/gallery", "ron"));
    assert_eq!(listed, names("docs/pictures/gallery", "svg"));
    let page = fs::read_to_string(root().join("docs/gallery.md")).unwrap();
    let sections: Vec<&str> = page.lines().filter_map(|line| line.strip_prefix("## ")).collect();
    let titles = SOLVED.iter().map(|(case, _)| case.scene.title()).chain(["How this page is made"]);
    assert_eq!(sections, titles.collect::<Vec<_>>());
}

#[test]
fn every_scene_is_solved_and_explained() {
    for (case, columns) in SOLVED.iter() {
        for kind in ["Learnt: ", "Idealised: ", "Values: "] {
            assert!(case.paragraphs.iter().any(|paragraph| paragraph.starts_with(kind)), "{}: {kind}", case.stem());
        }
        assert!(columns.len() > 1, "{}: nothing to compare with", case.stem());
        for column in columns {
            // rubber may be strained more than the theory allows, but the numbers are those of the theory
            for warning in column.solution.warnings() {
                assert!(warning.code.is_about_theory(), "{}, {}: {warning}", case.stem(), column.label);
            }
        }
    }
}

/// A number of a column, by how its row begins.
fn number(scene: &str, column: usize, row: &str) -> f64 {
    let (_, columns) = SOLVED.iter().find(|(case, _)| case.stem() == scene).unwrap();
    let found = columns[column].numbers.iter().find(|(name, _)| name.starts_with(row));
    found.unwrap_or_else(|| panic!("{scene}: no {row}")).1.number
}

/// Where along x it is.
fn place(scene: &str, column: usize, row: &str) -> f64 {
    let (_, columns) = SOLVED.iter().find(|(case, _)| case.stem() == scene).unwrap();
    columns[column].numbers.iter().find(|(name, _)| name.starts_with(row)).unwrap().1.at
}

const WIDTH: &str = "punch: width";
const PRESSURE: &str = "punch: largest pressure";
const SHEAR: &str = "largest shear stress";

#[test]
fn a_thin_cover_makes_a_narrow_nip() {
    let [drawn, thin, thick] =
        [0, 1, 2].map(|column| [WIDTH, PRESSURE].map(|row| number("rubber_covered_roller", column, row)));
    assert!(thin[0] < drawn[0] && drawn[0] < thick[0], "{thin:?} {drawn:?} {thick:?}");
    assert!(thin[1] > drawn[1] && drawn[1] > thick[1], "{thin:?} {drawn:?} {thick:?}");
    // at the bond to the core, beside the middle
    assert!((number("rubber_covered_roller", 0, "its depth") / 17.5 - 1.0).abs() < 1e-9);
    assert!(place("rubber_covered_roller", 0, SHEAR) > 0.25 * drawn[0]);
}

#[test]
fn a_plate_under_a_soft_wheel_spreads_the_pressure() {
    let of = |row: &str| [1, 0, 2].map(|column| number("elastic_roller", column, row));
    let [thin, drawn, thick] = of(WIDTH);
    assert!((thin / drawn - 1.0).abs() < 0.01 && (thick / drawn - 1.0).abs() < 0.01);
    assert!(of("1|2: largest pressure").is_sorted_by(|thinner, thicker| thinner > thicker));
    let [thin, drawn, thick] = of(SHEAR);
    assert!(drawn > thin && drawn > thick);
}

#[test]
fn sheets_smooth_the_two_peaks() {
    let rows = [PRESSURE, "1|2: largest pressure", "2|3: largest pressure", "3|4: largest pressure"];
    let peaks = rows.map(|row| number("sheets_on_felt", 0, row));
    assert!(peaks.is_sorted_by(|above, below| above > below), "{peaks:?}");
    let places = rows.map(|row| place("sheets_on_felt", 0, row));
    assert!(places[..3].iter().all(|x| *x > 0.3 * number("sheets_on_felt", 0, WIDTH)) && places[3] == 0.0);
    let widths = ["1|2: width", "2|3: width", "3|4: width"].map(|row| number("sheets_on_felt", 0, row));
    assert!(widths.iter().all(|width| (width / widths[0] - 1.0).abs() < 0.03), "{widths:?}");
    assert!(widths[2] > 2.0 * number("sheets_on_felt", 0, WIDTH));
    assert!(number("sheets_on_felt", 1, "1|4: width") < widths[2]);
    assert!(number("sheets_on_felt", 1, "1|4: largest pressure") > peaks[3]);
}

#[test]
fn weight_holds_a_slab_down() {
    let critical = |column| number("slab_held_down", column, "force under which 1|2 opens");
    let least = number("slab_held_down", 0, "1|2: smallest pressure");
    assert!((0.89..0.91).contains(&(least / 4.8)) && (4.4..4.6).contains(&place("slab_held_down", 0, "1|2: smallest")));
    assert!((9.5..10.5).contains(&(critical(0) / 100.0)) && (0.3..0.36).contains(&(critical(2) / critical(0))));
    assert!((4.5..5.0).contains(&number("slab_held_down", 1, "1|2: width")));
    let gap = ["1|2: gap on the right, from", "1|2: its length", "1|2: its height"];
    let [from, length, height] = gap.map(|row| number("slab_held_down", 3, row));
    assert!((3.85..3.95).contains(&from) && (1.6..1.7).contains(&length) && (1.4e-5..1.5e-5).contains(&height));
    assert!(place("slab_held_down", 2, "1|2: smallest") < place("slab_held_down", 0, "1|2: smallest"));
}

#[test]
fn a_curled_slab_touches_less_far() {
    let of = |row: &str| [1, 0, 2].map(|column| number("curled_slab", column, row));
    assert!(of("2|3: width").is_sorted_by(|flatter, more| flatter > more));
    assert!(of("2|3: largest pressure").is_sorted_by(|flatter, more| flatter < more));
    assert!(number("curled_slab", 3, "2|3: width") > 1.1 * number("curled_slab", 0, "2|3: width"));
    let [flat, curled, more] = of("`sigma_xx` at x = 0, bottom of layer 2");
    assert!(flat > more && more > curled, "{flat} {curled} {more}");
}

#[test]
fn residual_stresses_are_added_to_those_of_the_contact() {
    let of = |row: &str| [1, 0, 2].map(|column| number("stressed_coating", column, row));
    for row in [WIDTH, PRESSURE] {
        assert!(of(row).iter().all(|number| *number == of(row)[0]));
    }
    let [free, stressed, _] = of("`sigma_xx` at x = 0.144, top of layer 1");
    assert!((80.0..83.0).contains(&free) && (384.0..386.0).contains(&(free - stressed)));
    assert!(of(SHEAR).is_sorted_by(|less, more| less < more));
}

#[test]
fn a_seal_leaks_below_first() {
    let ratio = number("seal", 0, "1|2: largest pressure") / number("seal", 0, PRESSURE);
    assert!((0.45..0.55).contains(&ratio), "{ratio}");
    assert!(place("seal", 0, PRESSURE) > 0.5 && place("seal", 0, "1|2: largest pressure") == 0.0);
}

#[test]
fn rollers_apart_press_the_belt_on_the_bed_one_by_one() {
    let [drawn, near, together] = [0, 1, 2].map(|column| {
        let left = |k: usize| number("two_rollers", column, &format!("1|2: left end of interval {k}"));
        let width = |k: usize| number("two_rollers", column, &format!("1|2: width of interval {k}"));
        if column < 2 { [left(1), left(1) + width(1), left(2)] } else { [left(1), left(1) + width(1), f64::INFINITY] }
    });
    assert!(drawn[1] + 15.0 < drawn[2] && near[1] < near[2] && together[1] > 8.0, "{drawn:?} {near:?} {together:?}");
    for interval in ["punch: width of interval 1", "punch: width of interval 2"] {
        let [drawn, near, together] = [0, 1, 2].map(|column| number("two_rollers", column, interval));
        assert!((near / drawn - 1.0).abs() < 0.01 && (together / drawn - 1.0).abs() < 0.01, "{interval}");
    }
}

#[test]
fn a_ring_pressed_beside_its_middle_lifts_off() {
    let width = [1, 0, 2].map(|column| number("eccentric_seal", column, "punch: width of interval 1"));
    assert!(width[0] == 3.0 && width[1] == 3.0 && width[2] < 1.7, "{width:?}");
    let pressure = [1, 0, 2].map(|column| number("eccentric_seal", column, "1|2: largest pressure"));
    assert!(pressure.is_sorted() && pressure[2] < 1.35 * pressure[0], "{pressure:?}");
    let [drawn, lifted] = [0, 2].map(|column| number("eccentric_seal", column, "tilt of punch 1"));
    assert!(lifted < 2.0 * drawn && drawn < 0.0, "{drawn} {lifted}");
}

#[test]
fn a_pad_that_sticks_is_stiff() {
    let [smooth, smooth_incompressible, _, stuck_incompressible] =
        [0, 1, 2, 3].map(|column| number("rail_pad", column, "stiffness"));
    assert!(smooth_incompressible / smooth < 1.1);
    assert!((8.5..9.5).contains(&(stuck_incompressible / smooth_incompressible)));
    // N/mm² times 150 mm, in kN/mm
    assert!((79.5..80.5).contains(&(0.15 * smooth)), "{smooth}");
    let uniform = 300.0 / number("rail_pad", 0, WIDTH);
    assert!((1.15..1.25).contains(&(number("rail_pad", 0, PRESSURE) / uniform)));
}

#[test]
fn a_thick_slab_is_stretched_less() {
    let tension = |x: &str| {
        let row = format!("`sigma_xx` at x = {x}, bottom of layer 1");
        [1, 0, 2].map(|column| number("slab_on_soil", column, &row))
    };
    let ([thin, drawn, thick], [thin_between, between, _]) = (tension("0.9"), tension("0"));
    assert!(thin > drawn && (0.63..0.70).contains(&(thick / thin)), "{thin} {drawn} {thick}");
    assert!(between < 0.5 * drawn && thin_between < 0.0);
    // 50 kN/m on 0.3 m
    assert!(number("slab_on_soil", 0, "1|2: largest pressure") < 0.2 * 50.0 / 0.3);
    assert!((1.4..1.6).contains(&(0.5 * number("slab_on_soil", 0, "1|2: width") - 0.9)));
}

#[test]
fn a_stiff_interlayer_makes_one_pane_of_two() {
    let tension = |layer: usize| {
        let row = format!("`sigma_xx` at x = 0, bottom of layer {layer}");
        [1, 0, 2].map(|column| number("laminated_glass", column, &row))
    };
    let (upper, lower) = (tension(1), tension(3));
    assert!(upper[0] > lower[0], "warm: {upper:?} {lower:?}");
    assert!((0.14..0.18).contains(&(upper[2] / upper[0])), "{upper:?}");
    assert!([1, 0, 2].map(|column| number("laminated_glass", column, "3|4: width")).is_sorted());
}

#[test]
fn a_receding_contact_hardly_depends_on_the_force() {
    let [drawn, quarter, four] = [0, 1, 2].map(|column| number("cfrp_plies", column, WIDTH));
    assert!((drawn / quarter - 2.0).abs() < 0.05 && (four / drawn - 2.0).abs() < 0.05);
    let [drawn, quarter, four] = [0, 1, 2].map(|column| number("cfrp_plies", column, "3|4: width"));
    assert!((quarter / drawn - 1.0).abs() < 0.03 && (four / drawn - 1.0).abs() < 0.03);
    // half the difference of the principal stresses where the fibres are compressed, at the face
    let surface = -number("cfrp_plies", 0, "`sigma_xx` at x = 0, top of layer 1") - number("cfrp_plies", 0, PRESSURE);
    assert!((0.5 * surface / number("cfrp_plies", 0, SHEAR) - 1.0).abs() < 1e-3);
}

#[test]
fn a_coating_that_has_come_off_is_in_tension() {
    let of = |row: &str| [0, 1].map(|column| number("hard_coating", column, row));
    let [loose, bonded] = of("`sigma_xx`");
    assert!(loose > 0.0 && bonded < 0.0);
    let [loose, bonded] = of(WIDTH);
    assert!((1.05..1.15).contains(&(loose / bonded)), "{loose} {bonded}");
    let [loose, bonded] = of(PRESSURE);
    assert!(loose < bonded);
    // of the bonded one in the steel below
    assert!(number("hard_coating", 1, "its depth") > 0.004);
    assert!(number("hard_coating", 1, SHEAR) >= number("hard_coating", 2, SHEAR));
}

#[test]
fn a_graded_coating_has_no_jump() {
    let [drawn, plain, half] = [0, 1, 2].map(|column| number("graded_coating", column, PRESSURE));
    assert!(drawn > half && half - plain > 0.5 * (drawn - plain), "{drawn} {plain} {half}");
    assert!(
        drawn / plain < 1.1 && number("graded_coating", 0, SHEAR) / number("graded_coating", 1, SHEAR) > drawn / plain
    );
    let stress =
        |face: &str| [0, 2].map(|column| number("graded_coating", column, &format!("`sigma_xx` at x = 0, {face}")));
    let ([drawn_above, half_above], [drawn_below, half_below]) =
        (stress("bottom of layer 1"), stress("top of layer 2"));
    assert!((drawn_above - drawn_below).abs() < (half_above - half_below).abs());
}
