//! A legal scene, ways to spoil it, and what the command says then.
use std::fmt::Write;

use crate::support::recede;

/// A legal scene, to be spoilt.
pub const SCENE: &str = "\
Scene(
    plane: Strain,
    punch: Cylinder(radius: 500.0),
    force: 0.002,
    stack: [
        Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25),
        Bonded,
        Exponential(thickness: 2.0, shear_modulus: 3.0, poisson: 0.3, beta: -1.0),
        Receding,
        HalfPlane(shear_modulus: 4.0, poisson: 0.4),
    ],
)
";

/// What `recede check` says to a text that must be refused.
pub fn refusal(text: impl AsRef<[u8]>) -> String {
    let run = recede(&["check", "-"], text.as_ref());
    assert_eq!(run.status, Some(2), "{}{}", run.stdout, run.stderr);
    assert_eq!(run.stdout, "");
    run.stderr
}

/// The scene above with `from` replaced by `to`.
pub fn with(from: &str, to: &str) -> String {
    assert_eq!(SCENE.matches(from).count(), 1, "{from}");
    SCENE.replace(from, to)
}

/// What is said to each of these replacements.
pub fn refusals(changes: &[(&str, &str)]) -> String {
    let mut all = String::new();
    for (from, to) in changes {
        writeln!(all, "{}", refusal(with(from, to))).unwrap();
    }
    all
}
