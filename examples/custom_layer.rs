//! A user-defined layer type, in one file: a case-hardened layer, stiff at its face and soft in its core.
//!
//! `cargo run --release --example custom_layer`
use recede::layers::{Poisson, Positive, Thickness, conformance};
use recede::{HalfPlane, Isotropic, Layer, LayerError, Material, Plane, Punch, Registry, Scene, Stack};
use serde::Deserialize;

/// μ(d) = core + (face − core) exp(−(d/reach)²) at depth d below the face.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Hardened {
    thickness: Thickness,
    face_modulus: Positive,
    core_modulus: Positive,
    reach: Positive,
    poisson: Poisson,
}

impl Layer for Hardened {
    fn thickness(&self) -> Option<f64> {
        Some(self.thickness.get())
    }

    fn material(&self, depth: f64, plane: Plane) -> Material {
        let (face, core) = (self.face_modulus.get(), self.core_modulus.get());
        let hardening = (-(depth / self.reach.get()).powi(2)).exp();
        Isotropic { shear_modulus: core + (face - core) * hardening, poisson: self.poisson.get() }.material(plane)
    }
}

impl Hardened {
    fn new(thickness: f64, face: f64, core: f64, reach: f64, poisson: f64) -> Result<Self, LayerError> {
        Ok(Self {
            thickness: LayerError::checked("thickness", thickness)?,
            face_modulus: LayerError::checked("face_modulus", face)?,
            core_modulus: LayerError::checked("core_modulus", core)?,
            reach: LayerError::checked("reach", reach)?,
            poisson: LayerError::checked("poisson", poisson)?,
        })
    }
}

/// Examines the layer, and presses a punch on it in a scene and in a program.
pub fn main() -> Result<(), recede::Error> {
    // the laws that any layer obeys
    let layer = Hardened::new(0.5, 4.0, 1.0, 0.1, 0.3)?;
    for plane in [Plane::Strain, Plane::Stress] {
        assert_eq!(conformance::examine(&layer, plane), Ok(()));
    }

    // in a scene, by the name under which it is registered
    let mut registry = Registry::default();
    registry.register::<Hardened>("Hardened", "stiff at its face, soft in its core");
    let text = "Scene(geometry: PlaneStrain, punch: Cylinder(radius: 100.0), force: 0.01, stack: [
        Hardened(thickness: 0.5, face_modulus: 4.0, core_modulus: 1.0, reach: 0.1, poisson: 0.3),
        Receding,
        HalfPlane(shear_modulus: 1.0, poisson: 0.3),
    ])";
    let read = recede::solve(&Scene::from_reader("scene", text.as_bytes(), &registry)?)?;

    // in a program, as an argument
    let ground = HalfPlane::new(1.0, 0.3)?;
    let stack = Stack::builder(Plane::Strain).layer(layer).receding().layer(ground).build()?;
    let built = recede::Model::new(stack)?.press(&Punch::cylinder(100.0)?, 0.01)?;

    for (one, other) in read.contacts().iter().zip(built.contacts()) {
        println!("{}: {} ± {:e}", one.interface, one.half_length().unwrap(), one.half_length_error().unwrap());
        assert_eq!(one.half_length().unwrap(), other.half_length().unwrap());
    }
    Ok(())
}
