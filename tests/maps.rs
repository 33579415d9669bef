//! Maps: their window is where the quantity is, their colours tell its sign, depths are even, and tension is marked where tension was asked for.
use crate::support;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use recede::plot::{self, Colours, MapStyle, Picture};
use recede::{Coordinates, Field, FieldQuantity, Grid, Model, Scene, Solution};
use support::{recede, texts};

const SCENE: &str = "examples/scenes/strip_fgm_half_plane.ron";

fn solved(scene: &Scene) -> (Solution, Field) {
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    let field = model.field(&solution).unwrap();
    (solution, field)
}

/// A grid of the window of a quantity.
fn grids(field: &Field, [along, down]: [[f64; 2]; 2]) -> Vec<Grid> {
    let steps = |[from, to]: [f64; 2]| (0..=40).map(|k| from + (to - from) * f64::from(k) / 40.0).collect::<Vec<_>>();
    field.by_layer(&steps(along), &steps(down)).unwrap()
}

fn map(scene: &Scene, quantity: FieldQuantity, style: &MapStyle) -> Picture {
    let (solution, field) = solved(scene);
    let grids = grids(&field, field.window_of(quantity).unwrap());
    plot::map_with(scene, &solution, &field, &grids, quantity, style).unwrap()
}

fn examples() -> impl Iterator<Item = Scene> {
    let folders = ["examples/scenes", "examples/axisymmetric"];
    let files = folders.into_iter().flat_map(|folder| fs::read_dir(folder).unwrap());
    let scenes = files.map(|entry| Scene::read(entry.unwrap().path()).unwrap());
    // where nothing is searched for the largest stress of all
    scenes.filter(|scene| scene.coordinates() != Coordinates::Cartesian)
}

fn scene(text: &str) -> Scene {
    Scene::from_ron(&format!("Scene(geometry: PlaneStrain, {text})")).unwrap()
}

/// A narrow contact above one that is hundreds of times longer.
fn narrow() -> Scene {
    scene(
        "punch: Cylinder(radius: 0.1), force: 0.001, stack: [Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25),
        Receding, HalfPlane(shear_modulus: 1, poisson: 0.25)]",
    )
}

#[test]
fn a_window_holds_what_is_large_of_a_quantity() {
    for scene in examples().chain([narrow()]) {
        let (_, field) = solved(&scene);
        let whole = field.window();
        let holds = |[along, down]: [[f64; 2]; 2], x: f64, depth: f64| {
            (along[0]..=along[1]).contains(&x) && (down[0]..=down[1]).contains(&depth)
        };
        let found = field.max_shear().unwrap();
        let window = field.window_of(FieldQuantity::MaxShear).unwrap();
        assert!(holds(whole, window[0][0], window[1][0]) && holds(whole, window[0][1], window[1][1]));
        assert!(
            !found.value.is_finite() || holds(window, found.x, found.depth),
            "{}: {window:?} {found:?}",
            scene.title()
        );
        for quantity in [FieldQuantity::SigmaXx, FieldQuantity::Sigma1, FieldQuantity::SigmaXy] {
            let window = field.window_of(quantity).unwrap();
            // nothing outside is larger than what is inside
            let size = |point: &recede::FieldPoint| Some(quantity.of(point).abs()).filter(|size| size.is_finite());
            let largest = |window: [[f64; 2]; 2], is_counted: &dyn Fn(&recede::FieldPoint) -> bool| {
                let grids = grids(&field, window);
                let points = grids.iter().flat_map(|grid| grid.points());
                points.filter(|point| is_counted(point)).filter_map(size).fold(0.0, f64::max)
            };
            let outside = largest(whole, &|point| !holds(window, point.x, point.depth));
            let inside = largest(window, &|_| true);
            let tension = |point: &recede::FieldPoint| quantity != FieldQuantity::SigmaXy && quantity.of(point) > 0.0;
            let [beyond, within] = [
                largest(whole, &|point| tension(point) && !holds(window, point.x, point.depth)),
                largest(window, &tension),
            ];
            assert!(beyond <= within.max(0.006 * inside), "{} {quantity:?}: {beyond} {within}", scene.title());
            assert!(outside < 0.5 * inside, "{} {quantity:?}: {window:?} {outside} {inside}", scene.title());
        }
    }
}

#[test]
fn a_window_is_as_small_as_a_quantity_lets_it_be() {
    let (solution, field) = solved(&narrow());
    let [pressed, below] = [0, 1].map(|k| solution.contacts()[k].reach());
    let [[_, right], [_, bottom]] = field.window_of(FieldQuantity::MaxShear).unwrap();
    assert!(below > 20.0 * pressed && right < 0.25 * below && right > pressed && bottom < 0.5 * below);
}

/// Numbers beside the bar of colours, which are the last ones on the right.
fn bar(picture: &Picture) -> Vec<f64> {
    let labels = picture.labels();
    let number = |text: &str| text.replace('−', "-").parse::<f64>().ok();
    let numbers = labels.iter().filter_map(|(text, frame)| Some((number(text)?, frame.left)));
    let numbers: Vec<(f64, f64)> = numbers.filter(|(_, left)| *left > 380.0).collect();
    numbers.into_iter().map(|(number, _)| number).collect()
}

#[test]
fn two_signs_have_colours_symmetric_about_zero_and_one_sign_goes_from_light_to_dark() {
    let scene = Scene::read(SCENE).unwrap();
    let ends = |numbers: &[f64]| {
        [numbers.iter().copied().fold(f64::INFINITY, f64::min), numbers.iter().copied().fold(f64::MIN, f64::max)]
    };
    let signed = map(&scene, FieldQuantity::SigmaXx, &MapStyle::default());
    let [low, high] = ends(&bar(&signed));
    assert!(low == -high && high > 0.0, "{low} {high}");
    let one = map(&scene, FieldQuantity::MaxShear, &MapStyle::default());
    assert_eq!(ends(&bar(&one))[0], 0.0);
    let colours = |picture: &Picture| {
        let svg = picture.svg();
        let fills =
            svg.lines().filter(|line| line.contains("fill-rule")).filter_map(|line| line.split("fill=\"").nth(1));
        fills.map(|fill| fill[..7].to_owned()).collect::<BTreeSet<String>>()
    };
    let levels = |style: MapStyle| colours(&map(&scene, FieldQuantity::MaxShear, &style));
    let count = |count| levels(MapStyle { levels: Some(count), ..MapStyle::default() }).len();
    assert_eq!(count(40) - count(7), 33);
    let of = |colours| levels(MapStyle { colours: Some(colours), ..MapStyle::default() });
    assert!(of(Colours::Magma) == levels(MapStyle::default()) && of(Colours::Viridis) != of(Colours::Magma));
    let range = MapStyle { range: Some([1e-4, 3e-4]), ..MapStyle::default() };
    assert_eq!(ends(&bar(&map(&scene, FieldQuantity::MaxShear, &range))), [1.0, 3.0]);
}

#[test]
fn tension_is_marked_where_tension_is_asked_for() {
    let scene = Scene::read(SCENE).unwrap();
    let (_, field) = solved(&scene);
    let grids = grids(&field, field.window_of(FieldQuantity::SigmaXx).unwrap());
    let values = || grids.iter().flat_map(|grid| grid.points()).map(|point| point.sigma_xx);
    let (tension, compression) = (values().fold(f64::MIN, f64::max), values().fold(f64::MAX, f64::min));
    assert!(tension < -compression);
    let said = texts(map(&scene, FieldQuantity::SigmaXx, &MapStyle::default()).svg().as_bytes());
    let expected = format!("cross: largest tension on the grid of this map, {}", plot::label(tension));
    assert!(said.contains(&expected), "{said}: {expected}");
}

#[test]
fn depths_of_a_map_are_even() {
    let scene = scene(
        "punch: Cylinder(radius: 10), force: 20, units: (length: \"mm\", force: \"N\"), stack: [
            Homogeneous(thickness: 0.003, shear_modulus: 1e5, poisson: 0.25), Bonded,
            Homogeneous(thickness: 2, shear_modulus: 8e4, poisson: 0.3), Receding, HalfPlane(shear_modulus: 1000, poisson: 0.3)]",
    );
    let (solution, field) = solved(&scene);
    let picture =
        plot::map(&scene, &solution, &field, &grids(&field, [[-2.0, 2.0], [0.0, 4.0]]), FieldQuantity::MaxShear)
            .unwrap();
    let labels = picture.labels();
    let left: f64 = labels.iter().find(|(text, _)| text == "depth, mm").unwrap().1.right;
    let ticks = labels.iter().filter(|(_, frame)| frame.left > left && frame.right < left + 40.0);
    let mut ticks: Vec<(f64, f64)> = ticks.filter_map(|(text, frame)| Some((text.parse().ok()?, frame.top))).collect();
    ticks.sort_by(|a, b| a.0.total_cmp(&b.0));
    let slope = |pair: &[(f64, f64)]| (pair[1].1 - pair[0].1, pair[1].0 - pair[0].0);
    let (height, step) = slope(&ticks[..2]);
    assert!(
        ticks.len() > 4
            && ticks.windows(2).all(|pair| (slope(pair).0 - height).abs() < 0.5 && (slope(pair).1 - step).abs() < 1e-9)
    );
    assert_eq!(picture.faults(), Vec::<String>::new());
}

#[test]
fn options_of_maps_say_what_is_allowed() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("maps");
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join("map.svg");
    let run = |options: &[&str]| recede(&[&["field", SCENE, "--out", file.to_str().unwrap()], options].concat(), b"");
    for (options, said) in [
        (&["--range", "1"][..], "found `1`, expected LOW:HIGH"),
        (&["--range", "2:1"], "of which the second is larger"),
        (&["--levels", "1"], "2..=256"),
        (&["--colours", "jet"], "magma, viridis"),
        (&["--window", "-1:1"], "expected LEFT:RIGHT,TOP:BOTTOM"),
        (&["--window", "-1:1,0:1", "--x", "0:1:3"], "cannot be used with"),
        (&["--window", "-1:1,-1:1"], "allowed is layer 1"),
        (&["--quantity", "sigma_xx", "--log"], "logarithmic colours need values > 0"),
        (&["--log", "--range", "0:1"], "logarithmic colours need values > 0"),
    ] {
        let run = run(options);
        assert!(run.status == Some(2) && run.stderr.contains(said), "{options:?}: {:?} {}", run.status, run.stderr);
    }
    let numbers = recede(&["field", SCENE, "--levels", "7"], b"");
    assert!(numbers.status == Some(2) && numbers.stderr.contains("colours are of a map"), "{}", numbers.stderr);
    for options in [
        &["--log"][..],
        &["--quantity", "sigma_xx", "--log", "--range", "1e-5:1e-3", "--levels", "9"],
        &["--quantity", "v", "--colours", "purple-orange"],
        &["--window", "0:1,0.2:1.4", "--range", "-1:1", "--colours", "greys"],
    ] {
        let run = run(options);
        assert_eq!((run.status, &run.stderr[..]), (Some(0), ""), "{options:?}");
        assert!(!fs::read_to_string(&file).unwrap().contains("NaN"), "{options:?}");
    }
}

#[test]
fn maps_of_sweeps_have_the_colours_of_maps() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("maps");
    fs::create_dir_all(&folder).unwrap();
    let [rows, file] = ["rows.csv", "sweep.svg"].map(|name| folder.join(name).to_str().unwrap().to_owned());
    let grid = ["sweep", SCENE, "--out", &rows, "--vary", "force=0.001:0.004:6", "--vary", "layer[1].thickness=1:2:6"];
    let run = |options: &[&str]| recede(&[&grid, options].concat(), b"");
    let drawn = |options: &[&str]| {
        let run = run(&[&["--plot", &file], options].concat());
        assert_eq!((run.status, &run.stderr[..]), (Some(0), ""), "{options:?}");
        fs::read_to_string(&file).unwrap()
    };
    let one = ["--y", "punch_half_length"];
    let plain = drawn(&one);
    assert!(plain == drawn(&[&one[..], &["--colours", "magma"]].concat()));
    let range = drawn(&[&one[..], &["--range", "0:8", "--levels", "4"]].concat());
    assert!(texts(range.as_bytes()).split('|').any(|text| text == "8"), "{range}");
    assert!(drawn(&[&one[..], &["--log", "colours"]].concat()) != plain && !plain.contains("NaN"));
    for (options, said) in [
        (&["--levels", "7"][..], "colours are of a map"),
        (&["--plot", &file, "--range", "0:1"], "--range is of one column, found 0"),
        (&["--plot", &file, "--y", "punch_right", "--x", "force", "--levels", "9"], "drawn as curves"),
        (
            &["--plot", &file, "--y", "punch_right", "--log", "colours", "--range=0:1"],
            "logarithmic colours need values > 0",
        ),
    ] {
        let run = run(options);
        assert!(run.status == Some(2) && run.stderr.contains(said), "{options:?}: {:?} {}", run.status, run.stderr);
    }
}
