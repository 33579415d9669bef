//! Axisymmetric problems: what is read and written of them.
use crate::support;

use std::fs;
use std::path::{Path, PathBuf};

use recede::selftest::CheckedScene;
use recede::{FieldQuantity, Geometry, Model, Options, Scene, plot};
use support::{recede, texts};

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} {expected}");
}

#[test]
fn rows_of_sweeps_are_single_solutions() {
    let scene = Scene::read("examples/axisymmetric/sphere_on_layer.ron").unwrap();
    let axes = ["punch.radius=[3,5]", "force=[10,20]"].map(|axis| axis.parse().unwrap()).to_vec();
    let sweep = recede::Sweep::new(scene, axes).unwrap().with_approach().with_extremes();
    let columns = recede::report::SweepCsv::new(&sweep).header().unwrap();
    assert!(columns.contains(",approach,") && columns.contains("_von_mises"), "{columns}");
    for row in sweep.rows() {
        let scene = sweep.scene_at(row.index).unwrap();
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let alone = model.press(&scene.top, scene.force).unwrap();
        let solution = row.result.unwrap();
        close(solution.contacts()[0].reach(), alone.contacts()[0].reach(), 1e-10);
        let approach = model.approach(&scene.top, &alone).unwrap().value;
        close(row.approach.unwrap().unwrap().value, approach, 1e-9);
        let [found, expected] = [row.extremes.unwrap().unwrap(), model.field(&alone).unwrap().extremes().unwrap()];
        close(found.layers[0].von_mises.unwrap().value, expected.layers[0].von_mises.unwrap().value, 1e-8);
    }
}

#[test]
fn maps_are_symmetric_about_the_axis() {
    let scene = Scene::read("examples/axisymmetric/sphere_on_layer.ron").unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    let field = model.field(&solution).unwrap();
    let (xs, depths) = ([-2.0, -0.7, 0.0, 0.7, 2.0], [0.0, 0.5, 1.0]);
    let grids = field.by_layer(&xs, &depths).unwrap();
    for grid in &grids {
        for row in grid.rows() {
            for (left, right) in row.iter().zip(row.iter().rev()) {
                assert_eq!((left.x, left.sigma_xx, left.sigma_yy), (-right.x, right.sigma_xx, right.sigma_yy));
                assert_eq!((left.sigma_zz, left.v), (right.sigma_zz, right.v));
                assert_eq!((left.sigma_xy, left.u), (-right.sigma_xy, -right.u));
            }
        }
    }
    let map = |quantity| recede::plot::map(&scene, &solution, &field, &grids, quantity).unwrap().svg();
    let [along, about] = [recede::FieldQuantity::SigmaXx, recede::FieldQuantity::SigmaZz].map(map);
    assert!(along.starts_with("<svg") && along != about);
}

/// Displacements of faces have the names and signs of fields.
#[test]
fn profiles_are_in_cylindrical_coordinates() {
    let scene = Scene::read("examples/axisymmetric/sphere_on_layer.ron").unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    let profile = model.profile(&scene.top, &solution, &[0.0]).unwrap();
    let mut text = Vec::new();
    recede::report::write_profile(&profile, &mut text).unwrap();
    let text = String::from_utf8(text).unwrap();
    let [header, numbers] = [0, 1].map(|line| text.lines().nth(line).unwrap().split(',').collect::<Vec<_>>());
    let column = header.iter().position(|name| *name == "layer_1_top_u_z").unwrap();
    let sunk = model.approach(&scene.top, &solution).unwrap().value;
    close(numbers[column].parse().unwrap(), sunk, 1e-8);
}

/// A word of plane problems: the coordinates, extents and forces of an axisymmetric one have others.
fn plane_word(text: &str) -> Option<&str> {
    const WORDS: [&str; 17] = [
        "x",
        "|x|",
        "y",
        "half-length",
        "half-lengths",
        "half-width",
        "mirror",
        "cylinder",
        "Cylinder",
        "wedge",
        "Wedge",
        "line",
        "u",
        "v",
        "sigma_xx",
        "sigma_yy",
        "sigma_xy",
    ];
    let is_part = |c: char| c.is_alphanumeric() || "_-|".contains(c);
    text.split(|c: char| !is_part(c)).map(|word| word.trim_matches('-')).find(|word| WORDS.contains(word))
}

#[test]
fn plane_words_are_found() {
    for text in [
        "at x = 1",
        "at |x|, mm",
        "|x| < 2 carries",
        "a: half-length 0.5",
        "displacement v, mm",
        "1/|x|",
        "under a line load",
    ] {
        assert!(plane_word(text).is_some(), "{text}");
    }
    assert_eq!(plane_word("contact radius, mm; max_shear; at r = 0; lines"), None);
}

/// Scenes about an axis of all kinds of punches, loads, forces and bases.
fn axisymmetric_scenes() -> Vec<(String, String)> {
    let layer = "Homogeneous(thickness: 1.0, young: 100.0, poisson: 0.3)";
    let loose = format!("{layer}, Receding, HalfPlane(young: 20.0, poisson: 0.3)");
    let bonded = format!("{layer}, Bonded, HalfPlane(young: 20.0, poisson: 0.3)");
    let rigid = format!("{layer}, Bonded, Rigid");
    let ground = "HalfPlane(young: 20.0, poisson: 0.3)".to_owned();
    [
        ("sphere", "punch: Sphere(radius: 0.5), force: 20.0", &loose),
        ("cone", "punch: Cone(slope: 0.01), half_length: 0.5", &bonded),
        ("flat", "punch: Flat(radius: 1.5), depth: 0.01", &bonded),
        ("power", "punch: Power(exponent: 4.0, radius: 1.0, height: 0.1), force: 1.0", &rigid),
        ("elastic", "punch: ElasticSphere(radius: 20.0, young: 50.0, poisson: 0.3), force: 1.0", &ground),
        ("point", "load: Point, force: 1.5", &ground),
        ("ring", "load: Ring(radius: 5.0, half_width: 1.0), force: 20.0", &bonded),
        ("failing", "punch: Sphere(radius: 0.1), force: 2000.0", &rigid),
        ("beyond", "punch: Flat(radius: 1.0), half_length: 2.0", &rigid),
    ]
    .map(|(name, pressed, stack)| {
        let units = r#"units: (length: "mm", force: "N")"#;
        (name.to_owned(), format!("Scene({units}, geometry: Axisymmetric, {pressed}, stack: [{stack}])"))
    })
    .to_vec()
}

/// A file of these tests.
fn file(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("round_reports");
    fs::create_dir_all(&folder).unwrap();
    folder.join(name)
}

/// All that is said to readers of an axisymmetric scene is said in cylindrical coordinates. Keys of JSON and columns of CSV are the same in
/// all geometries, and not for readers.
#[test]
fn no_output_has_words_of_plane_problems() {
    for (name, text) in axisymmetric_scenes() {
        let scene = file(&format!("{name}.ron"));
        fs::write(&scene, &text).unwrap();
        let scene = scene.to_str().unwrap();
        let [drawing, map, curves] = ["drawing", "map", "curves"].map(|what| file(&format!("{name}_{what}.svg")));
        let [drawing, map, curves] = [&drawing, &map, &curves].map(|path| path.to_str().unwrap());
        let rows = file(&format!("{name}.csv"));
        let varied = if text.contains("young: 100.0") { "layer[1].young=[80,100]" } else { "layer[1].young=[20,30]" };
        let said = |arguments: &[&str]| {
            let run = recede(arguments, b"");
            for output in [&run.stdout, &run.stderr] {
                // of a file with the scene's own name
                let output = output.replace(scene, "");
                assert_eq!(plane_word(&output), None, "{arguments:?}: {output}");
            }
        };
        said(&["check", scene]);
        said(&["solve", scene, "--extremes", "--stats"]);
        said(&["field", scene]);
        said(&["field", scene, "--at", "1,-1"]);
        said(&["plot", scene, "--out", drawing]);
        said(&["field", scene, "--quantity", "u_z", "--x", "-2:2:9", "--depth", "0:1:5", "--out", map]);
        said(&["sweep", scene, "--vary", varied, "--out", rows.to_str().unwrap(), "--plot", curves]);
        for picture in [drawing, map, curves].into_iter().filter_map(|path| fs::read(path).ok()) {
            let written = texts(&picture);
            assert_eq!(plane_word(&written), None, "{name}: {written}");
        }
        // reasons and warnings of the rows of a sweep
        let messages = fs::read_to_string(&rows).unwrap_or_default();
        for message in messages.lines().skip(1) {
            assert_eq!(plane_word(message), None, "{name}: {message}");
        }
    }
}

/// The force is a whole force, and displacements and stresses have the names of columns.
#[test]
fn pictures_have_the_units_and_symbols_of_an_axis() {
    let scene = Scene::read("examples/axisymmetric/sphere_on_layer.ron").unwrap();
    let axes = ["punch.radius=[4,5]", "force=[10,13.5714285714,20]"].map(|axis| axis.parse().unwrap()).to_vec();
    let sweep = recede::Sweep::new(scene.clone(), axes).unwrap();
    let csv = recede::report::SweepCsv::new(&sweep);
    let points: Vec<_> = sweep.rows().map(|row| csv.point(&row)).collect();
    let written = texts(plot::sweep(&sweep, &points, &plot::DrawnColumns::default()).unwrap().svg().as_bytes());
    assert!(written.contains("force P, nN|") && written.contains("contact radius a, µm"), "{written}");
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    let field = model.field(&solution).unwrap();
    let grids = field.by_layer(&[-1.0, 0.0, 1.0], &[0.0, 0.5, 1.0]).unwrap();
    for (quantity, symbol) in [
        (FieldQuantity::V, "displacement uz"),
        (FieldQuantity::SigmaXy, "stress τrz"),
        (FieldQuantity::SigmaZz, "stress σθθ"),
    ] {
        let written = texts(plot::map(&scene, &solution, &field, &grids, quantity).unwrap().svg().as_bytes());
        assert!(written.contains(symbol), "{written}");
    }
    let pressed = Scene::from_ron(&scene.to_ron().replace("force: 20.0", "force: 13.5714285714")).unwrap();
    let solution = model.press(&pressed.top, pressed.force).unwrap();
    let written = texts(plot::stack(&pressed, model.stack(), &solution).svg().as_bytes());
    assert!(written.contains("P = 13.57 nN"), "{written}");
}

/// Far from where a slab touches it is free of normal stress: a map of rounding has no largest value, and no line of zeros.
#[test]
fn maps_do_not_show_rounding() {
    let scene = Scene::read("examples/axisymmetric/wheel_on_slab.ron").unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    let field = model.field(&solution).unwrap();
    // whether a largest value is marked, and how many lines have more than a few corners: axes and marks do not
    let drawn = |xs: [f64; 2], quantity| {
        let xs: Vec<f64> = (0..=40).map(|k| xs[0] + (xs[1] - xs[0]) * f64::from(k) / 40.0).collect();
        let depths: Vec<f64> = (0..=20).map(|k| 190.0 * f64::from(k) / 20.0).collect();
        let svg = plot::map(&scene, &solution, &field, &field.by_layer(&xs, &depths).unwrap(), quantity).unwrap().svg();
        let lines = svg.lines().filter(|line| line.contains("fill=\"none\""));
        let bent = lines.filter(|line| line.split("d=\"").nth(1).unwrap_or_default().split(' ').count() > 20).count();
        let marked = texts(svg.as_bytes()).contains("cross: ");
        (marked, bent)
    };
    // less the outline of the load, which any map has: a von Mises stress is nowhere negative
    let zeros = |xs, quantity| {
        let (marked, lines) = drawn(xs, quantity);
        (marked, lines - drawn(xs, FieldQuantity::VonMises).1)
    };
    assert!(zeros([2200.0, 2600.0], FieldQuantity::SigmaYy).1 > 0);
    assert_eq!(zeros([3800.0, 4600.0], FieldQuantity::SigmaYy), (false, 0));
    assert_eq!(zeros([3800.0, 4600.0], FieldQuantity::SigmaXy), (false, 0));
    // bending is left there, which changes its sign across the slab
    assert_eq!(zeros([3800.0, 4600.0], FieldQuantity::SigmaXx), (true, 1));
}

#[test]
fn scenes_are_read_and_written() {
    let entries = std::fs::read_dir("examples/axisymmetric").unwrap();
    let mut scenes = 0;
    for path in entries.map(|entry| entry.unwrap().path()).filter(|path| path.extension().is_some_and(|e| e == "ron")) {
        let scene = Scene::read(&path).unwrap();
        assert_eq!(scene.geometry, Geometry::Axisymmetric);
        let again = Scene::from_ron(&scene.to_ron()).unwrap();
        assert_eq!((again.top.clone(), again.force), (scene.top.clone(), scene.force), "{}", path.display());
        let outcome = CheckedScene::run(&scene, &Options::default(), true).outcome;
        assert!(outcome.solution().is_some(), "{}: {}", path.display(), outcome.reason());
        let json = Scene::from_json(&scene.to_json()).unwrap();
        assert_eq!(json.top, scene.top);
        scenes += 1;
    }
    assert!(scenes >= 2);
}
