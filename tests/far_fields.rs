//! Fields far from the loads, and next to layers much thinner than contacts: what Saint-Venant, Flamant and Boussinesq demand, and errors
//! that are no larger than their estimates.
use recede::{Field, FieldPoint, Geometry, HalfPlane, Homogeneous, Load, Model, Point, Stack};

const FORCE: f64 = 1e-3;

fn strip(thickness: f64, modulus: f64) -> Homogeneous {
    Homogeneous::new(thickness, modulus, 0.3).unwrap()
}

fn ground(modulus: f64) -> HalfPlane {
    HalfPlane::new(modulus, 0.3).unwrap()
}

fn loaded(stack: Stack, load: Load) -> Field {
    let model = Model::new(stack).unwrap();
    let solution = model.press(recede::Top::from(load), FORCE).unwrap();
    model.field(&solution).unwrap()
}

fn geometries() -> [Geometry; 2] {
    [Geometry::PlaneStrain, Geometry::Axisymmetric]
}

fn loads() -> [Load; 3] {
    [Load::uniform(1.0).unwrap(), Load::elliptic(1.0).unwrap(), Load::Line]
}

fn stresses(point: &FieldPoint) -> [f64; 4] {
    [point.sigma_xx, point.sigma_yy, point.sigma_xy, point.sigma_zz]
}

/// A half-plane is the same if it is cut: its upper part is then a layer with sums over wavenumbers, whose error is known.
#[test]
fn a_cut_changes_nothing_by_more_than_the_estimate() {
    for (geometry, load) in geometries().into_iter().flat_map(|geometry| loads().map(|load| (geometry, load))) {
        let whole = loaded(Stack::builder(geometry).layer(ground(2.0)).build().unwrap(), load.clone());
        // next to a layer this thin a load takes a million wavenumbers
        let is_elliptic = matches!(load, Load::Elliptic { .. }) && !geometry.is_axisymmetric();
        let thinnest = if load == Load::Line { 1e-5 } else { [1e-2, 1e-4][usize::from(is_elliptic)] };
        for h in [thinnest, 1e-2, 1.0, 1e5] {
            let stack = Stack::builder(geometry).layer(strip(h, 2.0)).bonded().layer(ground(2.0));
            let cut = loaded(stack.build().unwrap(), load.clone());
            let depths = [(0.0, 1), (0.3 * h, 1), (h, 1), (h, 2), (1.2 * h + 0.7, 2), (h + 3e4, 2)];
            let places = [0.4, 0.99, 0.9999, 1.37, 137.0, 1.37e4, 1.37e6, 1.37e8];
            let point = |x: f64| depths.map(|(depth, layer)| Point { x, depth, layer: Some(layer) });
            let points: Vec<Point> = places.into_iter().flat_map(point).collect();
            for (point, found) in points.iter().zip(cut.points(&points).unwrap()) {
                let expected = stresses(&whole.at(point.x, point.depth).unwrap());
                let error = cut.stress_error(point).unwrap();
                let what = format!("{geometry:?} {load:?}, h = {h:e}, {point}");
                for (found, expected) in stresses(&found).into_iter().zip(expected) {
                    let allowed = error + 1e-12 * expected.abs();
                    assert!((found - expected).abs() <= allowed, "{what}: {found:e} is not {expected:e}, {error:e}");
                }
                // a line load on a thin layer is like one of this length
                let spread = h.min(1.0).powi(if geometry.is_axisymmetric() { 2 } else { 1 });
                assert!(error * spread < 1e-9 * FORCE || is_elliptic && h < 1e-3, "{what}: {error:e}");
            }
        }
    }
}

#[test]
fn a_loose_strip_is_free_of_stress_far_away() {
    for (geometry, load) in geometries().into_iter().flat_map(|geometry| loads().map(|load| (geometry, load))) {
        for h in [1e-2, 1.0, 1e3] {
            let stack = Stack::builder(geometry).layer(strip(h, 1.0)).receding().layer(ground(1.0)).build().unwrap();
            let field = loaded(stack, load.clone());
            // forces in a strip end with its contacts, stresses a few thicknesses farther out
            let places = [1.0, 1e2, 1e4, 1e6].map(|far| 200.0 * (1.0 + h) * far);
            let point = |x: f64| [0.0, 0.5, 0.8].map(|part| Point { x, depth: part * h, layer: Some(1) });
            let points: Vec<Point> = places.into_iter().flat_map(point).collect();
            for (point, found) in points.iter().zip(field.points(&points).unwrap()) {
                let error = field.stress_error(point).unwrap();
                // a plate about an axis has the stresses of Lamé's ring, which fall like 1/r²
                let lame = if geometry.is_axisymmetric() { FORCE / (h.min(1.0) * point.x).powi(2) } else { 0.0 };
                for value in stresses(&found) {
                    assert!(
                        value.abs() <= error + lame,
                        "{geometry:?} {load:?}, h = {h:e}, {point}: {value:e}, {error:e}"
                    );
                }
            }
        }
    }
}

/// Whatever lies on it, a half-plane has the stresses of a force far away.
#[test]
fn far_away_a_load_is_a_force() {
    for (geometry, load) in geometries().into_iter().flat_map(|geometry| loads().map(|load| (geometry, load))) {
        let force = loaded(Stack::builder(geometry).layer(ground(1.0)).build().unwrap(), Load::Line);
        let stack = Stack::builder(geometry).layer(strip(0.3, 20.0)).bonded().layer(strip(0.7, 0.2)).bonded();
        let field = loaded(stack.layer(ground(1.0)).build().unwrap(), load.clone());
        for far in [1e4, 1e6, 1e8] {
            for (x, depth) in [(0.0, 1.0), (0.4, 0.9), (1.0, 1.0), (1.0, 0.3)] {
                let (x, depth) = (x * far, depth * far);
                let (found, expected) = (field.at(x, depth).unwrap(), force.at(x, depth).unwrap());
                let size = stresses(&expected).into_iter().fold(0.0, |size: f64, stress| size.max(stress.abs()));
                for (found, expected) in stresses(&found).into_iter().zip(stresses(&expected)) {
                    // layers of another stiffness are dipoles, smaller by their thickness over the distance
                    let allowed = (100.0 / far + 1e-9) * size;
                    assert!(
                        (found - expected).abs() <= allowed,
                        "{geometry:?} {load:?}, {x:e}, {depth:e}: {found:e} is not {expected:e}"
                    );
                }
            }
        }
    }
}
