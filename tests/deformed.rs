//! Pictures of stacks with displaced faces: what is drawn apart is as far apart as the profile says, times the factor that the picture names.
use crate::support;

use std::fs;

use recede::plot::{self, Picture};
use recede::{FaceProfiles, FaceSide, Interface, Model, Scene, profile_places};
use support::recede;

fn scene(text: &str) -> Scene {
    Scene::from_ron(&format!("Scene({text})")).unwrap()
}

/// Scenes with a gap, a layer of no thickness, several punches, an axis, and openings under weight.
fn scenes() -> Vec<Scene> {
    let layer = "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25)";
    let none = "Homogeneous(thickness: 0, shear_modulus: 3, poisson: 0.25)";
    let ground = "HalfPlane(shear_modulus: 1, poisson: 0.25)";
    let cylinder = "geometry: PlaneStrain, punch: Cylinder(radius: 100), force: 0.01";
    let punches = "punches: [(shape: Flat(half_width: 0.5), at: -2, force: 0.01), (shape: Cylinder(radius: 10), at: 1, force: 0.02)]";
    let sphere = "geometry: Axisymmetric, punch: Sphere(radius: 100), force: 0.05";
    let slab = Scene::read("examples/scenes/heavy_slab.ron").unwrap();
    [
        format!("{cylinder}, stack: [{layer}, Receding, {ground}]"),
        format!("{cylinder}, stack: [{layer}, Receding(gap: Parabola(radius: 500)), {ground}]"),
        format!("{cylinder}, stack: [{none}, Receding, {layer}, Receding, {none}, Bonded, {ground}]"),
        format!("geometry: PlaneStrain, {punches}, stack: [{layer}, Receding, Rigid]"),
        format!("{sphere}, stack: [{layer}, Receding, {ground}]"),
    ]
    .iter()
    .map(|text| scene(text))
    .chain([slab])
    .collect()
}

fn deformed(scene: &Scene, times: Option<f64>) -> (Picture, FaceProfiles) {
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    let profile = model.profile(&scene.top, &solution, &profile_places(&solution, None, 200)).unwrap();
    (plot::deformed(scene, model.stack(), &solution, &profile, times).unwrap(), profile)
}

/// The upper and the lower face of each area that is drawn at all places of a profile, in points: layers come first.
fn areas(picture: &Picture, count: usize) -> Vec<[Vec<(f64, f64)>; 2]> {
    let svg = picture.svg();
    let numbers = |line: &str| -> Vec<f64> {
        let data = line.split('"').nth(1).unwrap().trim_matches(|c: char| c.is_alphabetic());
        data.split(' ').map(|number| number.parse().unwrap()).collect()
    };
    let faces = |line: &str| {
        let points: Vec<(f64, f64)> = numbers(line).chunks(2).map(|pair| (pair[0], pair[1])).collect();
        let (upper, lower) = points.split_at(points.len() / 2);
        [upper.to_vec(), lower.iter().rev().copied().collect()]
    };
    let drawn = svg.lines().filter(|line| line.contains("fill-rule"));
    drawn.map(faces).filter(|[upper, lower]| upper.len() == count && lower.len() == count).collect()
}

/// The factor that the picture names.
fn factor(picture: &Picture) -> f64 {
    let labels = picture.labels();
    let of =
        |(label, _): &(String, _)| Some(label.strip_prefix("displacements drawn × ")?.split(',').next()?.to_owned());
    let text = labels.iter().find_map(of).unwrap();
    text.parse().unwrap_or_else(|_| panic!("{text}"))
}

#[test]
fn what_is_drawn_apart_is_apart_as_far_as_the_profile_says() {
    for (i, scene) in scenes().iter().enumerate() {
        for times in [None, Some(20.0)] {
            let (picture, profile) = deformed(scene, times);
            let x = &profile.x;
            let faces = areas(&picture, x.len());
            let per_length = (faces[0][0][x.len() - 1].0 - faces[0][0][0].0) / (x[x.len() - 1] - x[0]);
            let up = factor(&picture) * per_length;
            assert!(times.is_none_or(|times| times == factor(&picture)), "scene {i}");
            let own = profile.contacts.iter().find(|own| own.interface != Interface::Punch).unwrap();
            let gap = own.gap.as_ref().unwrap();
            let ground = faces[0][1].iter().map(|(_, y)| *y).fold(f64::MIN, f64::max);
            for k in 0..x.len() {
                let below = faces.get(1).map_or(ground, |[upper, _]| upper[k].1);
                let drawn = below - faces[0][1][k].1;
                assert!((drawn - up * gap[k]).abs() < 0.03, "scene {i}, x = {}: {drawn} {}", x[k], up * gap[k]);
            }
            let largest = gap.iter().copied().fold(0.0, f64::max);
            assert!(largest > 0.0 && (i == 5 || times.is_some() || up * largest > 2.0), "scene {i}: {}", up * largest);
            // the upper face of the stack goes as far as the field says
            let v = |k: usize| profile.faces.iter().find(|face| face.side == FaceSide::Top).unwrap().points[k].v;
            for k in 0..x.len() {
                let drawn = faces[0][0][0].1 - faces[0][0][k].1;
                assert!((drawn - up * (v(k) - v(0))).abs() < 0.03, "scene {i}, x = {}", x[k]);
            }
        }
    }
}

#[test]
fn a_half_plane_is_counted_from_the_sides_of_the_picture() {
    let scene = &scenes()[0];
    let (picture, profile) = deformed(scene, Some(50.0));
    let faces = areas(&picture, profile.x.len());
    let [layer, ground] = &faces[..] else { panic!("{} areas", faces.len()) };
    let (first, last) = (ground[0][0].1, ground[0][profile.x.len() - 1].1);
    let lowest = ground[0].iter().map(|(_, y)| *y).fold(f64::MIN, f64::max);
    assert!((first - last).abs() < 0.02 && lowest > first + 5.0, "{first} {last} {lowest}");
    assert!(ground[1].iter().all(|(_, y)| *y == ground[1][0].1), "the lower end of the drawing is straight");
    assert!(layer[0].len() == profile.x.len());
    assert!(picture.labels().iter().any(|(label, _)| label.ends_with("from both ends of the top face of layer 2")));
}

#[test]
fn displaced_stacks_are_fit_to_print() {
    let folders = ["examples/scenes", "examples/axisymmetric"];
    let files = folders.into_iter().flat_map(|folder| fs::read_dir(folder).unwrap());
    let examples = files.map(|entry| Scene::read(entry.unwrap().path()).unwrap());
    for scene in examples.chain(scenes()) {
        let (picture, _) = deformed(&scene, None);
        assert_eq!(picture.faults(), Vec::<String>::new(), "{}", scene.title());
        let (width, height) = picture.size();
        assert!(width < 800.0 && height < 700.0, "{}: {width} x {height}", scene.title());
    }
}

#[test]
fn what_has_no_place_in_the_picture_is_refused() {
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("deformed.svg");
    let on_half_plane =
        "Scene(geometry: PlaneStrain, load: Line, force: 1, stack: [HalfPlane(shear_modulus: 1, poisson: 0.25)])";
    let loose = "Scene(geometry: PlaneStrain, punch: Cylinder(radius: 100), force: 0.01, stack: [
        Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, Rigid])";
    for (scene, times, said) in [
        (on_half_plane, "1", "a line load presses on the place from which they are counted"),
        (loose, "1e9", "do not fit, × "),
        (loose, "0", "found `0`, allowed is a number > 0"),
        (loose, "twice", "found `twice`, allowed is a number > 0"),
    ] {
        let run = recede(&["plot", "-", "--deformed", times, "--out", file.to_str().unwrap()], scene.as_bytes());
        assert!(run.status == Some(2) && run.stderr.contains(said), "{times}: {:?} {}", run.status, run.stderr);
    }
    let run = recede(&["plot", "-", "--deformed", "--out", file.to_str().unwrap()], loose.as_bytes());
    assert_eq!((run.status, &run.stderr[..]), (Some(0), ""));
    assert!(fs::read_to_string(&file).unwrap().contains("counted from the rigid base"));
}
