//! Fields inside the stack: what equilibrium, the contacts and closed forms demand of them.
//!
//! Tolerances are parts of the peak pressure: 1e-8 inside, 1e-6 on the faces.
use recede::{EngineeringConstants, FieldPoint, Layer, Orthotropic, OrthotropicHalfPlane};
use recede::{Exponential, Field, HalfPlane, Homogeneous, Model, Plane, Point, Punch, Scene, Solution, Stack};

const INSIDE: f64 = 1e-8;
const ON_FACE: f64 = 1e-6;
/// So far along the layers resultants are integrated: in the base, and in laminates, whose stresses end with the contacts.
const FAR: [f64; 2] = [400.0, 40.0];

struct Case {
    name: &'static str,
    stack: Stack,
    solution: Solution,
    field: Field,
}

impl Case {
    fn new(name: &'static str, stack: Stack, radius: f64, force: f64) -> Self {
        let model = Model::new(stack).expect("resolved");
        let solution = model.press(Punch::parabola(radius).expect("legal"), force).expect("solved");
        Self { name, field: model.field(&solution).unwrap(), stack: model.stack().clone(), solution }
    }

    fn peak(&self) -> f64 {
        self.solution.contacts().iter().fold(0.0, |peak, contact| peak.max(contact.central_pressure))
    }
}

fn strip(thickness: f64, modulus: f64) -> Homogeneous {
    Homogeneous::new(thickness, modulus, 0.3).expect("legal")
}

fn graded(thickness: f64, beta: f64) -> Exponential {
    Exponential::new(thickness, 1.0, 0.25, beta).expect("legal")
}

fn ground(modulus: f64) -> HalfPlane {
    HalfPlane::new(modulus, 0.2).expect("legal")
}

/// A fibre composite, fibres along it; its fields decay with real roots, those of `wood` with complex ones.
fn ply() -> EngineeringConstants {
    EngineeringConstants::new([14.0, 1.0, 1.0], [0.3, 0.3, 0.4], 0.5).expect("stable")
}

fn wood() -> EngineeringConstants {
    EngineeringConstants::new([1.2, 1.0, 0.5], [0.2, 0.25, 0.3], 1.7).expect("stable")
}

fn built(builder: recede::StackBuilder) -> Stack {
    builder.build().expect("legal")
}

fn cases() -> Vec<Case> {
    let stack = || Stack::builder(Plane::Strain);
    let on_ground = stack().layer(strip(1.0, 1.0)).receding().layer(ground(1.0));
    let on_rigid = stack().layer(strip(1.0, 1.0)).receding().rigid();
    let coating = stack().layer(strip(0.3, 20.0)).bonded().layer(ground(1.0));
    let graded_on_ground = stack().layer(graded(1.0, -1.0)).receding().layer(ground(1.0));
    let bonded = Stack::builder(Plane::Stress).layer(graded(1.0, 2.0)).bonded().layer(strip(0.5, 3.0)).bonded().rigid();
    vec![
        Case::new("strip on half-plane", built(on_ground), 500.0, 0.002),
        Case::new("strip on rigid base", built(on_rigid), 500.0, 0.002),
        Case::new("coating", built(coating), 50.0, 0.02),
        Case::new("graded layer on half-plane", built(graded_on_ground), 500.0, 0.002),
        Case::new("three contacts", three_contacts(), 300.0, 0.003),
        Case::new("composite on wood", composite_on_wood(), 500.0, 0.002),
        Case::new("plywood on composite", plywood_on_composite(), 500.0, 0.002),
        Case::new("bonded to rigid base", built(bonded), 100.0, 0.01),
    ]
}

fn three_contacts() -> Stack {
    let upper = Stack::builder(Plane::Strain).layer(strip(0.5, 2.0)).bonded().layer(graded(0.7, 1.5)).receding();
    let middle = upper.layer(strip(0.8, 1.0)).bonded().layer(graded(0.4, -3.0)).receding();
    built(middle.layer(strip(0.5, 0.5)).bonded().layer(ground(2.0)))
}

fn composite_on_wood() -> Stack {
    let composite = Orthotropic::new(0.8, ply()).expect("legal");
    built(Stack::builder(Plane::Strain).layer(composite).receding().layer(OrthotropicHalfPlane::new(wood())))
}

fn plywood_on_composite() -> Stack {
    let [wood, ply_layer] = [(0.3, wood()), (0.4, ply())].map(|(h, constants)| Orthotropic::new(h, constants));
    let plywood = Stack::builder(Plane::Strain).layer(wood.expect("legal")).bonded().layer(ply_layer.expect("legal"));
    built(plywood.receding().layer(strip(0.3, 1.0)).bonded().layer(OrthotropicHalfPlane::new(ply())))
}

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance, "{what}: {found:e} is not {expected:e} ± {tolerance:e}");
}

#[test]
fn a_half_plane_alone_has_the_stresses_of_mcewen() {
    let case =
        Case::new("hertz", Stack::builder(Plane::Strain).layer(ground(1.0)).build().expect("legal"), 500.0, 0.002);
    let contact = &case.solution.contacts()[0];
    for x in [0.0, 0.2, -0.5, 0.99, 1.0, 1.01, 3.0, -100.0] {
        for depth in [0.0, 1e-9, 1e-3, 0.3, 0.786, 1.0, 5.0, 200.0] {
            let (x, depth) = (x * contact.half_length().unwrap(), depth * contact.half_length().unwrap());
            let found = case.field.at(x, depth).expect("inside");
            let expected = crate::closed_forms::mcewen::stresses(
                contact.half_length().unwrap(),
                contact.central_pressure,
                x,
                depth,
            );
            for (found, expected) in [found.sigma_xx, found.sigma_yy, found.sigma_xy].into_iter().zip(expected) {
                close(found, expected, 1e-12 * contact.central_pressure, &format!("x = {x}, depth = {depth}"));
            }
        }
    }
    let max = case.field.max_shear().expect("found");
    close(max.value, 0.300_283_106_1 * contact.central_pressure, 1e-8 * max.value, "largest shear");
    close(max.depth, 0.786_152_2 * contact.half_length().unwrap(), 1e-5, "its depth");
}

#[test]
fn faces_carry_the_pressures_and_no_shear() {
    for case in cases() {
        let mut top = 1;
        for (i, contact) in case.solution.contacts().iter().enumerate() {
            let layers = match contact.interface {
                recede::Interface::Punch => vec![top],
                recede::Interface::Between { above, below } => vec![above, below],
            };
            top = top.max(*layers.last().expect("one"));
            for layer in layers {
                let Some((_, [from, to])) = case.field.layers().find(|(number, _)| *number == layer) else { continue };
                let depth = if i > 0 && layer != top { to } else { from };
                for s in [0.0, 0.3, 0.77, 0.95, 0.999, 1.0, 1.001, 1.3, 4.0] {
                    let x = s * contact.half_length().unwrap();
                    let point = case.field.at_layer(x, depth, layer).expect("there");
                    let what = format!("{}, contact {}, layer {layer}, x/a = {s}", case.name, contact.interface);
                    close(point.sigma_yy, -contact.pressure(x), ON_FACE * case.peak(), &what);
                    close(point.sigma_xy, 0.0, ON_FACE * case.peak(), &what);
                }
            }
        }
    }
}

#[test]
fn every_cut_carries_the_force() {
    let rule = recede::numeric::quadrature::rule(48);
    for case in cases() {
        let free: f64 = case.stack.laminates().iter().map(|laminate| laminate.thickness()).sum();
        for (_, [from, to]) in case.field.layers() {
            let to = if to.is_finite() { to } else { from + 2.0 };
            let depth = from + 0.45 * (to - from);
            let far = FAR[usize::from(depth < free)];
            // in a half-plane σ_yy falls like x⁻⁴, and what lies beyond the last place is a third of x σ_yy there
            let (mut edge, mut width) = (0.0, 0.25);
            let (mut xs, mut weights) = (Vec::new(), Vec::new());
            while edge < far {
                let (nodes, shares): (Vec<f64>, Vec<f64>) = rule.on(edge, edge + width).unzip();
                xs.extend(nodes);
                weights.extend(shares);
                edge += width;
                width *= if edge >= 4.0 { 2.0 } else { 1.0 };
            }
            xs.push(edge);
            weights.push(edge / 3.0);
            let grid = case.field.grid(&xs, &[depth]).expect("inside");
            let sum: f64 = grid.points().iter().zip(weights).map(|(point, weight)| weight * point.sigma_yy).sum();
            let force = case.solution.contacts()[0].resultant;
            close(-2.0 * sum, force, 1e-8 * force, &format!("{}, depth {depth}", case.name));
        }
    }
}

#[test]
fn bonded_layers_move_and_pull_together() {
    for case in cases() {
        let layers: Vec<(usize, [f64; 2])> = case.field.layers().collect();
        let bonded = |above: usize, below: usize| {
            let receding = recede::Interface::Between { above, below };
            case.solution.contacts().iter().all(|contact| contact.interface != receding)
        };
        for pair in layers.windows(2).filter(|pair| bonded(pair[0].0, pair[1].0)) {
            let depth = pair[0].1[1];
            for x in [0.0, 0.1, 0.6, 1.1, 2.5, 7.0] {
                let [above, below] =
                    [pair[0].0, pair[1].0].map(|layer| case.field.at_layer(x, depth, layer).expect("there"));
                let what = format!("{}, depth {depth}, x = {x}", case.name);
                let tolerance = INSIDE * case.peak();
                close(above.sigma_yy, below.sigma_yy, tolerance, &what);
                close(above.sigma_xy, below.sigma_xy, tolerance, &what);
                close(above.u, below.u, tolerance, &what);
                close(above.v, below.v, tolerance, &what);
            }
        }
    }
}

#[test]
fn bodies_touch_inside_the_contacts() {
    for case in cases() {
        for contact in case.solution.contacts() {
            let recede::Interface::Between { above, below } = contact.interface else { continue };
            let depth = case.field.layers().find(|(number, _)| *number == above).expect("there").1[1];
            for s in [0.0, 0.2, 0.5, 0.8, 0.97] {
                let x = s * contact.half_length().unwrap();
                let upper = case.field.at_layer(x, depth, above).expect("there").v;
                // a rigid base does not move
                let lower = case.field.at_layer(x, depth, below).map_or(0.0, |point| point.v);
                close(upper, lower, ON_FACE * case.peak(), &format!("{}, {}, x = {x}", case.name, contact.interface));
            }
            let x = 1.5 * contact.half_length().unwrap();
            let upper = case.field.at_layer(x, depth, above).expect("there").v;
            let lower = case.field.at_layer(x, depth, below).map_or(0.0, |point| point.v);
            assert!(upper > lower, "{}: the gap at {} is open", case.name, contact.interface);
        }
        // the top face takes the shape of the punch
        let contact = &case.solution.contacts()[0];
        let [centre, off] =
            [0.0, 0.6 * contact.half_length().unwrap()].map(|x| case.field.at(x, 0.0).expect("there").v);
        let radius = match case.name {
            "coating" => 50.0,
            "three contacts" => 300.0,
            "bonded to rigid base" => 100.0,
            _ => 500.0,
        };
        let shape = (0.6 * contact.half_length().unwrap()).powi(2) / (2.0 * radius);
        close(off - centre, shape, ON_FACE * case.peak(), case.name);
    }
}

/// Central differences of fourth order, from values at −2, −1, 1, 2 steps.
/// Fields of a graded half-plane are powers of the longest waves, which bend a layer that lies on it by more digits than they squeeze it by.
#[test]
fn displacements_over_a_graded_half_plane_tend_to_those_over_a_homogeneous_one() {
    let sunk = |base: &str| {
        let text = format!(
            "Scene(geometry: PlaneStrain, punch: Cylinder(radius: 100), force: 0.1, stack: [
                Homogeneous(thickness: 2, shear_modulus: 3, poisson: 0.3), Bonded,
                Homogeneous(thickness: 30, shear_modulus: 1, poisson: 0.3), Receding, {base}])"
        );
        let scene = recede::Scene::from_ron(&text).unwrap();
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let solution = model.press(&scene.top, scene.force).unwrap();
        model.field(&solution).unwrap().at(0.0, 0.0).unwrap().v
    };
    let plain = sunk("HalfPlane(shear_modulus: 0.4, poisson: 0.3)");
    for beta in [1e-8, 1e-7, 1e-6] {
        let found = sunk(&format!("GradedHalfPlane(shear_modulus: 0.4, poisson: 0.3, beta: {beta:e})"));
        close(found, plain, 100.0 * beta * plain.abs(), &format!("beta {beta:e}"));
    }
}

fn slope<'a>(values: &'a [FieldPoint], step: f64) -> impl Fn(fn(&FieldPoint) -> f64) -> f64 + 'a {
    move |pick| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| pick(&values[k]));
        (a - 8.0 * b + 8.0 * c - d) / (12.0 * step)
    }
}

#[test]
fn fields_are_in_equilibrium_and_obey_hooke() {
    let step = 1e-3;
    for case in cases() {
        let plane = case.stack.plane();
        for (number, [from, to]) in case.field.layers() {
            let placed =
                case.stack.laminates().iter().flat_map(|laminate| laminate.layers()).chain(case.stack.base().layers());
            let layer: Option<&dyn Layer> =
                placed.into_iter().find(|placed| placed.number == number).map(|placed| &*placed.layer);
            let to = if to.is_finite() { to } else { from + 2.0 };
            for part in [0.03, 0.4, 0.93] {
                for x in [0.15, 0.8, 3.0] {
                    let depth = from + part * (to - from);
                    let point = |x, depth| Point { x, depth, layer: Some(number) };
                    let steps = [-2.0, -1.0, 1.0, 2.0].map(|k| k * step);
                    let beside = steps.map(|step| point(x + step, depth));
                    let below = steps.map(|step| point(x, depth + step));
                    let points =
                        case.field.points(&[&beside[..], &below, &[point(x, depth)]].concat()).expect("inside");
                    let (along, across) = (slope(&points[..4], step), slope(&points[4..8], step));
                    let what = format!("{}, layer {number}, depth {depth}, x = {x}", case.name);
                    // y points upwards, depth downwards
                    let tolerance = 1e-6 * case.peak();
                    close(along(|p| p.sigma_xx), across(|p| p.sigma_xy), tolerance, &what);
                    close(along(|p| p.sigma_xy), across(|p| p.sigma_yy), tolerance, &what);
                    let Some(layer) = layer else { continue };
                    let material = layer.material(depth - from, plane);
                    let point = points[8];
                    let stretch = along(|p| p.u) * material.axial_stiffness + material.coupling * point.sigma_yy;
                    close(point.sigma_xx, stretch, tolerance * material.axial_stiffness.max(1.0), &what);
                    let shear = along(|p| p.v) - across(|p| p.u);
                    close(point.sigma_xy * material.shear_compliance, shear, tolerance, &what);
                }
            }
        }
    }
}

#[test]
fn a_grid_is_made_of_points() {
    for case in cases() {
        let xs = [-2.0, -0.3, 0.0, 0.3, 1.7];
        let depths = [0.0, 0.21, 0.9];
        let grid = case.field.grid(&xs, &depths).expect("inside");
        for (row, depth) in grid.rows().zip(depths) {
            for (point, x) in row.iter().zip(xs) {
                let alone = case.field.at(x, depth).expect("inside");
                let tolerance = 1e-9 * case.peak();
                close(point.sigma_xx, alone.sigma_xx, tolerance, case.name);
                close(point.sigma_yy, alone.sigma_yy, tolerance, case.name);
                close(point.sigma_xy, alone.sigma_xy, tolerance, case.name);
                close(point.u, alone.u, tolerance, case.name);
                close(point.v, alone.v, tolerance, case.name);
                assert_eq!((point.x, point.layer), (alone.x, alone.layer));
            }
        }
    }
}

#[test]
fn on_faces_stresses_are_the_limits_from_inside_whatever_the_layer() {
    for entry in std::fs::read_dir("examples/scenes").expect("a folder") {
        let path = entry.expect("a file").path();
        let scene = Scene::read(&path).expect("legal");
        let model = Model::new(scene.stack().expect("legal")).expect("resolved");
        let solution = model.press(&scene.top, scene.force).expect("solved");
        let field = model.field(&solution).unwrap();
        // a line load has no length, and stresses under it are infinite
        let lengths = solution.contacts().iter().map(recede::Contact::reach).filter(|a| *a > 0.0);
        let shortest = lengths.fold(f64::INFINITY, f64::min);
        let peak = solution.contacts().iter().map(|contact| contact.pressure(0.2 * shortest)).fold(0.0, f64::max);
        for (number, [from, to]) in field.layers() {
            let faces = [(from, 1.0), (to, -1.0)];
            for (face, inwards) in faces.into_iter().filter(|(face, _)| face.is_finite()) {
                let step = 5e-3 * shortest.min(to - from) * inwards;
                let at = |k: i32| field.at_layer(0.2 * shortest, face + f64::from(k) * step, number).expect("inside");
                let inside = [1, 2, 3, 4, 5, 6].map(at);
                // Lagrange's polynomial of the fifth degree at the face
                let limit = |pick: fn(&FieldPoint) -> f64| -> f64 {
                    [6.0, -15.0, 20.0, -15.0, 6.0, -1.0].iter().zip(&inside).map(|(share, p)| share * pick(p)).sum()
                };
                let what = format!("{}, layer {number}, depth {face}", path.display());
                let on_face = at(0);
                close(on_face.sigma_xx, limit(|p| p.sigma_xx), ON_FACE * peak, &what);
                close(on_face.sigma_yy, limit(|p| p.sigma_yy), ON_FACE * peak, &what);
                close(on_face.sigma_xy, limit(|p| p.sigma_xy), ON_FACE * peak, &what);
            }
        }
    }
}

#[test]
fn nowhere_is_the_shear_stress_larger_than_the_largest() {
    for case in cases() {
        let found = case.field.max_shear().expect("found");
        let there = case.field.at_layer(found.x, found.depth, found.layer).expect("inside");
        close(there.max_shear(), found.value, 1e-6 * found.value, &format!("{}, at {found:?}", case.name));
        let longest =
            case.solution.contacts().iter().fold(0.0, |a: f64, contact| a.max(contact.half_length().unwrap()));
        let xs: Vec<f64> = (0..40).map(|k| 0.04 * f64::from(k) * longest).collect();
        let bottom = case.field.layers().fold(longest, |d, (_, [_, to])| if to.is_finite() { to } else { d.max(2.0) });
        let depths: Vec<f64> = (0..=60).map(|k| f64::from(k) / 60.0 * bottom).collect();
        for point in case.field.by_layer(&xs, &depths).expect("inside").iter().flat_map(|grid| grid.points()) {
            let value = point.max_shear();
            assert!(value <= found.value * (1.0 + 1e-6), "{}: {found:?}, but {value} at {point:?}", case.name);
        }
    }
}

#[test]
fn places_that_are_not_there_are_refused() {
    let scene = Scene::read("examples/scenes/strip_on_rigid.ron").expect("legal");
    let model = Model::new(scene.stack().expect("legal")).expect("resolved");
    let field = model.field(&model.press(&scene.top, scene.force).expect("solved")).expect("its own");
    for (x, depth, layer) in
        [(0.0, 1.1, None), (0.0, -0.1, None), (f64::NAN, 0.5, None), (0.0, 0.5, Some(2)), (0.0, 1.0, Some(0))]
    {
        let error = field.points(&[Point { x, depth, layer }]).expect_err("nothing there");
        assert!(error.is_input() && error.to_string().contains("layer 1 from 0.0 to 1.0"), "{error}");
    }
}
