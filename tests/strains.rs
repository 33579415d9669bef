//! Strains inside the stack.
//!
//! Goal: strains are the derivatives of displacements, in all geometries and in layers of all kinds; the largest tensile strain of a layer is nowhere exceeded, and is the
//! strain at its place.
use recede::{Field, FieldPoint, Model, Scene};

const SCENES: [&str; 4] = [
    "Scene(geometry: PlaneStrain, punch: Parabola(radius: 100.0), force: 0.02, stack: [
        Orthotropic(thickness: 0.4, young: (x: 3.0, y: 1.0, z: 1.0), shear_modulus: 0.5, poisson: (xy: 0.2, xz: 0.2, yz: 0.2)),
        Bonded, Exponential(thickness: 0.6, shear_modulus: 0.75, beta: 0.5, poisson: 0.25), Receding, HalfPlane(shear_modulus: 0.5, poisson: 0.3)])",
    "Scene(geometry: PlaneStress, loads: [(load: Uniform(half_width: 0.3), at: 0.0, force: 0.02), (load: Uniform(half_width: 0.2), at: 1.0, force: 0.01)], stack: [
        Homogeneous(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25), Receding, HalfPlane(shear_modulus: 0.75, poisson: 0.25)])",
    "Scene(geometry: Axisymmetric, punch: Sphere(radius: 100.0), force: 0.05, stack: [
        Homogeneous(thickness: 0.5, shear_modulus: 2.0, poisson: 0.3), Bonded, Exponential(thickness: 0.5, shear_modulus: 0.75, beta: -0.5, poisson: 0.25),
        Receding, HalfPlane(shear_modulus: 0.75, poisson: 0.4)])",
    "Scene(geometry: PlaneStrain, load: Uniform(half_width: 0.5), force: 20.0, stack: [
        Homogeneous(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25, specific_weight: 1.0), Receding, HalfPlane(shear_modulus: 0.75, poisson: 0.25)])",
];

fn field(text: &str) -> (Scene, Field) {
    let scene = Scene::from_ron(text).unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    let field = model.field(&solution).unwrap();
    (scene, field)
}

#[test]
fn strains_are_derivatives_of_displacements() {
    for text in SCENES {
        let (scene, field) = field(text);
        let size = |point: &FieldPoint| point.principal_strains()[1].abs();
        let largest = size(&field.at(0.0, 0.3).unwrap());
        for (x, depth) in [(0.15, 0.2), (0.7, 0.3), (-0.4, 0.75), (0.3, 1.6), (-2.0, 1.2)] {
            let h = 1e-3;
            let at = |x: f64, depth: f64| field.at(x, depth).unwrap();
            // of fourth order
            let derivative =
                |of: &dyn Fn(f64) -> f64| (8.0 * (of(h) - of(-h)) - (of(2.0 * h) - of(-2.0 * h))) / (12.0 * h);
            let here = at(x, depth);
            let along = derivative(&|by| at(x + by, depth).u);
            let across = derivative(&|by| at(x, depth - by).v);
            let shear = derivative(&|by| at(x, depth - by).u) + derivative(&|by| at(x + by, depth).v);
            for (found, expected) in [(here.eps_xx, along), (here.eps_yy, across), (here.gamma_xy, shear)] {
                assert!((found - expected).abs() < 1e-7 * largest, "{text} {x} {depth}: {found} {expected}");
            }
            if scene.geometry.is_axisymmetric() {
                assert!((here.eps_zz - here.u / x).abs() < 1e-12 * largest);
            }
        }
    }
}

/// Out of the plane nothing is strained in plane strain, and the layer is as thin as Poisson's ratio says in plane stress.
#[test]
fn strains_out_of_the_plane_follow_from_the_geometry() {
    let (_, strain) = field(SCENES[0]);
    assert_eq!(strain.at(0.3, 0.2).unwrap().eps_zz, 0.0);
    let (_, stress) = field(SCENES[1]);
    let point = stress.at(0.3, 0.2).unwrap();
    let young = 2.0 * 0.75 * 1.25;
    let expected = -0.25 / young * (point.sigma_xx + point.sigma_yy);
    assert!((point.eps_zz / expected - 1.0).abs() < 1e-12 && expected > 0.0);
    let orthotropic = SCENES[0].replace("PlaneStrain", "PlaneStress");
    assert!(field(&orthotropic).1.at(0.3, 0.2).unwrap().eps_zz.is_nan());
}

#[test]
fn the_largest_tensile_strain_is_nowhere_exceeded() {
    for text in SCENES {
        let (_, field) = field(text);
        for own in field.extremes().unwrap().layers {
            let largest = own.tensile_strain.unwrap();
            let there = field.at_layer(largest.x, largest.depth, own.layer).unwrap();
            assert!((there.tensile_strain() / largest.value - 1.0).abs() < 1e-9, "{text}: {own:?}");
            assert!(largest.error < 1e-6 * largest.value && largest.layer == own.layer, "{text}: {own:?}");
            let (_, [top, bottom]) = field.layers().find(|(layer, _)| *layer == own.layer).unwrap();
            for k in 0..=8 {
                let depth = top + (bottom.min(top + 3.0) - top) * f64::from(k) / 8.0;
                for j in -20..=20 {
                    let x = 0.1 * f64::from(j);
                    let strain = field.at_layer(x, depth, own.layer).unwrap().tensile_strain();
                    assert!(strain <= largest.value * (1.0 + 1e-6), "{text} {x} {depth}: {strain} {own:?}");
                }
            }
        }
    }
}
