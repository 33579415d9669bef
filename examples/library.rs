//! The library in a dozen lines: describe a stack, press a punch on it, ask for contacts and pressures.
//!
//! `cargo run --release --example library`
use recede::{Exponential, HalfPlane, Homogeneous, Model, Plane, Punch, Stack};

/// Solves a stack and prints what was found.
pub fn main() -> Result<(), recede::Error> {
    let stack = Stack::builder(Plane::Strain)
        .layer(Homogeneous::new(1.0, 1.0, 0.25)?)
        .bonded()
        .layer(Exponential::new(1.0, 1.0, 0.25, -1.0)?)
        .receding()
        .layer(HalfPlane::new(1.0, 0.25)?)
        .build()?;
    let model = Model::new(stack)?;
    let solution = model.press(&Punch::cylinder(500.0)?, 0.002)?;
    for contact in solution.contacts() {
        let (name, a) = (contact.interface.to_string(), contact.half_length().unwrap());
        println!("{name:6} half-length {a:.9}, pressure at half of it {:.9}", contact.pressure(0.5 * a));
        assert!((contact.resultant / 0.002 - 1.0).abs() < 1e-12);
    }
    assert!((solution.contacts()[1].half_length().unwrap() - 2.448_610_298).abs() < 1e-8);
    Ok(())
}
