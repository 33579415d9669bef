//! Interfaces that weights press together, where what presses is much shorter than the distances over which layers carry it.
//!
//! Goal: next to a load on a thin layer pressures are the ones on a rigid base, however far the layers below carry the force; and contacts that grow beyond all bounds take bounded time and memory.
use recede::{Model, Scene, Solution};

fn solved(text: &str) -> (Scene, Model, Solution) {
    let scene = Scene::from_ron(text).unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    (scene, model, solution)
}

/// A thin layer on one that is two thousand times as thick and five thousand times as stiff, on a softer half-plane.
fn thin_on_thick(force: f64) -> (Scene, Model, Solution) {
    solved(&format!(
        "Scene(geometry: PlaneStrain, load: Line, force: {force:?}, pressure_on_top: 1e-6, stack: [
        Homogeneous(thickness: 0.01, shear_modulus: 1, poisson: 0.25), Receding,
        Homogeneous(thickness: 20, shear_modulus: 5000, poisson: 0.25), Receding,
        HalfPlane(shear_modulus: 2, poisson: 0.25)])"
    ))
}

#[test]
fn a_thin_layer_opens_as_on_a_rigid_base() {
    // 44.139105985 and 1.770537706 by an independent program, in units of the pressure and the thickness
    let (scene, model, solution) = thin_on_thick(1e-7);
    let separation = model.separation(&scene.top, &solution).unwrap().unwrap();
    assert!((separation.critical_force / 44.139105985e-8 - 1.0).abs() < 1e-3, "{separation:?}");
    assert!((separation.x.abs() / 1.770537706e-2 - 1.0).abs() < 1e-3, "{separation:?}");
    // P = 50 in these units
    let (_, _, solution) = thin_on_thick(50e-8);
    let [_, opening] = solution.closed()[0].openings[..] else { panic!("{:?}", solution.closed()) };
    assert!((opening.left / 1.51519361381e-2 - 1.0).abs() < 3e-3, "{opening:?}");
    assert!((opening.right / 2.12291346677e-2 - 1.0).abs() < 3e-3, "{opening:?}");
    assert!(solution.closed()[1].openings.is_empty());
    // far below the critical force all is closed, and the pressure under the load is large
    let own = &thin_on_thick(1e-7).2.closed()[0].clone();
    assert!(own.openings.is_empty() && own.central_pressure > 8e-6, "{own:?}");
}

/// A wedge so blunt that its contact would be thousands of times as long as the layers are thick before these come apart.
#[test]
fn contacts_without_bound_take_bounded_memory() {
    let (scene, model, solution) = solved(
        "Scene(geometry: PlaneStrain, punch: Wedge(slope: 1e-6), force: 3e-3, pressure_on_top: 7e-6, stack: [
        Homogeneous(thickness: 10, shear_modulus: 50, poisson: 0.25), Receding,
        Exponential(thickness: 3.5, shear_modulus: 0.3, poisson: 0.25, beta: -2.3), Bonded, Rigid])",
    );
    assert!(solution.closed()[0].openings.is_empty());
    let separation = model.separation(&scene.top, &solution).unwrap();
    assert!(separation.is_none_or(|own| own.critical_force > scene.force.given().unwrap()), "{separation:?}");
}
