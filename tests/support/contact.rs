//! Contacts from an independent multiple-precision solution, and the scenes to which they belong.
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// What is known of one scene: its contacts from the top down.
#[derive(Debug, serde::Deserialize)]
#[allow(dead_code, reason = "who compares half-lengths only need not read the rest")]
pub struct Known {
    /// Half-lengths.
    pub half_length: Vec<f64>,
    /// Bounds of their relative errors.
    pub half_length_err: Vec<f64>,
    /// Pressures at x = 0.
    pub peak_pressure: Vec<f64>,
    /// Bounds of their relative errors.
    pub peak_pressure_err: Vec<f64>,
}

/// All scenes by name.
pub fn known() -> BTreeMap<String, Known> {
    let text = std::fs::read_to_string(data().join("contact.json")).expect("reference data");
    serde_json::from_str(&text).expect("reference data")
}

/// The file of a scene.
pub fn scene_file(name: &str) -> PathBuf {
    data().join("scenes").join(format!("{name}.ron"))
}

fn data() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data")
}
