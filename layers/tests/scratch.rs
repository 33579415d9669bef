//! Scratch.
use recede_layers::*;
use std::collections::BTreeMap;
#[test]
fn singles() {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/data/flexibility.json")).unwrap();
    let data: BTreeMap<String, serde_json::Value> = serde_json::from_str(&text).unwrap();
    for (name, case) in &data {
        let layers = case["layers_top_down"].as_array().unwrap();
        if layers.len() != 1 { continue }
        let l = &layers[0];
        let f = |k: &str| l[k].as_f64().unwrap();
        let layer: Box<dyn Layer> = if f("beta") == 0.0 { Box::new(Homogeneous::new(f("thickness"), f("shear_modulus"), f("poisson")).unwrap()) }
          else { Box::new(Exponential::new(f("thickness"), f("shear_modulus"), f("poisson"), f("beta")).unwrap()) };
        let mut worst = [0.0f64; 10]; let mut at=[0.0f64;10];
        for row in case["rows"].as_array().unwrap() {
            let num = |k: usize| row[k].as_f64().or_else(|| row[k].as_str().map(|s| s.parse().unwrap()));
            let lam = num(0).unwrap();
            let wave = Wave { wavenumber: lam, modulus: 1.0, plane: Plane::Strain };
            let r = [num(1).unwrap(), num(2).unwrap(), num(3).unwrap(), num(4).unwrap_or(f64::NAN), num(5).unwrap_or(f64::NAN)];
            let floor = 1e-10 * (r[0] * r[2].abs()).sqrt();
            for (k, x) in [layer.flexibility(&wave).unwrap(), Flexibility::of_face_states(&layer.face_states(&wave)).unwrap()].iter().enumerate() {
                let v = [x.top, x.coupling, x.bottom, x.equal_top, x.equal_bottom];
                for i in 0..5 {
                    let mut scale = r[i].abs(); if i == 1 { scale = scale.max(floor) }
                    if i >= 3 && lam < 1e-4 { continue }
                    if name == "graded_+30" && k == 0 && i >= 3 { println!("{lam} {i} {:e} {:e}", v[i], r[i]); }
                    let e = (v[i] - r[i]).abs() / scale;
                    if e > worst[5*k+i] { worst[5*k+i] = e; at[5*k+i]=lam; }
                }
            }
        }
        println!("{name:22} {}", worst.iter().zip(at).map(|(w,a)| format!("{w:.0e}@{a:.0e}")).collect::<Vec<_>>().join(" "));
    }
}
