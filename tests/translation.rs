//! Nothing depends on where on x all that presses is.
//!
//! Goal: one punch or load that is symmetric about another place than x = 0 has the half-lengths, pressures, errors, warnings, approach, stiffness and fields that it
//! has at x = 0, at places that are moved with it.
//!
//! Source of the numbers: the same solver at x = 0.
use recede::{
    Force, HalfPlane, Homogeneous, Load, Loads, Model, Options, Plane, Pressed, Punch, Punches, Scene, Solution, Stack,
    Stiffness, Sweep, Tilt, Top, profile_places, report::SweepCsv,
};

const FORCE: f64 = 3e-3;
const PLACES: [f64; 3] = [-0.7, 30.0, 1000.0];

fn loose(base: fn(recede::StackBuilder) -> recede::StackBuilder) -> Model {
    let strip = Homogeneous::new(1.0, 1.0, 0.25).unwrap();
    Model::new(base(Stack::builder(Plane::Strain).layer(strip).receding()).build().unwrap()).unwrap()
}

fn on_half_plane() -> Model {
    loose(|stack| stack.layer(HalfPlane::new(0.5, 0.3).unwrap()))
}

fn on_rigid_base() -> Model {
    loose(|stack| stack.rigid())
}

fn punches() -> [Punch; 5] {
    [
        Punch::parabola(60.0).unwrap(),
        Punch::power(1.5, 1.0, 0.02).unwrap(),
        Punch::wedge(0.01).unwrap(),
        Punch::flat(0.4).unwrap(),
        Punch::rounded_flat(0.3, 40.0).unwrap(),
    ]
}

fn punch_at(punch: &Punch, at: f64) -> Top {
    Punches::new(&[Pressed::new(punch.clone(), at, FORCE, Tilt::None).unwrap()]).unwrap().into()
}

fn load_at(load: &Load, at: f64) -> Top {
    Loads::new(&[(load.clone(), at, FORCE)]).unwrap().into()
}

/// All that is symmetric, at x = 0 and at a place.
fn pairs(at: f64) -> Vec<[Top; 2]> {
    let punches = punches().map(|punch| [0.0, at].map(|at| punch_at(&punch, at)));
    let loads = [Load::Line, Load::uniform(0.3).unwrap(), Load::elliptic(0.2).unwrap()];
    punches.into_iter().chain(loads.map(|load| [0.0, at].map(|at| load_at(&load, at)))).collect()
}

/// Whether two numbers are one, or differ by rounding at a place.
fn is_near(one: f64, other: f64, size: f64) -> bool {
    one == other || (one - other).abs() <= size
}

#[test]
fn contacts_and_their_errors_move_with_what_presses() {
    let model = on_half_plane();
    for tolerance in [1e-10, 1e-3] {
        for at in PLACES {
            for tops in pairs(at) {
                let press = |top: &Top| model.press_with(top, FORCE, &Options { tolerance }).unwrap();
                let [here, there] = [&tops[0], &tops[1]].map(press);
                let rounding = 8.0 * f64::EPSILON * at.abs();
                assert_eq!(here.warnings(), there.warnings(), "{}", tops[1]);
                for (here, there) in here.contacts().iter().zip(there.contacts()) {
                    let what = format!("{} at {at} to {tolerance:e}", here.interface);
                    let lengths = [here, there].map(|contact| contact.half_length().expect("one interval"));
                    assert!(is_near(lengths[0], lengths[1], rounding), "{what}: {lengths:?}");
                    let [own, moved] = [here, there].map(recede::Contact::peak);
                    assert!(is_near(own.pressure, moved.pressure, 1e-9 * own.pressure), "{what}: {own:?} {moved:?}");
                    assert!(is_near(own.x, moved.x - at, 1e-4 + own.x_error), "{what}: {own:?} {moved:?}");
                    assert!(is_near(own.error, moved.error, 0.1 * own.error), "{what}: {own:?} {moved:?}");
                }
            }
        }
    }
}

#[test]
fn approach_and_stiffness_do_too() {
    let model = on_rigid_base();
    for at in PLACES {
        for punch in punches() {
            let approach = |at: f64| {
                let top = punch_at(&punch, at);
                model.approach(&top, &model.press(&top, FORCE).unwrap()).unwrap()
            };
            let [here, there] = [0.0, at].map(approach);
            assert!(is_near(here.value, there.value, here.error), "{punch} at {at}: {here:?} {there:?}");
            assert!(is_near(here.error, there.error, 0.1 * here.error), "{punch} at {at}: {here:?} {there:?}");
            let [Stiffness::Known { value, error }, Stiffness::Known { value: moved, .. }] =
                [here.stiffness, there.stiffness]
            else {
                panic!("{punch} at {at}: {here:?} {there:?}")
            };
            assert!(is_near(value, moved, error), "{punch} at {at}: {value} {moved}");
        }
    }
}

#[test]
fn the_force_of_a_half_length_or_a_depth_is_the_same_anywhere() {
    let model = on_rigid_base();
    let punch = Punch::parabola(60.0).unwrap();
    for drive in [Force::ForHalfLength(0.3), Force::ForDepth(1e-3)] {
        let [here, there] = [0.0, 30.0].map(|at| model.press(punch_at(&punch, at), drive).unwrap());
        let allowed = here.force_error() + there.force_error();
        assert!(is_near(here.force(), there.force(), allowed), "{drive:?}: {} {}", here.force(), there.force());
    }
}

#[test]
fn fields_and_profiles_do_too() {
    let model = on_half_plane();
    for at in [PLACES[0], PLACES[1], 1e5] {
        for tops in pairs(at) {
            let [here, there]: [Solution; 2] = [&tops[0], &tops[1]].map(|top| model.press(top, FORCE).unwrap());
            let fields = [&here, &there].map(|solution| model.field(solution).unwrap());
            for (x, depth) in [(0.3, 0.2), (-0.9, 0.6), (1.7, 1.3)] {
                // displacements are counted from x = 0: those at a place that moves along are taken away
                let beside = |field: &recede::Field, at: f64| {
                    let from = if depth < 1.0 { (0.4, 0.7) } else { (0.4, 1.1) };
                    let [point, from] = [(x, depth), from].map(|(x, depth)| field.at(at + x, depth).unwrap());
                    [point.sigma_xx, point.sigma_yy, point.sigma_xy, point.u - from.u, point.v - from.v, point.slope]
                };
                let [own, moved] = [(&fields[0], 0.0), (&fields[1], at)].map(|(field, at)| beside(field, at));
                let largest = own.iter().fold(0.0, |size: f64, one| size.max(one.abs()));
                for (own, moved) in own.into_iter().zip(moved) {
                    let allowed = largest * (1e-9 + 1e-14 * at.abs());
                    assert!(is_near(own, moved, allowed), "{} ({x}, {depth}): {own} {moved}", tops[1]);
                }
            }
            let [own, moved] = fields.each_ref().map(|field| field.max_shear().unwrap());
            assert!(is_near(own.value, moved.value, 1e-6 * own.value), "{}: {own:?} {moved:?}", tops[1]);
            assert!(is_near(own.x, moved.x - at, 2e-2) && is_near(own.depth, moved.depth, 2e-2), "{own:?} {moved:?}");
            let stresses = |field: &recede::Field| {
                let extremes = field.extremes().unwrap();
                let layers = extremes.layers.iter().filter_map(|layer| layer.von_mises);
                layers.chain(extremes.tension).map(|found| (found.value, found.x)).collect::<Vec<_>>()
            };
            for ((value, x), (moved, place)) in stresses(&fields[0]).into_iter().zip(stresses(&fields[1])) {
                assert!(is_near(value, moved, 1e-6 * value), "{}: {value} {moved}", tops[1]);
                assert!(is_near(x, place - at, 2e-2), "{}: {x} {place}", tops[1]);
            }
            let [own, moved] = [&here, &there].map(|solution| profile_places(solution, None, 40));
            assert_eq!(own.len(), moved.len());
            assert!(own.iter().zip(&moved).all(|(own, moved)| is_near(*own, moved - at, 1e-13 * (1.0 + at.abs()))));
        }
    }
}

#[test]
fn where_a_punch_is_does_not_matter_to_the_limits_of_linear_elasticity() {
    let long = punch_at(&Punch::parabola(0.01).unwrap(), 0.0);
    let codes = |top: &Top| -> Vec<String> {
        let solution = on_half_plane().press(top, Force::Given(0.03)).unwrap();
        solution.warnings().iter().map(|warning| warning.message.clone()).collect()
    };
    let expected = codes(&long);
    assert!(expected.iter().any(|message| message.contains("is long")), "{expected:?}");
    assert_eq!(codes(&punch_at(&Punch::parabola(0.01).unwrap(), 5.0)), expected);
    let two = [-20.0, 20.0].map(|at| Pressed::new(Punch::parabola(0.01).unwrap(), at, 0.015, Tilt::None).unwrap());
    let both = codes(&Punches::new(&two).unwrap().into());
    assert!(["punch 1", "punch 2"].iter().all(|name| both.iter().any(|message| message.contains(name))), "{both:?}");
}

#[test]
fn columns_of_a_sweep_have_one_name_each() {
    let scene = "Scene(geometry: PlaneStrain, punch: Wedge(left: 0.01, slope: 0.02), force: 0.001, stack: [
        Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, Rigid])";
    let sweep = Sweep::new(Scene::from_ron(scene).unwrap(), vec!["punch.left=[0.01, 0.02]".parse().unwrap()]).unwrap();
    let header = SweepCsv::new(&sweep).header().unwrap();
    let mut names: Vec<&str> = header.trim_end().split(',').collect();
    let count = names.len();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), count, "{header}");
    assert!(header.starts_with("varied_punch_left,"), "{header}");
}
