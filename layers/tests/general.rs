//! Scratch.
use recede_layers::*;
use std::collections::BTreeMap;
fn flex(l:&dyn Layer,w:&Wave)->[f64;5]{ let x=Flexibility::of_face_states(&graded::face_states(l,w)).unwrap(); [x.top,x.coupling,x.bottom,x.equal_top,x.equal_bottom]}
#[test]
fn reference() {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/data/flexibility.json")).unwrap();
    let data: BTreeMap<String, serde_json::Value> = serde_json::from_str(&text).unwrap();
    for (name, case) in &data {
        let layers = case["layers_top_down"].as_array().unwrap();
        if layers.len() != 1 { continue }
        let l = &layers[0];
        let f = |k: &str| l[k].as_f64().unwrap();
        let layer: Box<dyn Layer> = if f("beta") == 0.0 { Box::new(Homogeneous::new(f("thickness"), f("shear_modulus"), f("poisson")).unwrap()) }
          else { Box::new(Exponential::new(f("thickness"), f("shear_modulus"), f("poisson"), f("beta")).unwrap()) };
        let mut worst = [0.0f64; 5]; let mut at=[0.0f64;5];
        for row in case["rows"].as_array().unwrap() {
            let num = |k: usize| row[k].as_f64().or_else(|| row[k].as_str().map(|s| s.parse().unwrap()));
            let lam = num(0).unwrap();
            let wave = Wave { wavenumber: lam, modulus: 1.0, plane: Plane::Strain };
            let r = [num(1).unwrap(), num(2).unwrap(), num(3).unwrap(), num(4).unwrap_or(f64::NAN), num(5).unwrap_or(f64::NAN)];
            let floor = 1e-10 * (r[0] * r[2].abs()).sqrt();
            let v = flex(&*layer,&wave);
                for i in 0..5 {
                    let mut scale = r[i].abs(); if i == 1 { scale = scale.max(floor) }
                    if i >= 3 && lam < 1e-4 { continue }
                    let e = (v[i] - r[i]).abs() / scale;
                    if e > worst[i] { worst[i] = e; at[i]=lam; }
                }
        }
        println!("{name:22} {}", worst.iter().zip(at).map(|(w,a)| format!("{w:.0e}@{a:.0e}")).collect::<Vec<_>>().join(" "));
    }
}
#[test]
fn sweep() {
  for plane in [Plane::Strain,Plane::Stress] {
  for nu in [-0.9,-0.3,0.0,0.25,0.45,0.5] { for b in [0.0,1e-6,0.5,2.0,8.0,30.0,-0.5,-2.0,-8.0,-30.0] {
    let layer = Exponential::new(1.0,1.0,nu,b).unwrap();
    let mut worst = [0.0f64; 5]; let mut at=[0.0f64;5];
    for k in -80..=80 { let lam = 10f64.powf(0.1*k as f64);
       let wave = Wave { wavenumber: lam, modulus: 1.0, plane };
       let x=layer.flexibility(&wave).unwrap(); let r=[x.top,x.coupling,x.bottom,x.equal_top,x.equal_bottom];
       let v=flex(&layer,&wave);
            let floor = 1e-10 * (r[0] * r[2].abs()).sqrt();
                for i in 0..5 {
                    let mut scale = r[i].abs(); if i == 1 { scale = scale.max(floor) }
                    if i >= 3 && lam < 1e-4 { continue }
                    let e = (v[i] - r[i]).abs() / scale;
                    if !(e <= worst[i]) { worst[i] = e; at[i]=lam; }
                }
    }
    println!("{plane:?} {nu} {b} {}", worst.iter().zip(at).map(|(w,a)| format!("{w:.0e}@{a:.0e}")).collect::<Vec<_>>().join(" "));
  }}}
  let layer = Exponential::new(1.0,1.0,0.25,1.0).unwrap();
  for lam in [1e-3,1.0,10.0,50.0,1e3,1e8] {
       let wave = Wave { wavenumber: lam, modulus: 1.0, plane:Plane::Strain };
       let t=std::time::Instant::now(); for _ in 0..100 { std::hint::black_box(flex(&layer,&wave)); } println!("{lam} {:?}", t.elapsed()/100);
  }
}
