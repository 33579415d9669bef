//! Fields of given loads on stacks without receding interfaces move with the loads, are mirrored with them, and add up.
//!
//! Goal: bodies of all kinds, bonded and sliding; stresses to 1e-10, displacements but for a motion of the whole; the largest stresses move, too.
use recede::{
    EngineeringConstants, Exponential, Field, FieldPoint, HalfPlane, Homogeneous, Load, Loads, Model, Orthotropic,
    Plane, Stack,
};

fn bonded_stacks() -> Vec<Model> {
    let ply = EngineeringConstants::new([10.0, 1.0, 1.0], [0.3, 0.3, 0.4], 0.7).unwrap();
    let stack = || Stack::builder(Plane::Strain);
    let (strip, ground) = (|| Homogeneous::new(0.5, 4.0, 0.3).unwrap(), || HalfPlane::new(1.0, 0.25).unwrap());
    [
        stack().layer(ground()),
        stack().layer(strip()).bonded().layer(Exponential::new(0.7, 2.0, 0.3, -1.0).unwrap()).bonded().layer(ground()),
        stack().layer(Orthotropic::new(0.4, ply).unwrap()).bonded().layer(strip()).bonded().rigid(),
        stack().layer(strip()).sliding().rigid(),
    ]
    .map(|stack| Model::new(stack.build().unwrap()).unwrap())
    .into()
}

/// The field of loads (load, place, force).
fn field(model: &Model, parts: &[(Load, f64, f64)]) -> Field {
    let loads = Loads::new(parts).unwrap();
    model.field(&model.press(&loads, loads.force()).unwrap()).unwrap()
}

fn stresses(point: &FieldPoint) -> [f64; 4] {
    [point.sigma_xx, point.sigma_yy, point.sigma_xy, point.sigma_zz]
}

fn assert_near(found: impl IntoIterator<Item = f64>, expected: impl IntoIterator<Item = f64>, error: f64, what: &str) {
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found - expected).abs() < error, "{what}: {found} {expected}");
    }
}

#[test]
fn the_field_of_a_load_moves_with_it_and_is_mirrored() {
    for (number, model) in bonded_stacks().iter().enumerate() {
        for load in [Load::Line, Load::uniform(0.3).unwrap(), Load::elliptic(0.4).unwrap()] {
            let [here, there, image] = [-0.5, 0.75, 0.5].map(|at| (field(model, &[(load.clone(), at, 0.2)]), at));
            let at = |(field, by): &(Field, f64), x: f64, depth: f64| field.at(x + by, depth).unwrap();
            let origins = [&here, &there].map(|field| at(field, 0.0, 0.4));
            for (x, depth) in [(0.1, 0.2), (-0.35, 0.0), (1.7, 0.45), (-4.0, 0.3), (0.0, 0.05), (-0.75, 0.4)] {
                let what = format!("stack {number}, {load:?} at ({x}, {depth})");
                let [expected, found] = [&here, &there].map(|field| at(field, x, depth));
                assert_near(stresses(&found), stresses(&expected), 1e-10, &what);
                // displacements are known up to a motion of the whole
                let beside = |p: &FieldPoint, o: &FieldPoint| [p.u - o.u, p.v - o.v, p.slope];
                assert_near(beside(&found, &origins[1]), beside(&expected, &origins[0]), 1e-10, &what);
                let mirrored = at(&image, -x, depth);
                let [xx, yy, xy, zz] = stresses(&mirrored);
                assert_near(stresses(&expected), [xx, yy, -xy, zz], 1e-12, &what);
                assert_near([expected.u, expected.v], [-mirrored.u, mirrored.v], 1e-12, &what);
            }
        }
    }
}

#[test]
fn fields_of_loads_anywhere_add_up() {
    let parts = [(Load::Line, -0.5, 0.2), (Load::uniform(0.2).unwrap(), 1.0, 0.8)];
    for model in &bonded_stacks() {
        let all = field(model, &parts);
        let each = parts.clone().map(|part| field(model, &[part]));
        for (x, depth) in [(0.1, 0.2), (-0.5, 0.3), (1.1, 0.0), (-4.0, 0.45), (0.0, 0.1)] {
            let [found, one, other] = [&all, &each[0], &each[1]].map(|field| field.at(x, depth).unwrap());
            let sum = stresses(&one).into_iter().zip(stresses(&other)).map(|(one, other)| one + other);
            assert_near(stresses(&found), sum, 1e-10, &format!("({x}, {depth})"));
            assert_near([found.v], [one.v + other.v], 1e-10, &format!("({x}, {depth})"));
        }
    }
}

#[test]
fn the_largest_stresses_move_with_the_loads() {
    for model in &bonded_stacks() {
        let solve = |at: f64| {
            field(
                model,
                &[(Load::elliptic(0.2).unwrap(), 0.1 + at, 0.7), (Load::elliptic(0.3).unwrap(), 0.6 + at, 0.3)],
            )
        };
        let [here, left] = [0.0, -2.0].map(solve);
        let von_mises = |field: &Field| -> Vec<(f64, f64)> {
            let extremes = field.extremes().unwrap();
            extremes.layers.iter().filter_map(|layer| layer.von_mises).map(|found| (found.value, found.x)).collect()
        };
        for ((found, x), (expected, at)) in von_mises(&left).into_iter().zip(von_mises(&here)) {
            assert!((found / expected - 1.0).abs() < 1e-6 && (x + 2.0 - at).abs() < 2e-2, "{found} {expected}");
        }
        let [here, left] = [here, left].map(|field| field.max_shear().unwrap());
        assert!((left.value / here.value - 1.0).abs() < 1e-6 && (left.x + 2.0 - here.x).abs() < 2e-2);
    }
}
