//! Punches that are no punches.
//!
//! Goal: every field of every punch refuses what it must, at its line and column, and says what is allowed.
#[path = "support/refusal.rs"]
#[allow(dead_code, reason = "others compare many refusals at once")]
mod refusal;
mod support;

use refusal::{refusal, with};

/// What is said about a punch, which stands at column 12 of line 3.
fn said(punch: &str) -> String {
    refusal(with("Cylinder(radius: 500.0)", punch))
}

#[test]
fn numbers_out_of_range_are_told_with_what_is_allowed() {
    for (punch, column, expected) in [
        (
            "Power(exponent: 0.5, half_width: 1, height: 1)",
            28,
            "`exponent` of the punch: found 0.5, allowed is a number from 1 to 100",
        ),
        ("Power(exponent: 1e3, half_width: 1, height: 1)", 28, "found 1000.0, allowed is a number from 1 to 100"),
        ("Power(exponent: 2, half_width: 0, height: 1)", 43, "`half_width` of the punch: found 0.0"),
        ("Power(exponent: 2, half_width: 1, height: -1)", 54, "`height` of the punch: found -1.0"),
        ("Polynomial(half_width: NaN, heights: [1])", 35, "`half_width` of the punch: found NaN"),
        ("Polynomial(half_width: 1, heights: [1, inf])", 51, "found inf, allowed is a finite number"),
        ("Polynomial(half_width: 1, heights: [])", 48, "there are 0 heights; allowed are 1 to 1000"),
        ("Polynomial(half_width: 1, heights: [0, 0])", 52, "all heights are the same"),
        ("Polynomial(half_width: 1, heights: [-1, -0.5])", 56, "the punch falls on either side of x = 0 without end"),
        ("Wedge(slope: -0.1)", 25, "`slope` of the punch: found -0.1, allowed is a finite number > 0"),
        ("RoundedFlat(half_width: -1, radius: 1)", 36, "`half_width` of the punch: found -1.0"),
        ("RoundedFlat(half_width: 1, radius: 0)", 47, "`radius` of the punch: found 0.0"),
        ("Flat(half_width: 0)", 29, "`half_width` of the punch: found 0.0, allowed is a finite number > 0"),
        ("Table([(0, 0)])", 12, "there are 1 heights; allowed are 2 to 1000"),
        ("Table([(0.1, 0), (1, 1)])", 12, "the table begins at x = 0.1; allowed is 0, the tip"),
        (
            "Table([(0, 0), (2, 1), (2, 3)])",
            12,
            "in the table x = 2.0 follows 2.0; allowed are increasing distances from the tip",
        ),
        ("Table([(0, 1), (2, 1)])", 12, "all heights are the same; allowed are heights that rise from the tip"),
        ("Table([(0, 0), (1e-300, 1e300)])", 12, "the heights rise too steeply for double precision"),
        ("Table([(0, 0), (1, NaN)])", 12, "found NaN, allowed is a finite number"),
        ("ElasticCylinder(radius: 1, shear_modulus: 0, poisson: 0.3)", 54, "`shear_modulus` of the punch: found 0.0"),
        (
            "ElasticCylinder(radius: 1, shear_modulus: 1, poisson: 0.6)",
            66,
            "`poisson` of the punch: found 0.6, allowed is -1 < poisson <= 0.5",
        ),
    ] {
        let said = said(punch);
        assert!(said.contains(expected), "{punch}: {said}");
        let place = format!("stdin:3:{column}: ");
        assert!(said.contains(&place), "{punch}: {place}? {said}");
    }
}

#[test]
fn fields_that_are_missing_or_unknown_are_told() {
    for (punch, expected) in [
        ("Wedge(angle: 1)", "the punch has no field `angle`; allowed is `slope`"),
        ("Flat(width: 1)", "the punch has no field `width`; allowed is `half_width`"),
        ("Wedge()", "`slope` is missing in the punch"),
        ("RoundedFlat(half_width: 1)", "`radius` is missing in the punch"),
        ("Power(exponent: 2)", "is missing in the punch"),
        ("Polynomial(heights: [1])", "`half_width` is missing in the punch"),
        ("Table(1)", "a list in `[` and `]` is expected"),
        ("ElasticCylinder(radius: 1)", "is missing in the punch"),
        ("Spher(radius: 1)", "the punch is `Spher`; allowed are `Cylinder`"),
    ] {
        let said = said(punch);
        assert!(said.contains(expected), "{punch}: {said}");
    }
}

#[test]
fn a_table_that_ends_before_the_contact_does_is_too_small() {
    let text = with("Cylinder(radius: 500.0)", "Table([(0, 0), (0.001, 1e-9)])");
    let run = support::recede(&["solve", "-"], text.as_bytes());
    assert_eq!(run.status, Some(2), "{}", run.stderr);
    assert!(
        run.stderr.contains("cannot carry the force: the contact would reach its edge at x = 0.001"),
        "{}",
        run.stderr
    );
}
