//! Several punches, each with a place, a force and a tilt: how they are written.
//!
//! Goal: whatever shapes they have, they are read, written, converted and varied as one punch is, and refused by what solves for one
//! punch at x = 0 only.
use crate::support::recede;

use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use recede::{
    ApproachError, Error, Force, Model, NoSolution, Options, Pressed, Punch, Punches, Scene, Sweep, Tilt, Top,
};

const ROLLER: &str = "(shape: Cylinder(radius: 100), at: 0, force: 0.002)";
const BLOCK: &str = "(shape: Flat(half_width: 0.5), at: 3, force: 0.001, tilt: Free(eccentricity: 0.1))";

fn scene_of(punches: &str) -> String {
    format!(
        "Scene(geometry: PlaneStrain, units: (length: \"mm\", force: \"N\"), punches: [{punches}],
         stack: [Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, Rigid])"
    )
}

fn read(punches: &str) -> Scene {
    Scene::from_ron(&scene_of(punches)).unwrap()
}

fn shapes() -> Vec<Punch> {
    vec![
        Punch::cylinder(2.0).unwrap(),
        Punch::parabola(2.0).unwrap(),
        Punch::power(2.5, 1.5, 0.2).unwrap(),
        Punch::polynomial(1.5, &[0.3, 0.0, 0.1]).unwrap(),
        Punch::wedge_of_half_angle(1.2).unwrap(),
        Punch::uneven_wedge(0.2, 0.1).unwrap(),
        Punch::rounded_flat(0.7, 3.0).unwrap(),
        Punch::flat(1.5).unwrap(),
        Punch::table(&[(-1.6, 0.9), (-0.7, 0.3), (0.0, 0.1), (0.3, 0.2), (1.5, 1.9)]).unwrap(),
    ]
}

const TILTS: [Tilt; 4] =
    [Tilt::None, Tilt::Fixed(-0.003), Tilt::Free { eccentricity: 0.0 }, Tilt::Free { eccentricity: -1.25 }];

#[test]
fn punches_of_all_shapes_are_read_as_they_are_written() {
    let ground = Scene::from_ron(&scene_of(ROLLER)).unwrap().stack;
    for (i, tilt) in TILTS.into_iter().enumerate() {
        let pressed = |(k, shape): (usize, Punch)| {
            Pressed::new(shape, 10.0 * k as f64 - 41.3, 0.1 + (i + k) as f64, tilt).unwrap()
        };
        let punches: Vec<Pressed> = shapes().into_iter().enumerate().map(pressed).rev().collect();
        let punches = Punches::new(&punches).unwrap();
        assert!(punches.parts().map(|(pressed, _)| pressed.at()).is_sorted());
        assert!((punches.parts().map(|(_, part)| part).sum::<f64>() - 1.0).abs() < 1e-14);
        let scene = Scene::new(recede::Plane::Stress, &punches, punches.force(), ground.clone());
        for text in [scene.to_ron(), scene.to_json()] {
            let again = Scene::from_ron(&text).unwrap();
            assert_eq!((again.top.punches(), again.force), (Some(&punches), Force::Given(punches.force())), "{text}");
            assert_eq!(again.to_ron(), scene.to_ron());
        }
        // with twice the force, each has twice its own
        let twice = Scene::new(recede::Plane::Stress, &punches, 2.0 * punches.force(), ground.clone());
        let twice = Scene::from_ron(&twice.to_ron()).unwrap().top;
        for ((found, _), (pressed, _)) in twice.punches().unwrap().parts().zip(punches.parts()) {
            assert!((found.force() / pressed.force() - 2.0).abs() < 1e-14 && found.shape() == pressed.shape());
        }
    }
}

#[test]
fn one_of_several_at_the_middle_is_the_punch() {
    for tilt in ["", ", tilt: None", ", tilt: Fixed(0)"] {
        let scene = read(&format!("(shape: Parabola(radius: 50), at: -0.0, force: 0.02{tilt})"));
        assert_eq!(scene.top.punch(), Some(&Punch::parabola(50.0).unwrap()));
        let text = scene.to_ron();
        assert!(text.contains("punch: Parabola(radius: 50.0),\n    force: 0.02,\n"), "{text}");
        let expected = recede::solve(&Scene::from_ron(&text).unwrap()).unwrap();
        assert_eq!(recede::solve(&scene).unwrap().contacts(), expected.contacts());
    }
    for other in ["at: 1e-300", "at: 0, tilt: Fixed(1e-9)", "at: 0, tilt: Free(eccentricity: 0)"] {
        let scene = read(&format!("(shape: Parabola(radius: 50), {other}, force: 0.02)"));
        assert!(scene.top.punch().is_none() && scene.top.loads().is_none());
        assert_eq!(scene.top.label(scene.geometry), "1 punch");
    }
    let elastic = read("(shape: ElasticCylinder(radius: 50, young: 3, poisson: 0.3), at: 0, force: 0.02)");
    assert!(elastic.top.material().is_some());
}

#[test]
fn numbers_of_punches_have_units() {
    let scene = read(
        "(shape: Table([(\"-1 cm\", \"20 um\"), (0, 0), (10, 0.02)]), at: \"-2 cm\", force: \"3 kN/m\", tilt: Fixed(\"0.5 deg\")),
         (shape: Flat(half_width: \"500 um\"), at: 3, force: 1, tilt: Free(eccentricity: \"10 um\"))",
    );
    let parts: Vec<&Pressed> = scene.top.punches().unwrap().parts().map(|(pressed, _)| pressed).collect();
    let [table, flat] = parts[..] else { panic!("two punches") };
    assert_eq!((table.at(), table.force(), table.shape().profile(-10.0)), (-20.0, 3.0, 0.02));
    assert_eq!(table.tilt(), Tilt::Fixed(0.5f64.to_radians()));
    assert_eq!((flat.shape(), flat.tilt()), (&Punch::flat(0.5).unwrap(), Tilt::Free { eccentricity: 0.01 }));
}

#[test]
fn numbers_of_punches_vary_by_the_order_in_which_they_are_written() {
    let turned = "(shape: Table([(0, 0), (1, 0.1)]), at: -9, force: 0.5, tilt: Fixed(0.01))";
    let scene = read(&format!("{BLOCK}, {turned}"));
    let paths = [
        "punches[1].shape.half_width",
        "punches[1].at",
        "punches[1].force",
        "punches[1].tilt.eccentricity",
        "punches[2].at",
        "punches[2].force",
        "punches[2].tilt",
    ];
    // besides the entries of the table
    let of_table = |path: &String| path.contains("shape[");
    let found: Vec<String> = scene.paths().into_iter().filter(|path| !of_table(path)).collect();
    assert_eq!(found[..paths.len()], paths);
    assert!(scene.paths().contains(&"punches[2].shape[2].at".to_owned()));
    let json = Scene::from_json(&scene.to_json()).unwrap();
    assert_eq!(json.number("punches[1].tilt").unwrap(), 0.01);
    for (k, path) in paths.into_iter().enumerate() {
        let value = 0.125 + k as f64 / 64.0;
        let changed = scene.with(path, value).unwrap();
        assert_eq!(changed.number(path).unwrap(), value);
        assert_ne!(changed.top, scene.top, "{path}");
        // rows of a sweep read no more than the punches
        let sweep = Sweep::new(scene.clone(), vec![format!("{path}=[{value}]").parse().unwrap()]).unwrap();
        assert_eq!(sweep.scene_at(0).unwrap().top, changed.top);
        // a table of two heights is a parabola, next to which a flat punch may stand
        match sweep.rows().next().unwrap().result {
            Ok(_) => {}
            // turned so far it is touched at its edge
            Err(Error::NoSolution(NoSolution::PunchTooSmall { .. })) => assert_eq!(path, "punches[2].tilt"),
            Err(error) => panic!("{path}: {error}"),
        }
    }
    let error = scene.with("punches[2].at", 3.25).unwrap_err();
    assert_eq!(
        error.message(),
        "punch 1, Flat(half_width: 0.5) at 3.0, and punch 2, Table([(0.0, 0.0), (1.0, 0.1)]) at 3.25, overlap"
    );
    // what is illegal together is a row without a solution, what is illegal alone no axis
    let overlapping = Sweep::new(scene.clone(), vec!["punches[2].at=[3.25]".parse().unwrap()]).unwrap();
    assert_eq!(overlapping.rows().next().unwrap().result.unwrap_err().to_string(), error.to_string());
    assert!(Sweep::new(scene, vec!["punches[2].force=[-1, 1]".parse().unwrap()]).is_err());
}

#[test]
fn rows_of_a_sweep_with_one_punch_at_the_middle_are_solved() {
    let scene = read("(shape: Parabola(radius: 50), at: 0.5, force: 0.02)");
    let axes = ["punches[1].at=[0, 0.5]", "punches[1].force=[0.01, 0.02]"].map(|axis| axis.parse().unwrap());
    let rows: Vec<_> = Sweep::new(scene, axes.to_vec()).unwrap().rows().collect();
    let model = Model::new(read(ROLLER).stack().unwrap()).unwrap();
    for (row, force) in rows.iter().zip([0.01, 0.02]) {
        let expected = model.press(Punch::parabola(50.0).unwrap(), force).unwrap();
        assert_eq!(row.result.as_ref().unwrap().contacts(), expected.contacts());
    }
    for (row, middle) in rows[2..].iter().zip(&rows) {
        let [moved, expected] = [row, middle].map(|row| row.result.as_ref().unwrap().contacts()[1].intervals()[0]);
        assert!((moved.left - 0.5 - expected.left).abs() < 1e-9 && (moved.right - 0.5 - expected.right).abs() < 1e-9);
    }
}

#[test]
fn punches_that_overlap_for_certain_are_named() {
    let punches = |places: &[(f64, f64)]| {
        let pressed = |(half_width, at): &(f64, f64)| {
            let shape = if *half_width > 0.0 { Punch::flat(*half_width) } else { Punch::cylinder(100.0) };
            Pressed::new(shape.unwrap(), *at, 1.0, Tilt::None).unwrap()
        };
        Punches::new(&places.iter().map(pressed).collect::<Vec<_>>())
    };
    // cylinders much wider than their distance touch apart from each other
    assert!(punches(&[(0.0, 3.0), (0.5, 1.0), (0.0, -1e-9), (0.125, 0.25)]).is_ok());
    for (places, numbers) in [
        (&[(0.0, 1.0), (0.0, 2.0), (0.0, 1.0)][..], "punch 1, Cylinder(radius: 100.0) at 1.0, and punch 3, "),
        (&[(0.5, 1.0), (0.5, -3.0), (0.5, 0.0)], "punch 1, Flat(half_width: 0.5) at 1.0, and punch 3, "),
        (&[(0.0, 4.0), (5.0, 0.0)], "punch 1, Cylinder(radius: 100.0) at 4.0, and punch 2, "),
        // the far ones of three
        (&[(5.0, 0.0), (1.0, 6.5), (0.0, 4.5)], "punch 1, Flat(half_width: 5.0) at 0.0, and punch 3, "),
    ] {
        let error = punches(places).unwrap_err().to_string();
        assert!(error.starts_with(numbers) && error.ends_with(", overlap"), "{error}");
    }
}

#[test]
fn numbers_that_are_none_make_no_punch() {
    let flat = || Punch::flat(0.5).unwrap();
    let free = |eccentricity: f64| Tilt::Free { eccentricity };
    for (at, force, tilt, quantity) in [
        (f64::NAN, 1.0, Tilt::None, "at"),
        (0.0, 0.0, Tilt::None, "force"),
        (0.0, 1.0, Tilt::Fixed(f64::INFINITY), "tilt"),
        (0.0, 1.0, free(f64::NAN), "eccentricity"),
    ] {
        let error = Pressed::new(flat(), at, force, tilt).unwrap_err().to_string();
        assert!(error.starts_with(&format!("{quantity}: found ")), "{error}");
    }
    let one = |shape, eccentricity| Punches::new(&[Pressed::new(shape, 7.0, 1.0, free(eccentricity)).unwrap()]);
    assert!(one(flat(), 0.5).is_err() && one(flat(), -0.6).is_err() && one(flat(), -0.4999).is_ok());
    assert!(one(Punch::rounded_flat(0.5, 1.0).unwrap(), 0.7).is_ok());
    assert!(Punches::new(&[]).is_err());
}

#[test]
fn what_solves_for_one_punch_refuses_several() {
    let smooth = read(&format!("{ROLLER}, (shape: Parabola(radius: 70), at: 3.0, force: 0.002)"));
    let model = Model::new(smooth.stack().unwrap()).unwrap();
    for force in [Force::ForDepth(0.1), Force::ForHalfLength(0.1)] {
        let refused = model.press_with(&smooth.top, force, &Options::default()).unwrap_err();
        assert!(refused.is_input(), "{refused}");
    }
    let one = Punch::parabola(50.0).unwrap();
    let solution = model.press(&one, 0.02).unwrap();
    assert!(model.approach(&one, &solution).is_ok());
    assert_eq!(model.approach(&smooth.top, &solution), Err(ApproachError::Punches));
    assert!(model.profile(&smooth.top, &solution, &[0.0]).unwrap().contacts[0].gap.is_none());
    let top: Top = Punches::from(one).into();
    assert_eq!(top.written_in(recede::Geometry::Axisymmetric), "Parabola(radius: 50.0)");
}

/// Numbers of any size.
fn number() -> impl Strategy<Value = f64> {
    (-1.0..1.0f64, -320i32..309).prop_map(|(digits, power)| digits * 10f64.powi(power))
}

proptest! {
    #![proptest_config(ProptestConfig { rng_seed: RngSeed::Fixed(11), failure_persistence: None, ..Default::default() })]

    #[test]
    fn any_numbers_make_punches_or_are_refused(
        all in prop::collection::vec((0..9usize, number(), number(), 0..3usize, number()), 1..6),
    ) {
        let pressed = |&(shape, at, force, kind, number): &(usize, f64, f64, usize, f64)| {
            let tilt = [Tilt::None, Tilt::Fixed(number), Tilt::Free { eccentricity: number }][kind];
            Pressed::new(shapes()[shape].clone(), at, force.abs().max(f64::MIN_POSITIVE), tilt)
        };
        let pressed: Vec<Pressed> = all.iter().map(pressed).collect::<Result<_, _>>().unwrap();
        if let Ok(punches) = Punches::new(&pressed) {
            prop_assert!(punches.parts().map(|(pressed, _)| pressed.at()).is_sorted());
            let scene = Scene::new(recede::Plane::Strain, &punches, punches.force(), read(ROLLER).stack);
            for text in [scene.to_ron(), scene.to_json()] {
                let again = Scene::from_ron(&text).unwrap();
                prop_assert_eq!(again.to_ron(), scene.to_ron());
                prop_assert!(again.top.punch().is_some() || again.top.punches() == Some(&punches));
            }
        }
    }
}

#[test]
fn the_command_checks_and_converts_them() {
    let text = scene_of(&format!("{BLOCK}, {ROLLER}"));
    let check = recede(&["check", "-"], text.as_bytes());
    assert!(check.status == Some(0) && check.stdout.contains("2 punches, force 0.003"), "{}", check.stdout);
    let json = recede(&["convert", "-"], text.as_bytes());
    let written = recede(&["convert", "-"], json.stdout.as_bytes());
    assert_eq!((json.status, written.status), (Some(0), Some(0)), "{}", json.stderr);
    assert_eq!(Scene::from_ron(&json.stdout).unwrap().top, Scene::from_ron(&text).unwrap().top);
    assert!(json.stdout.contains("\"Free\": {"), "{}", json.stdout);
    let list = recede(&["list", "scene"], b"");
    assert!(list.stdout.contains("punches") && list.stdout.contains("Fixed(angle)"), "{}", list.stdout);
}
