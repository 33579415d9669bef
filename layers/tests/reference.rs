//! Flexibilities against multiple-precision values.
//!
//! Goal: closed forms and the general body keep their digits from λh = 1e-8 to 1e8.
//!
//! ```text
//!      p cos λx                 source: tests/data/flexibility.json, an independent evaluation with 60 digits
//!   ↓↓↓↓↓↓↓↓↓↓↓↓  S, T = 0      of the state equations; λC for loads on the top, on the bottom, on both faces
//!   ████████████  h = 1
//!   ↑↑↑↑↑↑↑↑↑↑↑↑  S, T = 0
//! ```
use std::collections::BTreeMap;

use recede_layers::{Exponential, Flexibility, Homogeneous, Isotropic, Layer, Material, Notation, Plane, Wave, graded};

/// Above this, relative to |C| or, for the coupling, to 1e-10 √(C_tt |C_bb|), a flexibility counts as wrong.
const SINGLE_LOADS: f64 = 1e-12;
/// The same where a jump of the material has to be found first.
const FOUND_JUMPS: f64 = 1e-11;
/// The same for equal loads and λh ≥ 1e-4, below which fewer than eight digits of a difference would be left.
const EQUAL_LOADS: f64 = 1e-9;
/// The same where equal loads are solved for like any others, relative to the larger response ...
const SOLVED_EQUAL_LOADS: f64 = 1e-8;
/// ... and to the (λh)² of the response to a single load that cancels.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

#[derive(serde::Deserialize)]
struct Case {
    layers_top_down: Vec<Parameters>,
    rows: Vec<Vec<serde_json::Value>>,
}

#[derive(Clone, Copy, Debug, serde::Deserialize)]
struct Parameters {
    thickness: f64,
    shear_modulus: f64,
    poisson: f64,
    beta: f64,
}

/// λ and [λC_tt, λC_tb, λC_bb, λ(C_tt + C_tb), λ(C_bt + C_bb)].
type Row = (f64, [f64; 5]);

impl Case {
    fn rows(&self) -> impl Iterator<Item = Row> {
        // most numbers are strings, so that no reader rounds them; where faces do not feel each other, some are missing
        let number =
            |value: &serde_json::Value| value.as_f64().or_else(|| value.as_str()?.parse().ok()).unwrap_or(f64::NAN);
        self.rows.iter().map(move |row| (number(&row[0]), [1, 2, 3, 4, 5].map(|k| number(&row[k]))))
    }
}

fn cases() -> BTreeMap<String, Case> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/data/flexibility.json");
    let text = std::fs::read_to_string(path).expect("reference data");
    let all: BTreeMap<String, serde_json::Value> = serde_json::from_str(&text).expect("reference data");
    all.into_iter().filter_map(|(name, case)| Some((name, serde_json::from_value(case).ok()?))).collect()
}

impl Parameters {
    fn layer(&self) -> Box<dyn Layer> {
        let Self { thickness, shear_modulus, poisson, beta } = *self;
        if beta == 0.0 {
            Box::new(Homogeneous::new(thickness, shear_modulus, poisson).expect("legal"))
        } else {
            Box::new(Exponential::new(thickness, shear_modulus, poisson, beta).expect("legal"))
        }
    }
}

fn compare(name: &str, found: &Flexibility, (wavenumber, expected): Row, single_loads: f64, solved: bool) {
    let found = [found.top, found.coupling, found.bottom, found.equal_top, found.equal_bottom];
    let larger = |i: usize, j: usize| expected[i].abs().max(expected[j].abs());
    // all layers are about 1 thick
    let cancelling = wavenumber.powi(2).min(1.0) * larger(0, 2);
    let floor = 1e-10 * (expected[0] * expected[2].abs()).sqrt();
    for k in 0..5 {
        let tolerance = match k {
            1 => single_loads * expected[k].abs().max(floor),
            0 | 2 => single_loads * expected[k].abs(),
            _ if wavenumber < 1e-4 || expected[k].is_nan() => continue,
            _ if solved => SOLVED_EQUAL_LOADS * larger(3, 4) + ROUNDING * cancelling,
            _ => EQUAL_LOADS * expected[k].abs(),
        };
        let error = (found[k] - expected[k]).abs();
        assert!(error <= tolerance, "{name}, λ = {wavenumber:e}, number {k}: {:e} ≠ {:e}", found[k], expected[k]);
    }
}

fn wave(wavenumber: f64) -> Wave {
    Wave { wavenumber, modulus: 1.0, plane: Plane::Strain }
}

#[test]
fn closed_forms() {
    let mut compared = 0;
    for (name, case) in cases() {
        let [parameters] = case.layers_top_down[..] else { continue };
        let layer = parameters.layer();
        for row in case.rows() {
            let found = layer.flexibility(&wave(row.0)).expect("finite");
            compare(&name, &found, row, SINGLE_LOADS, false);
            compared += 1;
        }
    }
    assert!(compared > 250, "{compared} rows of reference data");
}

#[test]
fn face_states() {
    for (name, case) in cases() {
        let [parameters] = case.layers_top_down[..] else { continue };
        let layer = parameters.layer();
        for row in case.rows() {
            let found = Flexibility::of_face_states(&layer.face_states(&wave(row.0))).expect("finite");
            compare(&name, &found, row, SINGLE_LOADS, true);
        }
    }
}

#[test]
fn general_body() {
    for (name, case) in cases() {
        let [parameters] = case.layers_top_down[..] else { continue };
        let layer = parameters.layer();
        for row in case.rows() {
            let states = graded::face_states(&*layer, &wave(row.0));
            let found = Flexibility::of_face_states(&states).expect("finite");
            compare(&name, &found, row, SINGLE_LOADS, true);
        }
    }
}

/// Several layers as one, whose material jumps.
#[derive(Debug)]
struct AsOne(Vec<Parameters>);

impl Layer for AsOne {
    fn thickness(&self) -> Option<f64> {
        Some(self.0.iter().map(|layer| layer.thickness).sum())
    }

    fn material(&self, mut depth: f64, plane: Plane) -> Material {
        let mut layers = self.0.iter().peekable();
        while let Some(layer) = layers.next() {
            if depth <= layer.thickness || layers.peek().is_none() {
                let shear_modulus = layer.shear_modulus * (layer.beta * depth).exp();
                return Isotropic { shear_modulus, poisson: layer.poisson }.material(plane);
            }
            depth -= layer.thickness;
        }
        unreachable!("the last layer takes what is left")
    }

    fn notation(&self) -> Notation {
        Notation { kind: "AsOne", parameters: String::new() }
    }
}

#[test]
fn a_laminate_is_a_layer_whose_material_jumps() {
    let mut compared = 0;
    for (name, case) in cases() {
        if case.layers_top_down.len() < 2 {
            continue;
        }
        let layer: &dyn Layer = &AsOne(case.layers_top_down.clone());
        for row in case.rows() {
            let found = layer.flexibility(&wave(row.0)).expect("finite");
            compare(&name, &found, row, FOUND_JUMPS, true);
            compared += 1;
        }
    }
    assert!(compared > 100, "{compared} rows of reference data");
}
