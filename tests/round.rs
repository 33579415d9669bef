//! Axisymmetric problems: contacts of the references.
use recede::selftest::{CheckedScene, Ranges, about_axis, scene_of_any_kind};
use recede::{Geometry, HalfPlane, Homogeneous, Model, Options, Punch, Scene, Solution, Stack};

/// A layer on a half-space, k = (μ₁/(1 − ν₁))/(μ₂/(1 − ν₂)).
fn layer_on_half_space(k: f64) -> Stack {
    let stack = Stack::builder(Geometry::Axisymmetric).layer(Homogeneous::new(1.0, 1.0, 0.3).unwrap()).receding();
    match k {
        0.0 => stack.rigid().build().unwrap(),
        k => stack.layer(HalfPlane::new(1.0 / k * 0.8 / 0.7, 0.2).unwrap()).build().unwrap(),
    }
}

fn press(stack: Stack, punch: impl Into<recede::Top>, force: f64) -> Solution {
    Model::new(stack).unwrap().press(punch, force).unwrap()
}

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} {expected}");
}

#[test]
fn hertz() {
    let stack = || Stack::builder(Geometry::Axisymmetric).layer(HalfPlane::new(3.0, 0.3).unwrap()).build().unwrap();
    let modulus = 2.0 * 3.0 / 0.7;
    let (radius, force) = (20.0, 0.01);
    let solution = press(stack(), Punch::parabola(radius).unwrap(), force);
    let a = f64::cbrt(0.75 * force * radius / modulus);
    let contact = &solution.contacts()[0];
    close(contact.reach(), a, 1e-12);
    close(contact.central_pressure, 1.5 * force / (std::f64::consts::PI * a * a), 1e-12);
    close(contact.pressure(0.6 * a), 0.8 * contact.central_pressure, 1e-12);
    close(contact.resultant, force, 1e-12);
    // Sneddon's cone: F = E* a² tan/2 ... F = π a² E* slope/2 · (1/2)·2
    let cone = press(stack(), Punch::wedge(0.1).unwrap(), force);
    let a = (2.0 * force / (std::f64::consts::PI * modulus * 0.1)).sqrt();
    close(cone.contacts()[0].reach(), a, 1e-10);
    close(cone.contacts()[0].pressure(0.3 * a), 0.5 * modulus * 0.1 * (1.0f64 / 0.3).acosh(), 1e-10);
    let flat = press(stack(), Punch::flat(0.5).unwrap(), force);
    close(flat.contacts()[0].central_pressure, force / (2.0 * std::f64::consts::PI * 0.25), 1e-12);
    close(flat.contacts()[0].pressure(0.3), force / (2.0 * std::f64::consts::PI * 0.25 * 0.8), 1e-12);
}

#[test]
fn a_point_load_on_a_loose_layer() {
    for (k, radius) in [
        (0.0, 1.09328978774),
        (0.25, 1.27434828968),
        (0.5, 1.44323920761),
        (1.0, 1.72654043897),
        (2.0, 2.12507092644),
        (4.0, 2.63447447412),
        (10.0, 3.5227551617),
    ] {
        let solution = press(layer_on_half_space(k), recede::Top::from(recede::Load::Line), 0.01);
        close(solution.contacts()[1].reach(), radius, 1e-10);
    }
}

#[test]
fn a_parabola_on_a_loose_layer() {
    for (k, phi, punch, receding) in [
        (1.0, 0.01, 0.155427678, 1.732918899),
        (1.0, 1.0, 0.738832418, 1.868274712),
        (1.0, 10.0, 1.657946935, 2.390366366),
        (0.0, 0.1, 0.333579184, 1.136893994),
        (4.0, 1.0, 0.79107067, 2.73998002),
    ] {
        // Φ = R F (1 − ν₁)/(μ₁h³)
        let solution = press(layer_on_half_space(k), Punch::parabola(100.0).unwrap(), phi / 70.0);
        close(solution.contacts()[0].reach(), punch, 1e-8);
        close(solution.contacts()[1].reach(), receding, 1e-8);
    }
}

/// The field of a solution.
fn field(stack: Stack, punch: impl Into<recede::Top>, force: f64) -> recede::Field {
    let model = Model::new(stack).unwrap();
    let solution = model.press(punch, force).unwrap();
    model.field(&solution).unwrap()
}

fn half_space() -> Stack {
    Stack::builder(Geometry::Axisymmetric).layer(HalfPlane::new(3.0, 0.3).unwrap()).build().unwrap()
}

#[test]
fn stresses_on_the_axis_of_a_half_space() {
    let (shear, poisson, pi) = (3.0, 0.3, std::f64::consts::PI);
    // Boussinesq
    let point = field(half_space(), recede::Top::from(recede::Load::Line), 2.0);
    for (r, z) in [(0.0, 0.7), (0.5, 0.4), (2.0, 0.1)] {
        let found = point.at(r, z).unwrap();
        let distance = f64::hypot(r, z);
        close(found.sigma_yy, -3.0 * 2.0 / (2.0 * pi) * z.powi(3) / distance.powi(5), 1e-11);
        close(
            found.v,
            -2.0 / (4.0 * pi * shear) * (2.0 * (1.0 - poisson) / distance + z * z / distance.powi(3)),
            1e-11,
        );
        if r > 0.0 {
            let inside = r * z / distance.powi(3) - (1.0 - 2.0 * poisson) * r / (distance * (distance + z));
            close(found.u, 2.0 / (4.0 * pi * shear) * inside, 1e-10);
            let hoop =
                (1.0 - 2.0 * poisson) * 2.0 / (2.0 * pi) * (z / distance.powi(3) - 1.0 / (distance * (distance + z)));
            close(found.sigma_zz, hoop, 1e-9);
            let radial = 2.0 / (2.0 * pi)
                * ((1.0 - 2.0 * poisson) / (distance * (distance + z)) - 3.0 * r * r * z / distance.powi(5));
            close(found.sigma_xx, radial, 1e-9);
        }
    }
    // a uniform disc: u_z(0) = 2 (1 − ν²) q a/E, and on the axis
    let (q, a) = (0.4, 0.8);
    let disc = field(half_space(), recede::Top::from(recede::Load::uniform(a).unwrap()), q * pi * a * a);
    close(-disc.at(0.0, 0.0).unwrap().v, (1.0 - poisson) * q * a / shear, 1e-12);
    for z in [0.1, 0.8, 3.0] {
        let found = disc.at(0.0, z).unwrap();
        let cos = z / f64::hypot(z, a);
        close(found.sigma_yy, -q * (1.0 - cos.powi(3)), 1e-11);
        let radial = -0.5 * q * (1.0 + 2.0 * poisson - 2.0 * (1.0 + poisson) * cos + cos.powi(3));
        assert!((found.sigma_xx - radial).abs() < 1e-11 * q && (found.sigma_zz - radial).abs() < 1e-11 * q);
    }
    // a flat punch: −F/2π (a² + 3z²)/(a² + z²)²
    let (force, a) = (0.01, 0.5);
    let flat = field(half_space(), Punch::flat(a).unwrap(), force);
    // a cone: p = ½ E* slope arcosh(a/r), a² = 2F/(πE* slope)
    let (slope, modulus) = (0.1, 2.0 * shear / (1.0 - poisson));
    let cone = field(half_space(), Punch::wedge(slope).unwrap(), force);
    let b = (2.0 * force / (pi * modulus * slope)).sqrt();
    for z in [0.1, 0.5, 2.0] {
        let (x, y) = (a * a + z * z * a * a, 1.0 + 3.0 * z * z);
        close(flat.at(0.0, z * a).unwrap().sigma_yy, -force / (2.0 * pi) * a * a * y / (x * x), 1e-10);
        let across = -0.5 * modulus * slope * (0.5 * (1.0 + 1.0 / (z * z)).ln() + 1.0 / (1.0 + z * z));
        close(cone.at(0.0, z * b).unwrap().sigma_yy, across, 1e-10);
    }
    // Hertz
    let sphere = field(half_space(), Punch::parabola(20.0).unwrap(), 0.01);
    let a = f64::cbrt(0.75 * 0.01 * 20.0 * 0.7 / 6.0);
    let peak = 1.5 * 0.01 / (pi * a * a);
    for z in [0.2, 0.48, 2.0] {
        let found = sphere.at(0.0, z * a).unwrap();
        let across = -peak / (1.0 + z * z);
        close(found.sigma_yy, across, 1e-11);
        let radial = -peak * ((1.0 + poisson) * (1.0 - z * (1.0 / z).atan()) - 0.5 / (1.0 + z * z));
        close(found.sigma_xx, radial, 1e-10);
    }
}

fn ring(radius: f64, half_width: f64) -> recede::Top {
    let text = format!(
        "Scene(geometry: Axisymmetric, load: Ring(radius: {radius}, half_width: {half_width}), force: 1,
            stack: [HalfPlane(shear_modulus: 1, poisson: 0.3)])"
    );
    Scene::from_ron(&text).unwrap().top
}

/// On a half-space and on a layer; a ring that is as wide as it can be is a disc, and one that is small is a point.
#[test]
fn a_ring_is_the_difference_of_two_discs() {
    let (q, outer, inner) = (0.4, 0.8, 0.5);
    let area = |radius: f64| std::f64::consts::PI * radius * radius;
    let disc = |radius: f64| recede::Top::from(recede::Load::uniform(radius).unwrap());
    let bonded = || {
        let layer = Homogeneous::new(0.6, 1.0, 0.3).unwrap();
        Stack::builder(Geometry::Axisymmetric)
            .layer(layer)
            .bonded()
            .layer(HalfPlane::new(4.0, 0.2).unwrap())
            .build()
            .unwrap()
    };
    for stack in [half_space, bonded] {
        let whole = field(stack(), ring(0.65, 0.15), q * (area(outer) - area(inner)));
        let [more, less] = [outer, inner].map(|radius| field(stack(), disc(radius), q * area(radius)));
        for (r, depth) in [(0.0, 0.0), (0.3, 0.0), (0.6, 0.0), (1.3, 0.0), (0.0, 0.4), (0.7, 0.1), (2.0, 0.9)] {
            let image = whole.at(-r, depth).unwrap();
            let [whole, more, less] = [&whole, &more, &less].map(|field| field.at(r, depth).unwrap());
            assert_eq!((image.sigma_xx, image.sigma_zz, image.u), (whole.sigma_xx, whole.sigma_zz, -whole.u + 0.0));
            for (whole, more, less) in [
                (whole.sigma_xx, more.sigma_xx, less.sigma_xx),
                (whole.sigma_yy, more.sigma_yy, less.sigma_yy),
                (whole.sigma_xy, more.sigma_xy, less.sigma_xy),
                (whole.sigma_zz, more.sigma_zz, less.sigma_zz),
                (whole.u, more.u, less.u),
                (whole.v, more.v, less.v),
            ] {
                assert!((whole - (more - less)).abs() < 1e-9 * q, "{r} {depth}: {whole} {more} {less}");
            }
        }
    }
    // (1 − ν) q (b − a)/μ under the middle
    let middle = field(half_space(), ring(0.65, 0.15), q * (area(outer) - area(inner))).at(0.0, 0.0).unwrap();
    close(-middle.v, 0.7 * q * (outer - inner) / 3.0, 1e-12);
    let radius = |punch: &recede::Top| press(layer_on_half_space(1.0), punch, 0.01).contacts()[1].reach();
    close(radius(&ring(0.4, 0.5)), radius(&disc(0.9)), 1e-12);
    close(radius(&ring(1e-4, 4e-5)), 1.72654043897, 1e-7);
    // next to a narrow ring as next to a strip: a largest shear stress of 1/π of the pressure
    let narrow = field(half_space(), ring(1.0, 1e-3), 4e-3 * std::f64::consts::PI).max_shear().unwrap();
    close(narrow.value, std::f64::consts::FRAC_1_PI, 1e-3);
    let solution = press(half_space(), ring(0.65, 0.15), 2.0);
    let load = &solution.contacts()[0];
    close(load.peak().pressure, 2.0 / (area(0.8) - area(0.5)), 1e-12);
    assert_eq!((load.central_pressure, load.resultant), (0.0, 2.0));
    assert!(load.pressure(0.2).abs() < 1e-15);
}

#[test]
fn what_is_no_ring_is_refused() {
    let model = Model::new(half_space()).unwrap();
    let line = crate::support::mirrored(&[(0.4, 1.0, recede::Load::Line)]).unwrap();
    for punch in [ring(1.0, 1e-5), recede::Top::from(line)] {
        let error = model.press(&punch, 1.0).unwrap_err();
        assert!(error.is_input() && error.hint().unwrap().contains("`Ring`"), "{error}");
    }
}

#[test]
fn faces_carry_the_pressures() {
    let model = Model::new(layer_on_half_space(1.0)).unwrap();
    let solution = model.press(Punch::parabola(100.0).unwrap(), 1.0 / 70.0).unwrap();
    let field = model.field(&solution).unwrap();
    let contacts = solution.contacts();
    for r in [0.0, 0.3, 0.7, 1.0, 1.8, 2.5] {
        let top = field.at(r, 0.0).unwrap();
        let [above, below] = [1, 2].map(|layer| field.at_layer(r, 1.0, layer).unwrap());
        for (point, contact) in [(top, 0), (above, 1), (below, 1)] {
            let error = (point.sigma_yy + contacts[contact].pressure(r)).abs();
            assert!(error < 1e-8 * contacts[0].central_pressure && point.sigma_xy.abs() < 1e-9, "{r} {point:?}");
        }
        // the faces touch inside the contact
        let gap = below.v - above.v;
        assert!(if r < 1.868 { gap.abs() < 1e-10 } else { gap < -1e-5 }, "{r}: {gap}");
    }
}

#[test]
fn pavements() {
    let load = |radius: f64| recede::Top::from(recede::Load::uniform(radius).unwrap());
    let layer = |h: f64, young: f64, nu: f64| {
        let constants = recede::Isotropic::from_young(young, nu).unwrap();
        Homogeneous::new(h, constants.shear_modulus, nu).unwrap()
    };
    let ground = |young: f64, nu: f64| HalfPlane::new(young / (2.0 * (1.0 + nu)), nu).unwrap();
    let stack = || Stack::builder(Geometry::Axisymmetric);
    let first = stack().layer(layer(150.0, 3000.0, 0.3)).bonded().layer(layer(600.0, 200.0, 0.35)).bonded();
    let pi = std::f64::consts::PI;
    let field_a = field(first.layer(ground(40.0, 0.4)).build().unwrap(), load(150.0), 1.1 * pi * 150.0 * 150.0);
    close(-field_a.at_layer(0.0, 150.0, 1).unwrap().v, 1.023516022, 1e-8);
    close(field_a.at_layer(0.0, 150.0, 1).unwrap().sigma_xx, 1.676090355, 1e-8);
    close(field_a.at_layer(0.0, 150.0, 1).unwrap().sigma_yy, -0.275342805, 1e-8);
    close(-field_a.at(0.0, 500.0).unwrap().v, 0.7726923071, 1e-8);
    close(field_a.at(0.0, 500.0).unwrap().sigma_xx, 0.02326810783, 1e-7);
    close(-field_a.at(0.0, 1000.0).unwrap().v, 0.5777983464, 1e-8);
    close(field_a.at(0.0, 1000.0).unwrap().sigma_xx, 0.0004716630297, 1e-6);
    // strains across the layers
    let strain = |point: recede::FieldPoint, young: f64, nu: f64| {
        (point.sigma_yy - nu * (point.sigma_xx + point.sigma_zz)) / young
    };
    let force = 0.7 * pi * 150.8 * 150.8;
    for (sliding, top, base) in [(false, -2.516907015e-4, -1.8513004e-4), (true, -5.820430373e-7, -2.164667925e-4)] {
        let top_layer = stack().layer(layer(260.0, 5000.0, 0.35));
        let joined = if sliding { top_layer.sliding() } else { top_layer.bonded() };
        let stack = joined.layer(layer(500.0, 200.0, 0.4)).bonded().layer(ground(50.0, 0.45)).build().unwrap();
        let field = field(stack, load(150.8), force);
        close(strain(field.at_layer(0.0, 260.0, 2).unwrap(), 200.0, 0.4), top, 1e-7);
        close(strain(field.at_layer(0.0, 760.0, 3).unwrap(), 50.0, 0.45), base, 1e-7);
    }
}

fn layer_on_rigid(poisson: f64, sliding: bool) -> Stack {
    let stack = Stack::builder(Geometry::Axisymmetric).layer(Homogeneous::new(1.0, 1.0, poisson).unwrap());
    if sliding { stack.sliding().rigid().build().unwrap() } else { stack.bonded().rigid().build().unwrap() }
}

#[test]
fn stiffness_of_layers_under_flat_punches() {
    // F (1 − ν²)/(2 a E δ)
    for (poisson, sliding, values) in [
        (0.5, false, [(0.2, 1.280637), (1.0, 3.618736), (4.0, 31.52501), (8.0, 146.320434)]),
        (0.3, false, [(0.2, 1.206558), (1.0, 2.483525), (4.0, 8.178894), (8.0, 15.868369)]),
        (0.3, true, [(0.2, 1.171028), (1.0, 2.198621), (4.0, 6.853184), (8.0, 13.129309)]),
    ] {
        let model = Model::new(layer_on_rigid(poisson, sliding)).unwrap();
        for (a, expected) in values {
            let punch = Punch::flat(a).unwrap();
            let approach = model.approach(&punch, &model.press(&punch, 0.01).unwrap()).unwrap();
            let factor = (1.0 - poisson * poisson) / (2.0 * a * 2.0 * (1.0 + poisson));
            close(0.01 * factor / approach.value, expected, 1e-6);
            close(approach.stiffness.value().unwrap() * factor, expected, 1e-6);
        }
    }
}

#[test]
fn approach_of_parabolas_on_layers() {
    // δ R/h² and F R (1 − ν²)/(E h³)
    for (poisson, sliding, a, depth, load) in [
        (0.5, true, 1.0, 0.673980645, 1.5781227473),
        (0.5, true, 2.0, 2.3609221704, 17.8389560521),
        (0.5, false, 1.0, 0.5594154856, 1.8806668992),
        (0.5, false, 2.0, 1.8196112862, 27.7132898586),
    ] {
        let (model, punch) = (Model::new(layer_on_rigid(poisson, sliding)).unwrap(), Punch::parabola(100.0).unwrap());
        let force = load * 2.0 * (1.0 + poisson) / (1.0 - poisson * poisson) / 100.0;
        let solution = model.press(&punch, force).unwrap();
        close(solution.contacts()[0].reach(), a, 1e-9);
        close(model.approach(&punch, &solution).unwrap().value * 100.0, depth, 1e-9);
        let by_radius = model.press(&punch, recede::Force::ForHalfLength(a)).unwrap();
        close(by_radius.force(), force, 1e-8);
        let by_depth = model.press(&punch, recede::Force::ForDepth(depth / 100.0)).unwrap();
        close(by_depth.force(), force, 1e-8);
    }
}

#[test]
fn approach_over_a_half_space() {
    // Hertz: δ = a²/R, dF/dδ = 2 a E*
    let (model, punch) = (Model::new(half_space()).unwrap(), Punch::parabola(20.0).unwrap());
    let solution = model.press(&punch, 0.01).unwrap();
    let a = solution.contacts()[0].reach();
    let approach = model.approach(&punch, &solution).unwrap();
    close(approach.value, a * a / 20.0, 1e-11);
    close(approach.stiffness.value().unwrap(), 2.0 * a * 6.0 / 0.7, 1e-10);
    // of two equal spheres, one of them on the half-space of the other
    let punch = Punch::elastic_cylinder(2e5, 3.0, 0.3).unwrap();
    let solution = model.press(&punch, 0.01).unwrap();
    let a = solution.contacts()[0].reach();
    close(a, f64::cbrt(0.75 * 0.01 * 2e5 / (3.0 / 0.7)), 1e-9);
    let approach = model.approach(&punch, &solution).unwrap();
    close(approach.value, a * a / 2e5, 1e-8);
    close(approach.stiffness.value().unwrap(), 2.0 * a * 3.0 / 0.7, 1e-8);
}

#[test]
fn derivatives_of_forces_are_stiffnesses() {
    let (model, punch) = (Model::new(layer_on_half_space(1.0)).unwrap(), Punch::cylinder(100.0).unwrap());
    let of = |force: f64| model.approach(&punch, &model.press(&punch, force).unwrap()).unwrap();
    let (force, step) = (0.02, 1e-5);
    let difference = 2.0 * step / (of(force + step).value - of(force - step).value);
    close(of(force).stiffness.value().unwrap(), difference, 1e-6);
}

/// A layer that is stiffer along its faces than across them obeys equilibrium and Hooke's law.
#[test]
fn transversely_isotropic_layers() {
    let (young, [xy, xz, yz]) = ([4.0, 2.0, 4.0], [0.3, 0.25, 0.15]);
    let scene = Scene::from_ron(&format!(
        "Scene(geometry: Axisymmetric, punch: Parabola(radius: 10), force: 0.02, stack: [
            Orthotropic(thickness: 1, young: (x: 4, y: 2, z: 4), poisson: (xy: {xy}, xz: {xz}, yz: {yz}), shear_modulus: 0.5),
            Receding, HalfPlane(shear_modulus: 1, poisson: 0.3)])"
    ))
    .unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    let field = model.field(&solution).unwrap();
    let (r, depth, step) = (0.3, 0.4, 1e-3);
    let at = |r: f64, depth: f64| field.at(r, depth).unwrap();
    let slope = |f: &dyn Fn(f64) -> f64| (8.0 * (f(step) - f(-step)) - f(2.0 * step) + f(-2.0 * step)) / (12.0 * step);
    let here = at(r, depth);
    // σ_xy of y upwards
    let along_r = slope(&|d| at(r + d, depth).sigma_xx) + (here.sigma_xx - here.sigma_zz) / r;
    let rest = along_r - slope(&|d| at(r, depth + d).sigma_xy);
    let along_z = slope(&|d| at(r + d, depth).sigma_xy) + here.sigma_xy / r - slope(&|d| at(r, depth + d).sigma_yy);
    let size = here.sigma_yy.abs();
    assert!(rest.abs() < 1e-8 * size && along_z.abs() < 1e-8 * size, "{rest:e} {along_z:e} {size}");
    let [ex, ey, ez] = young;
    let [radial, hoop, across] = [here.eps_xx, here.eps_zz, here.eps_yy];
    let (rr, tt, zz) = (here.sigma_xx, here.sigma_zz, here.sigma_yy);
    close(radial, rr / ex - xz / ex * tt - xy / ex * zz, 1e-10);
    close(hoop, tt / ez - xz / ex * rr - yz / ey * zz, 1e-10);
    close(across, zz / ey - xy / ex * rr - yz / ey * tt, 1e-10);
    close(hoop, here.u / r, 1e-12);
    close(radial, slope(&|d| at(r + d, depth).u), 1e-8);
}

/// Random plane scenes with the axisymmetric geometry, where that is legal: solved, reported, and their fields checked, or refused for a reason.
#[test]
fn random_twins_do_all_that_a_command_does() {
    let (mut solved, scenes) = (0, 24);
    for number in 0..scenes {
        let scene = about_axis(scene_of_any_kind(&Ranges::moderate(), 5, number).unwrap());
        let outcome = CheckedScene::run(&scene, &Options::default(), number % 16 == 0).outcome;
        assert!(!outcome.is_wrong(), "{number}: {}\n{}", outcome.reason(), scene.to_ron());
        solved += u64::from(outcome.solution().is_some());
    }
    assert!(10 * solved >= 8 * scenes, "{solved} of {scenes}");
}
