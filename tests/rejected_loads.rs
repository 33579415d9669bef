//! Loads that are none.
//!
//! Goal: every field of every load refuses what it must, at its line and column, and says what is allowed.
#[path = "support/refusal.rs"]
#[allow(dead_code, reason = "others compare many refusals at once")]
mod refusal;
mod support;

use refusal::{refusal, with};

/// What is said about a load, which stands at column 11 of line 3.
fn said(load: &str) -> String {
    refusal(with("punch: Cylinder(radius: 500.0)", &format!("load: {load}")))
}

#[test]
fn numbers_out_of_range_are_told_with_what_is_allowed() {
    for (load, column, expected) in [
        ("Uniform(half_width: 0)", 31, "`half_width` of the load: found 0.0, allowed is a finite number > 0"),
        ("Parabolic(half_width: -1)", 33, "`half_width` of the load: found -1.0"),
        ("Elliptic(half_width: inf)", 32, "`half_width` of the load: found inf"),
        ("Several([])", 11, "the load: there are 0 loads; allowed are 1 to 1000"),
        (
            "Several([(at: -1, share: 1, load: Line)])",
            25,
            "`at` of the load: found -1.0, allowed is a finite number >= 0",
        ),
        (
            "Several([(at: 1, share: 0, load: Line)])",
            35,
            "`share` of the load: found 0.0, allowed is a finite number > 0",
        ),
        ("Several([(at: 1, share: 1, load: Uniform(half_width: 0))])", 64, "`load.half_width` of the load: found 0.0"),
        (
            "Several([(at: 1, share: 1, load: Several([(at: 1, share: 1, load: Line)]))])",
            11,
            "`Several` stands within `Several`; allowed are `Line`, `Uniform`, `Parabolic`, `Elliptic`",
        ),
    ] {
        let said = said(load);
        assert!(said.contains(expected), "{load}: {said}");
        let place = format!("stdin:3:{column}: ");
        assert!(said.contains(&place), "{load}: {place}? {said}");
    }
}

#[test]
fn fields_that_are_missing_or_unknown_are_told() {
    for (load, expected) in [
        ("Uniform(width: 1)", "the load has no field `width`; allowed is `half_width`"),
        ("Several(Line)", "a list in `[` and `]` is expected"),
        ("Several([Line])", "the load begins with `Part(`, found `Line`"),
        ("Several([(share: 1, load: Line)])", "`at` is missing"),
        ("Several([(at: 1, load: Line)])", "`share` is missing"),
        ("Several([(at: 1, share: 1)])", "`load` is missing"),
        ("Several([(at: 1, share: 1, load: Line, force: 1)])", "no field `force`; allowed are `at`, `share`, `load`"),
        ("Several([(at: 1, share: 1, load: Point)])", "is `Point`; allowed are `Line`"),
    ] {
        let said = said(load);
        assert!(said.contains(expected), "{load}: {said}");
    }
}
