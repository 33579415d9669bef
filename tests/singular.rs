//! Fields where they are extreme: very narrow loads, points at which stresses are infinite, layers that are thin next to a
//! singular pressure, and stresses out of the plane.
//!
//! Laws: the largest shear stress under a uniform load q on a half-plane is q/π; answers do not depend on the unit of length;
//! what is infinite is never a number; stresses across interfaces are continuous; ε_zz = 0 in plane strain.
use recede::report::{Format, write_field};
use recede::{
    EngineeringConstants, Exponential, Field, FieldPoint, FieldQuantity, HalfPlane, Homogeneous, Isotropic, Layer,
    Load, Material, Model, Orthotropic, OrthotropicHalfPlane, Plane, Punch, Solution, Stack, StackBuilder,
};

fn stack() -> StackBuilder {
    Stack::builder(Plane::Strain)
}

fn ground(modulus: f64) -> HalfPlane {
    HalfPlane::new(modulus, 0.3).unwrap()
}

fn strip(thickness: f64, modulus: f64) -> Homogeneous {
    Homogeneous::new(thickness, modulus, 0.3).unwrap()
}

fn press(stack: StackBuilder, punch: impl Into<recede::Top>, force: f64) -> (Solution, Field) {
    let model = Model::new(stack.build().unwrap()).unwrap();
    let solution = model.press(punch, force).unwrap();
    let field = model.field(&solution).unwrap();
    (solution, field)
}

fn close(found: f64, expected: f64, error: f64, what: &str) {
    assert!((found - expected).abs() <= error, "{what}: {found:e} is not {expected:e} ± {error:e}");
}

#[test]
fn the_largest_shear_stress_under_a_uniform_load_is_that_of_a_half_plane_however_narrow_it_is() {
    for (half_width, force) in [1e-3, 1e-8, 1e-12, 1e-14, 1e-100].into_iter().flat_map(|a| [(a, 1.0), (1e6 * a, 1e3)]) {
        let load = recede::Top::from(Load::uniform(half_width).unwrap());
        let found = press(stack().layer(ground(1.0)), &load, force).1.max_shear().unwrap();
        let expected = 0.5 * force / half_width / std::f64::consts::PI;
        close(found.value, expected, 1e-6 * expected, &format!("{half_width:e}"));
    }
}

#[test]
fn narrow_loads_are_line_loads_everywhere_but_below_them() {
    let stacks: [StackBuilder; 3] = [
        stack().layer(strip(1.0, 1.0)).receding().layer(ground(0.5)),
        stack().layer(Exponential::new(1.0, 1.0, 0.3, -1.5).unwrap()).bonded().layer(ground(2.0)),
        stack().layer(strip(0.3, 2.0)).bonded().layer(recede::GradedHalfPlane::new(1.0, 0.3, 0.5).unwrap()),
    ];
    for (i, stack) in stacks.into_iter().enumerate() {
        let (line, expected) = press(stack.clone(), recede::Top::from(Load::Line), 1.0);
        for half_width in [1e-8, 1e-11, 1e-14] {
            let (narrow, found) = press(stack.clone(), recede::Top::from(Load::uniform(half_width).unwrap()), 1.0);
            for (narrow, line) in narrow.contacts().iter().zip(line.contacts()).skip(1) {
                close(narrow.half_length().unwrap(), line.half_length().unwrap(), 1e-10, "half-length");
            }
            for (x, depth) in [(0.4, 0.0), (0.0, 0.3), (0.4, 0.9), (-1.7, 0.5)] {
                let [found, expected] = [&found, &expected].map(|field| field.at(x, depth).unwrap());
                let what = format!("stack {i}, {half_width:e} at ({x}, {depth})");
                close(found.sigma_xx, expected.sigma_xx, 1e-7, &what);
                close(found.sigma_yy, expected.sigma_yy, 1e-7, &what);
                close(found.sigma_xy, expected.sigma_xy, 1e-7, &what);
            }
        }
    }
}

#[test]
fn singular_points_are_infinite_and_nothing_else_is() {
    let pair = crate::support::mirrored(&[(0.7, 1.0, Load::Line), (0.1, 1.0, Load::uniform(0.1).unwrap())]).unwrap();
    for (punch, at, shear) in [
        (recede::Top::from(Load::Line), 0.0, true),
        (recede::Top::from(pair), 0.7, true),
        (Punch::flat(0.6).unwrap().into(), 0.6, true),
        (Punch::wedge(0.01).unwrap().into(), 0.0, false),
    ] {
        for (i, stack) in [
            stack().layer(ground(1.0)),
            stack().layer(strip(1.0, 1.0)).receding().layer(ground(1.0)),
            stack().layer(Orthotropic::new(1.0, ply()).unwrap()).bonded().layer(ground(1.0)),
        ]
        .into_iter()
        .enumerate()
        {
            let (_, field) = press(stack, &punch, 0.01);
            let grid = field.grid(&[-at, 0.35, at, 1.3], &[0.0, 1e-6, 0.5]).unwrap();
            for point in grid.points() {
                let singular = point.x.abs() == at && point.depth == 0.0;
                let what = format!("{punch} {point:?}");
                assert_eq!(
                    (point.sigma_xx, point.sigma_yy) == (f64::NEG_INFINITY, f64::NEG_INFINITY),
                    singular,
                    "{what}"
                );
                for quantity in
                    // nothing is strained out of the plane
                    FieldQuantity::all_in(recede::Geometry::PlaneStrain)
                        .filter(|q| !matches!(q, FieldQuantity::U | FieldQuantity::V | FieldQuantity::EpsZz))
                {
                    assert_eq!(quantity.of(point).is_finite(), !singular, "{} of {what}", quantity.name());
                }
            }
            let mut text = Vec::new();
            let scene = recede::Scene::new(recede::Geometry::PlaneStrain, punch.clone(), 0.01, Vec::new());
            write_field(&grid.points()[..1], &scene, Format::Json, &mut text).unwrap();
            let json: serde_json::Value = serde_json::from_slice(&text).unwrap();
            assert!(json["points"][0]["sigma_yy"].is_null() && json["points"][0]["u"].is_number());
            // on a face that is not isotropic, stresses along and across it are infinite, and different
            let infinite = shear || i == 2;
            assert_eq!(field.max_shear().unwrap().value.is_infinite(), infinite, "{punch}, {i}");
        }
    }
}

fn ply() -> EngineeringConstants {
    EngineeringConstants::new([14.0, 1.0, 3.0], [0.3, 0.25, 0.2], 0.5).unwrap()
}

#[test]
fn the_stress_out_of_the_plane_follows_from_all_constants() {
    let ([ex, ey, ez], [_, xz, yz]) = ([14.0, 1.0, 3.0], [0.3, 0.25, 0.2]);
    for plane in [Plane::Strain, Plane::Stress] {
        let layers = Stack::builder(plane).layer(Orthotropic::new(0.5, ply()).unwrap()).receding();
        let (_, field) = press(layers.layer(OrthotropicHalfPlane::new(ply())), Punch::parabola(100.0).unwrap(), 0.01);
        for (x, depth) in [(0.0, 0.0), (0.2, 0.3), (0.1, 0.9)] {
            let FieldPoint { sigma_xx, sigma_yy, sigma_zz, .. } = field.at(x, depth).unwrap();
            if plane == Plane::Stress {
                assert_eq!(sigma_zz, 0.0);
                continue;
            }
            let strain = sigma_zz / ez - xz / ex * sigma_xx - yz / ey * sigma_yy;
            close(strain, 0.0, 1e-15, "ε_zz");
        }
    }
}

/// Known by the four coefficients of the plane problem only.
#[derive(Debug)]
struct Plain;

impl Layer for Plain {
    fn thickness(&self) -> Option<f64> {
        Some(0.5)
    }

    fn material(&self, _: f64, plane: Plane) -> Material {
        Material { out_of_plane: None, ..Isotropic { shear_modulus: 1.0, poisson: 0.3 }.material(plane) }
    }
}

#[test]
fn a_stress_that_is_not_known_is_no_number() {
    for (plane, known) in [(Plane::Strain, false), (Plane::Stress, true)] {
        let stack = Stack::builder(plane).layer(Plain).bonded().layer(ground(1.0));
        let punch = Punch::parabola(100.0).unwrap();
        let (_, field) = press(stack, punch.clone(), 0.01);
        let [above, below] = [0.2, 0.7].map(|depth| field.at(0.1, depth).unwrap());
        assert_eq!((above.sigma_zz.is_finite(), above.von_mises().is_finite()), (known, known));
        assert!(below.von_mises().is_finite() && above.max_shear().is_finite());
        let mut text = Vec::new();
        let scene = recede::Scene::new(plane, punch, 0.01, Vec::new());
        write_field(&[above], &scene, Format::Csv, &mut text).unwrap();
        let empty = String::from_utf8(text).unwrap().trim_end().split(',').filter(|field| field.is_empty()).count();
        assert_eq!(empty, if known { 0 } else { 2 });
    }
}

#[test]
fn interfaces_and_faces_keep_their_conditions_next_to_any_pressure() {
    let punches: [recede::Top; 6] = [
        Punch::parabola(100.0).unwrap().into(),
        Punch::wedge(0.01).unwrap().into(),
        Punch::flat(0.3).unwrap().into(),
        Punch::rounded_flat(0.2, 5.0).unwrap().into(),
        Load::uniform(0.2).unwrap().into(),
        Load::Line.into(),
    ];
    let graded = |h: f64, beta: f64| Exponential::new(h, 1.0, 0.3, beta).unwrap();
    let stacks = || {
        [
            stack().layer(strip(0.04, 0.5)).sliding().layer(graded(0.8, -0.7)).bonded().layer(ground(4.0)),
            stack()
                .layer(strip(0.06, 0.7))
                .bonded()
                .layer(Orthotropic::new(0.07, ply()).unwrap())
                .receding()
                .layer(ground(9.0)),
            stack().layer(graded(0.5, 2.0)).bonded().layer(strip(0.3, 4.0)).receding().layer(ground(1.0)),
        ]
    };
    for punch in &punches {
        for (i, stack) in stacks().into_iter().enumerate() {
            let (solution, field) = press(stack, punch, 0.01);
            let peak = solution
                .contacts()
                .iter()
                .map(|c| c.resultant / (2.0 * c.half_length().unwrap()))
                .filter(|p| p.is_finite());
            let tolerance = 1e-9 * peak.fold(0.01, f64::max);
            let faces: Vec<(usize, [f64; 2])> = field.layers().collect();
            for x in [0.0, 0.05, 0.19, 0.31, 1.0] {
                for pair in faces.windows(2) {
                    let depth = pair[0].1[1];
                    let [above, below] = [pair[0].0, pair[1].0].map(|layer| field.at_layer(x, depth, layer).unwrap());
                    let what = format!("{punch} on stack {i}, x = {x}, depth {depth}");
                    close(above.sigma_yy, below.sigma_yy, tolerance, &what);
                    close(above.sigma_xy, below.sigma_xy, tolerance, &what);
                }
                // just under the top face stresses are those on it
                let [on, under] = [0.0, 1e-12].map(|depth| field.at(x, depth).unwrap());
                if on.sigma_yy.is_finite() {
                    close(
                        under.sigma_yy,
                        on.sigma_yy,
                        1e2 * tolerance,
                        &format!("{punch} on stack {i}, just under x = {x}"),
                    );
                    close(
                        on.sigma_yy,
                        -solution.contacts()[0].pressure(x),
                        1e2 * tolerance,
                        &format!("{punch}, {i}, {x}"),
                    );
                }
            }
        }
    }
}
