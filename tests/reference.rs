//! Half-lengths, peak pressures and flexibilities against an independent solution in multiple precision.
//!
//! Goal: every scene of tests/data from a cold start, to nine digits in half-lengths and seven in peak pressures, or
//! what the reference itself is good for; every flexibility of a laminate to eleven.
//!
//! ```text
//!             P
//!            (_)  R           source: tests/data/contact.json and flexibility.json; `*_err` there is the difference
//!   ████████████████████      between the two finest discretisations
//!   ▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓
//!   ════════╤══╤════════      ‾ lifted off outside ±b
//!   ░░░░░░░░░░░░░░░░░░░░
//! ```
use std::collections::BTreeMap;

use recede::{
    BlockSystem, Exponential, FreeChain, HalfPlane, Homogeneous, Item, Model, Plane, Punch, Scene, Solution, Stack,
    Wave,
};

use crate::contact::{known, scene_file};

/// Relative error allowed in a half-length, or ten times what the reference is good for.
const HALF_LENGTH: f64 = 1e-9;
/// Relative error allowed in a peak pressure, or ten times what the reference is good for.
const PEAK_PRESSURE: f64 = 1e-7;
/// Error allowed in the flexibilities under a load on one face, relative to |C| or, for the coupling, at least to
/// 1e-10 √(C_tt |C_bb|).
const SINGLE_LOADS: f64 = 1e-11;
/// Error allowed under equal loads on both faces, for λH ≥ 1e-4.
const EQUAL_LOADS: f64 = 1e-9;

fn solve(name: &str) -> Solution {
    let scene = Scene::read(scene_file(name)).unwrap();
    recede::solve(&scene).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn contacts() {
    let known = known();
    assert_eq!(known.len(), std::fs::read_dir(scene_file("x").parent().unwrap()).unwrap().count());
    let mut worst = BTreeMap::<&str, [f64; 2]>::new();
    let mut wrong = Vec::new();
    for (name, known) in &known {
        let solution = solve(name);
        assert_eq!(solution.contacts().len(), known.half_length.len(), "{name}");
        let group = ["table1", "table2", "full"].into_iter().find(|group| name.starts_with(group)).unwrap_or("others");
        let worst = worst.entry(group).or_default();
        for (i, contact) in solution.contacts().iter().enumerate() {
            let half_length = (contact.half_length().unwrap() / known.half_length[i] - 1.0).abs();
            let central_pressure = (contact.central_pressure / known.peak_pressure[i] - 1.0).abs();
            *worst = [worst[0].max(half_length), worst[1].max(central_pressure)];
            let allowed = (10.0 * known.half_length_err[i]).max(HALF_LENGTH);
            if half_length > allowed {
                wrong.push(format!("{name}, contact {i}: half-length off by {half_length:.1e} > {allowed:.1e}"));
            }
            let allowed = (10.0 * known.peak_pressure_err[i]).max(PEAK_PRESSURE);
            if central_pressure > allowed {
                wrong.push(format!("{name}, contact {i}: peak pressure off by {central_pressure:.1e} > {allowed:.1e}"));
            }
        }
    }
    for (group, [half_length, central_pressure]) in worst {
        println!("{group:7} largest relative error: half-lengths {half_length:.1e}, pressures {central_pressure:.1e}");
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

/// Half-length of the receding contact of `full_beta.._h2_0.1` if its graded layer is cut into homogeneous slices, each
/// of the modulus at its middle.
fn sliced(beta: f64, slices: usize) -> f64 {
    let slice = 0.1 / slices as f64;
    let mut stack = Stack::builder(Plane::Strain).layer(Homogeneous::new(1.0, 1.0, 0.25).unwrap());
    for i in 0..slices {
        let modulus = f64::exp(beta * slice * (i as f64 + 0.5));
        stack = stack.bonded().layer(Homogeneous::new(slice, modulus, 0.25).unwrap());
    }
    let stack = stack.receding().layer(HalfPlane::new(1.0, 0.25).unwrap()).build().unwrap();
    let solution = Model::new(stack).unwrap().press(Punch::cylinder(500.0).unwrap(), 0.002).unwrap();
    solution.contacts()[1].half_length().unwrap()
}

#[test]
fn a_thin_graded_layer_is_the_limit_of_homogeneous_slices() {
    let known = known();
    for (name, beta) in [("full_beta-1_h2_0.1", -10.0), ("full_beta0.001_h2_0.1", 0.01), ("full_beta1_h2_0.1", 10.0)] {
        let graded = solve(name).contacts()[1].half_length().unwrap();
        // the error of n slices is (A + B ln n)/n² + O(1/n³): extrapolating twice with the same factor removes A and B
        let extrapolate = |coarse_to_fine: &[f64], factor: f64| -> Vec<f64> {
            coarse_to_fine.windows(2).map(|b| (factor * b[1] - b[0]) / (factor - 1.0)).collect()
        };
        let sliced = [25, 50, 100, 200].map(|slices| sliced(beta, slices));
        let limit = extrapolate(&extrapolate(&extrapolate(&sliced, 4.0), 4.0), 8.0)[0];
        let [graded_off, known_off] = [graded, known[name].half_length[1]].map(|b| (b / limit - 1.0).abs());
        println!("{name}: from the limit of slices off by {graded_off:.1e}, the reference by {known_off:.1e}");
        assert!(graded_off < HALF_LENGTH, "{graded} is not {limit}");
        assert!(known_off < HALF_LENGTH, "the reference of {name} is not {limit}");
    }
}

#[derive(serde::Deserialize)]
struct Laminate {
    layers_top_down: Vec<Parameters>,
    rows: Vec<Vec<serde_json::Value>>,
}

#[derive(Clone, Copy, serde::Deserialize)]
struct Parameters {
    thickness: f64,
    shear_modulus: f64,
    poisson: f64,
    beta: f64,
}

impl Parameters {
    fn item(self) -> Item {
        let Self { thickness, shear_modulus, poisson, beta } = self;
        if beta == 0.0 {
            Item::layer(Homogeneous::new(thickness, shear_modulus, poisson).unwrap())
        } else {
            Item::layer(Exponential::new(thickness, shear_modulus, poisson, beta).unwrap())
        }
    }
}

#[test]
fn flexibilities_of_laminates() {
    let text = std::fs::read_to_string(scene_file("x").with_file_name("../flexibility.json")).unwrap();
    let laminates: BTreeMap<String, Laminate> = serde_json::from_str(&text).unwrap();
    let (mut worst, mut wrong) = ([0.0f64; 5], Vec::new());
    for (name, laminate) in &laminates {
        let builder = Stack::builder(Plane::Strain).item(laminate.layers_top_down[0].item());
        let layers = laminate.layers_top_down[1..].iter();
        let builder = layers.fold(builder, |builder, layer| builder.bonded().item(layer.item()));
        let stack = builder.receding().rigid().build().unwrap();
        let chain = FreeChain::all(&BlockSystem::new(&stack)).remove(0);
        let thickness = stack.total_thickness();
        for row in &laminate.rows {
            // most numbers are strings, so that no reader rounds them; where the coupling of the faces vanishes, some are
            // missing
            let number = |k: usize| row[k].as_f64().or_else(|| row[k].as_str()?.parse().ok());
            let wavenumber = number(0).unwrap();
            let found = chain.flexibility(&Wave { wavenumber, modulus: 1.0, plane: Plane::Strain }).unwrap();
            let found = [found.top, found.coupling, found.bottom, found.equal_top, found.equal_bottom];
            let floor = 1e-10 * (number(1).unwrap() * number(3).unwrap().abs()).sqrt();
            for k in 0..5 {
                let Some(expected) = number(k + 1) else { continue };
                if k >= 3 && wavenumber * thickness < 1e-4 {
                    continue;
                }
                let scale = if k == 1 { expected.abs().max(floor) } else { expected.abs() };
                let error = (found[k] - expected).abs() / scale;
                worst[k] = worst[k].max(error);
                let allowed = if k < 3 { SINGLE_LOADS } else { EQUAL_LOADS };
                if error.is_nan() || error > allowed {
                    wrong.push(format!("{name}, λ = {wavenumber:e}, number {k}: off by {error:.1e} > {allowed:.0e}"));
                }
            }
        }
    }
    println!(
        "largest relative errors of tt, tb, bb, equal t, equal b: {}",
        worst.map(|error| format!("{error:.1e}")).join(", ")
    );
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}
