//! Warnings where linear elasticity is an approximation only.
use std::f64::consts::PI;

use recede::{HalfPlane, Model, Plane, Punch, Scene, Stack, WarningCode};

/// The codes of the warnings of a punch on a half-plane of E* = 4.
fn codes(punch: &Punch, force: f64) -> Vec<WarningCode> {
    let stack = Stack::builder(Plane::Strain).layer(HalfPlane::new(1.5, 0.25).unwrap()).build().unwrap();
    let solution = Model::new(stack).unwrap().press(punch, force).unwrap();
    solution.warnings().iter().map(|warning| warning.code).collect()
}

#[test]
fn a_contact_is_long_from_three_tenths_of_the_radius() {
    // Hertz: a² = 4PR/(πE*)
    let force = |ratio: f64| PI * ratio * ratio * 2.0;
    let parabola = Punch::parabola(2.0).unwrap();
    // its mean pressure, πaE*/(8R), is large before
    assert_eq!(codes(&parabola, force(0.254)), []);
    assert_eq!(codes(&parabola, force(0.299)), [WarningCode::LargePressure]);
    assert_eq!(codes(&parabola, force(0.301)), [WarningCode::LongContact, WarningCode::LargePressure]);
}

#[test]
fn a_punch_is_steep_from_a_slope_of_three_tenths() {
    let wedge = |slope: f64| Punch::wedge(slope).unwrap();
    // the mean pressure under a wedge is E* tan α/2
    assert_eq!(codes(&wedge(0.199), 0.1), []);
    assert_eq!(codes(&wedge(0.299), 0.1), [WarningCode::LargePressure]);
    assert_eq!(codes(&wedge(0.301), 0.1), [WarningCode::SteepPunch, WarningCode::LargePressure]);
    let corners = Punch::rounded_flat(1.0, 0.01).unwrap();
    assert_eq!(codes(&corners, 0.1), [WarningCode::SteepPunch]);
}

#[test]
fn a_pressure_is_large_from_a_tenth_of_the_modulus() {
    let flat = Punch::flat(0.5).unwrap();
    assert_eq!(codes(&flat, 0.399), []);
    assert_eq!(codes(&flat, 0.401), [WarningCode::LargePressure]);
    // an elastic punch makes the contact softer: E* is the half; a circle is steeper than a parabola by a little
    let elastic = Punch::elastic_cylinder(100.0, 1.5, 0.25).unwrap();
    let force = |mean: f64| mean * mean * 100.0 * 32.0 / PI;
    assert_eq!(codes(&elastic, force(0.095)), []);
    assert!(codes(&elastic, force(0.101)).contains(&WarningCode::LargePressure));
}

#[test]
fn loads_have_pressures_only() {
    let scene = |load: &str, force: f64| {
        let stack = "[HalfPlane(shear_modulus: 1.5, poisson: 0.25)]";
        let text = format!("Scene(geometry: PlaneStrain, load: {load}, force: {force}, stack: {stack})");
        recede::solve(&Scene::from_ron(&text).unwrap()).unwrap()
    };
    assert_eq!(scene("Line", 100.0).warnings(), []);
    assert_eq!(scene("Uniform(half_width: 1)", 0.79).warnings(), []);
    assert_eq!(scene("Uniform(half_width: 1)", 0.81).warnings()[0].code, WarningCode::LargePressure);
}
