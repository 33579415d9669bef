//! Real cases with their units: solves the scenes of examples/gallery, and writes docs/gallery.md and its pictures.
//!
//! `cargo run --release --example gallery`
#[path = "gallery/case.rs"]
mod case;
#[path = "gallery/page.rs"]
pub mod page;

use std::fs;
use std::path::Path;

use case::Outcome;
pub use case::{Case, Found};
use recede::plot;

/// The scenes in the order of the page.
pub const SCENES: [&str; 18] = [
    "rubber_covered_roller",
    "elastic_roller",
    "two_rollers",
    "sheets_on_felt",
    "seal",
    "eccentric_seal",
    "rail_pad",
    "slab_on_soil",
    "slab_held_down",
    "curled_slab",
    "laminated_glass",
    "cfrp_plies",
    "hard_coating",
    "graded_coating",
    "stressed_coating",
    "afm_on_gel",
    "ball_on_coating",
    "wheel_on_slab",
];

/// Writes the page and its pictures.
pub fn main() -> Outcome<()> {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
    let cases = solved()?;
    draw(&cases, &docs.join("pictures/gallery"))?;
    Ok(fs::write(docs.join("gallery.md"), page::markdown(&cases))?)
}

/// All cases, and what is found for them.
pub fn solved() -> Outcome<Vec<(Case, Vec<Found>)>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/gallery");
    let case = |name: &&str| {
        let case = Case::read(&folder.join(name).with_extension("ron"))?;
        let columns = case.solve().map_err(|error| format!("{name}: {error}"))?;
        Ok((case, columns))
    };
    SCENES.iter().map(case).collect()
}

/// Draws each scene as it is written.
pub fn draw(cases: &[(Case, Vec<Found>)], folder: &Path) -> Outcome<()> {
    fs::create_dir_all(folder)?;
    for (case, columns) in cases {
        let picture = plot::stack(&case.scene, &case.scene.stack()?, &columns[0].solution);
        plot::save(&folder.join(case.stem()).with_extension("svg"), &picture)?;
    }
    Ok(())
}
