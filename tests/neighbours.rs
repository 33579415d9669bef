//! Punches beside each other.
//!
//! Goal: contacts under punches that are close neither meet nor overlap, and are refused where they would; each punch has an approach of its own, and the
//! gap between two punches is the one to the nearer.
use recede::{Error, HalfPlane, Homogeneous, Model, NoSolution, Plane, Pressed, Punch, Punches, Solution, Stack, Tilt};

/// A punch, its place, its force and its tilt.
type One = (Punch, f64, f64, Tilt);

fn punches(all: &[One]) -> Punches {
    let pressed = |(shape, at, force, tilt): &One| Pressed::new(shape.clone(), *at, *force, *tilt);
    Punches::new(&all.iter().map(pressed).collect::<Result<Vec<_>, _>>().unwrap()).unwrap()
}

fn press_punches(model: &Model, all: &[One]) -> Solution {
    let punches = punches(all);
    model.press(&punches, punches.force()).unwrap()
}

/// On a rigid base each punch has an approach: of two that are far apart each sinks like a punch by itself, and by as much as the field of the solution
/// tells wherever it touches.
#[test]
fn each_punch_has_an_approach() {
    let strip = Homogeneous::new(1.0, 1.0, 0.25).unwrap();
    let bonded = Stack::builder(Plane::Strain).layer(strip).bonded().rigid().build().unwrap();
    let model = Model::new(bonded).unwrap();
    let parabola = |radius: f64| Punch::parabola(radius).unwrap();
    let of = |model: &Model, all: &[One]| {
        let (solution, punches) = (press_punches(model, all), punches(all));
        let all = model.approaches(&punches, &solution).into_iter().map(Result::unwrap).collect::<Vec<_>>();
        (solution, all)
    };
    let (_, both) = of(&model, &[(parabola(100.0), -20.0, 2e-3, Tilt::None), (parabola(60.0), 20.0, 1e-3, Tilt::None)]);
    for (found, (radius, force)) in both.iter().zip([(100.0, 2e-3), (60.0, 1e-3)]) {
        let one = parabola(radius);
        let alone = model.approach(&one, &model.press(&one, force).unwrap()).unwrap();
        assert!((found.value - alone.value).abs() <= found.error + alone.error, "{found:?} {alone:?}");
        assert!(found.error < 1e-9 * found.value);
    }
    // also of a punch that turns, on layers that turn
    let loose = Stack::builder(Plane::Strain).layer(strip).receding().layer(strip).receding().rigid();
    let model = Model::new(loose.build().unwrap()).unwrap();
    let (solution, found) = of(
        &model,
        &[
            (parabola(100.0), 0.0, 2e-3, Tilt::None),
            (Punch::flat(0.3).unwrap(), 1.5, 1e-3, Tilt::Free { eccentricity: 0.05 }),
        ],
    );
    let field = model.field(&solution).unwrap();
    for x in [-0.15, 0.0, 0.2] {
        let height = x * x / 200.0 - found[0].value;
        assert!((field.at(x, 0.0).unwrap().v - height).abs() < 1e-9 * found[0].value, "{x}");
    }
    for x in [1.3, 1.5, 1.6] {
        let height = solution.punches()[1].tilt * (x - 1.5) - found[1].value;
        assert!((field.at(x, 0.0).unwrap().v - height).abs() < 1e-9 * found[1].value, "{x}");
    }
}

/// Between two rollers the gap is the one to the nearer roller, never negative and 0 where the roller touches; beside one of them it is the gap to it.
#[test]
fn gaps_are_those_to_the_nearest_punch() {
    let strip = Homogeneous::new(1.0, 1.0, 0.25).unwrap();
    let stack = Stack::builder(Plane::Strain).layer(strip).receding().layer(HalfPlane::new(0.6, 0.3).unwrap());
    let model = &Model::new(stack.build().unwrap()).unwrap();
    let roller = |at: f64| (Punch::parabola(100.0).unwrap(), at, 2e-3, Tilt::None);
    let solution = press_punches(model, &[roller(-1.0), roller(1.0)]);
    let x: Vec<f64> = (-120..=120).map(|k| f64::from(k) / 40.0).collect();
    let profile = model.profile(punches(&[roller(-1.0), roller(1.0)]), &solution, &x).unwrap();
    let (gap, top) = (profile.contacts[0].gap.as_ref().unwrap(), &solution.contacts()[0]);
    for (k, x) in x.iter().enumerate() {
        assert!((gap[k] - gap[gap.len() - 1 - k]).abs() < 1e-9 && (gap[k] > 0.0) == (top.pressure(*x) == 0.0), "{x}");
        // the face under the right roller touches it at its contact
        let height = |x: f64| (x - 1.0).powi(2) / 200.0;
        let [here, there] = [*x, 1.0].map(|x| height(x) - model.field(&solution).unwrap().at(x, 0.0).unwrap().v);
        assert!(*x < 0.0 || (here - there - gap[k]).abs() < 1e-9, "{x}: {here} {there} {}", gap[k]);
    }
}

/// Contacts under rollers that are nearer to each other than one contact is long are apart all the same: neither pressures nor gaps are negative, and the
/// contacts are mirror images.
#[test]
fn contacts_that_are_close_do_not_meet() {
    let strip = Homogeneous::new(0.7, 0.25, 0.28).unwrap();
    let ground = HalfPlane::new(0.6, 0.3).unwrap();
    let stack = Stack::builder(Plane::Strain).layer(strip).receding().layer(ground).build().unwrap();
    let model = Model::new(stack).unwrap();
    let roller = |at: f64| (Punch::cylinder(200.0).unwrap(), at, 2e-3, Tilt::None);
    let mut before = f64::INFINITY;
    for apart in [1.4, 1.2, 0.9, 0.6] {
        let solution = press_punches(&model, &[roller(0.0), roller(apart)]);
        assert!(solution.min_pressure() >= 0.0 && solution.min_gap() > -1e-12, "{solution:?}");
        let [left, right] = [0, 1].map(|k| solution.contacts()[0].intervals()[k]);
        assert!((left.left + right.right - apart).abs() < 1e-9 && (left.right + right.left - apart).abs() < 1e-9);
        let gap = right.left - left.right;
        assert!(gap > 0.0 && gap < before, "{apart}: {gap}");
        before = gap;
    }
}

/// Contacts that outgrow a punch, or grow together with the contact under the next one, are named.
#[test]
fn contacts_that_find_no_room_are_refused_with_the_reason() {
    let ground = HalfPlane::new(0.6, 0.3).unwrap();
    let strip = Homogeneous::new(0.7, 0.25, 0.28).unwrap();
    let model =
        Model::new(Stack::builder(Plane::Strain).layer(strip).receding().layer(ground).build().unwrap()).unwrap();
    let refused = |all: &[(Punch, f64, f64)]| {
        let upright = |(punch, at, force): &(Punch, f64, f64)| (punch.clone(), *at, *force, Tilt::None);
        let punches = punches(&all.iter().map(upright).collect::<Vec<_>>());
        let force = punches.force();
        match model.press(punches, force).unwrap_err() {
            Error::NoSolution(reason) => reason,
            other => panic!("{other}"),
        }
    };
    let roller = || Punch::cylinder(200.0).unwrap();
    let meeting = refused(&[(roller(), 0.0, 2e-3), (roller(), 0.2, 2e-3)]);
    assert!(matches!(meeting, NoSolution::PunchesMeet { left: 1 }), "{meeting}");
    let narrow = Punch::table(&[(-0.3, 0.0011), (0.0, 0.0), (0.3, 0.001)]).unwrap();
    let outgrown = refused(&[(narrow, 0.0, 5e-3)]);
    assert!(matches!(outgrown, NoSolution::PunchTooSmall { .. }), "{outgrown}");
}
