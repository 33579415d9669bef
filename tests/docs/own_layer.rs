//! The layer in docs/adding_a_layer.md: what stands above the mark below is shown there, word by word.

use recede_layers::{Isotropic, Layer, Material, Notation, Plane, Poisson, Positive, Thickness, layer_laws};
use serde::Deserialize;

/// An isotropic layer whose shear modulus varies linearly from the top face to the bottom face.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Ramp {
    thickness: Thickness,
    top_modulus: Positive,
    bottom_modulus: Positive,
    poisson: Poisson,
}

impl Layer for Ramp {
    fn thickness(&self) -> Option<f64> {
        Some(self.thickness.get())
    }

    fn material(&self, depth: f64, plane: Plane) -> Material {
        let (top, bottom) = (self.top_modulus.get(), self.bottom_modulus.get());
        let part = depth / self.thickness.get();
        let shear_modulus = (1.0 - part) * top + part * bottom;
        Isotropic { shear_modulus, poisson: self.poisson.get() }.material(plane)
    }

    fn notation(&self) -> Notation {
        let [thickness, top, bottom, poisson] =
            [self.thickness.get(), self.top_modulus.get(), self.bottom_modulus.get(), self.poisson.get()];
        let parameters =
            format!("thickness: {thickness}, top_modulus: {top}, bottom_modulus: {bottom}, poisson: {poisson}");
        Notation { kind: "Ramp", parameters }
    }
}

#[cfg(test)]
fn example() -> Ramp {
    recede_layers::read_ron("(thickness: 0.5, top_modulus: 4.0, bottom_modulus: 1.0, poisson: 0.3)").unwrap()
}

layer_laws!(ramp, example());

#[test]
fn a_ramp_in_a_scene() -> Result<(), recede::Error> {
    let mut registry = recede::Registry::default();
    registry.register::<Ramp>("Ramp", "shear modulus linear in the depth");
    let scene = recede::Scene::from_ron_with(
        "Scene(plane: Strain, punch: Cylinder(radius: 100.0), force: 0.01, stack: [
            Ramp(thickness: 0.5, top_modulus: 4.0, bottom_modulus: 1.0, poisson: 0.3),
            Receding,
            HalfPlane(shear_modulus: 1.0, poisson: 0.3),
        ])",
        &registry,
    )?;
    let solution = recede::solve(&scene)?;
    assert_eq!(solution.contacts().len(), 2);
    Ok(())
}

// ---- not shown ----
