//! The program in README.md: what stands above the mark below is shown there, word by word.

use recede::{Exponential, HalfPlane, Homogeneous, Model, Plane, Punch, Stack};

fn main() -> Result<(), recede::Error> {
    let stack = Stack::builder(Plane::Strain)
        .layer(Homogeneous::new(1.0, 1.0, 0.25)?) // thickness, shear modulus, Poisson's ratio
        .bonded()
        .layer(Exponential::new(1.0, 1.0, 0.25, -1.0)?) // ... and β
        .receding()
        .layer(HalfPlane::new(1.0, 0.25)?)
        .build()?;
    let model = Model::new(stack)?; // the costly part, done once for any punch and force
    for force in [0.001, 0.002, 0.004] {
        let solution = model.press(&Punch::cylinder(500.0)?, force)?;
        for contact in solution.contacts() {
            println!("{force} {}: {:.8} {:.8}", contact.interface, contact.reach(), contact.pressure(0.5));
        }
    }
    Ok(())
}

// ---- not shown ----

#[test]
fn the_program_in_the_readme_runs() {
    assert!(main().is_ok());
}
