//! Figures 3 to 12 of "Double contact analysis of multilayered elastic structures involving functionally graded materials",
//! drawn again into docs/figures, with what they show and whether what the paper says holds.
//!
//! `cargo run --release --example figures`
#[path = "figures/page.rs"]
mod page;

use std::error::Error;
use std::path::Path;

use page::{Page, above, falls, opposite, rises};
use recede::Axis;

/// The paper's parameters: h1 = h2 = 1, mu1 = mu3 = 1, mu1 h1/P = 500, R/h1 = 500, nu = 1/4 (plane strain).
const PAPER: &str = "examples/scenes/strip_fgm_half_plane.ron";
const SOFT_NEUTRAL_HARD: [f64; 3] = [-1.0, 0.001, 1.0];

/// Draws the figures into docs/figures.
pub fn main() -> Result<(), Box<dyn Error>> {
    draw(&Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/figures"))
}

/// Draws the figures, and writes what is to be said of them, into a folder.
pub fn draw(folder: &Path) -> Result<(), Box<dyn Error>> {
    let mut page = Page::new(folder, PAPER)?;
    page.stack("stack.svg")?;
    page.map("map.svg")?;

    // Figures 3 and 4: pressures for three graded layers
    let graded = |beta: f64| vec![("punch.radius", 1000.0), ("layer[2].beta", beta)];
    let found = page.pressures([3, 4], "R/h₁ = 1000", ("βh₂", &SOFT_NEUTRAL_HARD), graded)?;
    let ([a, b], [p, q]) = (found.half_lengths(), found.peaks());
    page.says(3, "the longer the contact, the lower its peak", opposite(&a, &p));
    page.says(3, "the peak under the punch is higher than the peak of the receding contact", above(&p, &q));
    page.says(4, "the longer the contact, the lower its peak", opposite(&b, &q));
    page.says(4, "the receding contact is longer than the advancing one", above(&b, &a));

    // Figures 5 and 6: half-lengths over the grading
    let steepness = Axis::linear("βh₂", -3.0, 1.0, 41)?;
    let graded = |radius: f64, beta: f64| vec![("punch.radius", radius), ("layer[2].beta", beta)];
    let found = page.half_lengths([5, 6], "", &steepness, ("R/h₁", &[250.0, 500.0, 1000.0]), graded)?;
    let lowest = found.lowest(1);
    page.says(5, "a falls as the graded layer gets stiffer", found.all(0, falls));
    page.says(5, "a grows with the radius of the punch", found.grows(0));
    page.says(6, "b grows with the radius of the punch", found.grows(1));
    page.says(6, "where b turns it has a point of inflection", found.all(1, |b| falls(b) || rises(b)));
    page.adds(6, &format!("it is a minimum, at βh₂ = {:.2}, {:.2} and {:.2}", lowest[0], lowest[1], lowest[2]));
    page.says(6, "the larger the punch, the larger βh₂ where b is smallest", rises(&lowest));

    // Figures 7 and 8: half-lengths over the stiffness of the half-plane
    let base = Axis::logarithmic("μ₃/μ₁", 0.1, 10.0, 25)?;
    let stiffened = |beta: f64, modulus: f64| vec![("layer[2].beta", beta), ("layer[3].shear_modulus", modulus)];
    let found = page.half_lengths([7, 8], "", &base, ("βh₂", &SOFT_NEUTRAL_HARD), stiffened)?;
    page.says(7, "a falls as the half-plane gets stiffer", found.all(0, falls));
    page.says(7, "a soft half-plane gives a small advancing contact (the paper's conclusion)", found.all(0, rises));
    page.adds(7, "the conclusion contradicts its figure, which is right");
    page.says(8, "b falls as the half-plane gets stiffer", found.all(1, falls));

    // Figures 9 and 10: half-lengths over the thickness of the graded layer, whose moduli at both faces stay the same
    let thickness = Axis::linear("h₂/h₁", 0.05, 2.0, 40)?;
    let thickened = |beta_h: f64, h: f64| vec![("layer[2].thickness", h), ("layer[2].beta", beta_h / h)];
    let found = page.half_lengths([9, 10], "", &thickness, ("βh₂", &SOFT_NEUTRAL_HARD), thickened)?;
    let graded = ("βh₂", &SOFT_NEUTRAL_HARD);
    page.says_of_each(9, "a falls with the thickness of the graded layer", graded, found.which(0, falls));
    page.says_of_each(10, "b grows with the thickness of the graded layer", graded, found.which(1, rises));

    // Figures 11 and 12: pressures for three loads
    let loaded = |load: f64| vec![("force", 1.0 / load)];
    let found = page.pressures([11, 12], "βh₂ = −1", ("μ₁h₁/P", &[250.0, 500.0, 1000.0]), loaded)?;
    let ([a, b], [p, q]) = (found.half_lengths(), found.peaks());
    page.says(11, "the higher the load, the longer the contact and the higher its peak", falls(&a) && falls(&p));
    page.says(11, "the curves do not intersect", found.nested(0));
    page.says(12, "the higher the load, the longer the contact and the higher its peak", falls(&b) && falls(&q));
    page.says(12, "the curves do not intersect", found.nested(1));

    page.finish()
}
