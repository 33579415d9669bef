//! Profiles along x.
//!
//! Goal: bodies touch where they are said to, and are apart elsewhere; slopes are derivatives of displacements, and inside its contact the top
//! face is as steep as the punch; on a half-plane the gap is that of Hertz.
use crate::support::recede;

use recede::{FaceProfiles, Model, Scene, Solution, profile_places};

fn scene(text: &str) -> Scene {
    Scene::from_ron(text).unwrap()
}

fn profile(scene: &Scene, x: &dyn Fn(&Solution) -> Vec<f64>) -> (Solution, FaceProfiles) {
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap();
    let profile = model.profile(&scene.top, &solution, &x(&solution)).unwrap();
    (solution, profile)
}

/// Scenes of all kinds.
fn scenes() -> Vec<Scene> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scenes");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<_> = files.filter(|file| file.extension().is_some_and(|ending| ending == "ron")).collect();
    files.sort();
    files.iter().map(|file| Scene::read(file).unwrap()).collect()
}

#[test]
fn bodies_touch_where_they_are_said_to_and_nowhere_else() {
    for scene in scenes() {
        let name = scene.title();
        let (solution, profile) = profile(&scene, &|solution| profile_places(solution, None, 300));
        assert_eq!(profile.contacts.len(), solution.contacts().len() + solution.closed().len(), "{name}");
        for (found, contact) in profile.contacts.iter().zip(solution.contacts()) {
            let inside = |x: f64| contact.intervals().iter().any(|i| i.left <= x && x <= i.right);
            let Some(gaps) = &found.gap else { continue };
            let largest = gaps.iter().copied().fold(0.0, f64::max);
            for ((x, gap), pressure) in profile.x.iter().zip(gaps).zip(&found.pressure) {
                assert_eq!(inside(*x), *gap == 0.0, "{name}, {}: {gap:e} at {x}", contact.interface);
                assert!(
                    *gap >= 0.0 && (*pressure == 0.0 || inside(*x)),
                    "{name} {}: {gap:e} {pressure:e} at {x}",
                    contact.interface
                );
            }
            assert!(largest > 0.0, "{name}, {}", contact.interface);
        }
    }
}

#[test]
fn pressures_come_to_the_force() {
    for scene in scenes() {
        let (solution, profile) = profile(&scene, &|solution| profile_places(solution, None, 2000));
        for (found, contact) in profile.contacts.iter().zip(solution.contacts()) {
            if found.pressure.iter().any(|pressure| pressure.is_infinite()) {
                continue;
            }
            let pairs = profile.x.windows(2).zip(found.pressure.windows(2));
            let force: f64 = pairs.map(|(x, p)| 0.5 * (x[1] - x[0]) * (p[0] + p[1])).sum();
            let off = force / contact.resultant - 1.0;
            // a uniform load ends with a jump
            let allowed = if scene.top.loads().is_some() { 2e-2 } else { 1e-4 };
            assert!(off.abs() < allowed, "{}, {}: {off:e}", scene.title(), contact.interface);
        }
    }
}

#[test]
fn slopes_are_derivatives_of_displacements() {
    for scene in scenes() {
        let far = |solution: &Solution| solution.extent().unwrap_or(1.0);
        let places = |solution: &Solution| {
            let (length, step) = (far(solution), 1e-3 * far(solution));
            [-1.7, -0.31, 0.177, 0.53, 1.21, 1.83]
                .iter()
                .flat_map(|s| [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| s * length + k * step))
                .collect()
        };
        let (solution, profile) = profile(&scene, &places);
        let (step, size) = (1e-3 * far(&solution), |v: &[f64]| v.iter().fold(0.0, |most: f64, v| most.max(v.abs())));
        let slopes: Vec<f64> = profile.faces.iter().flat_map(|face| &face.points).map(|point| point.slope).collect();
        let steepest = size(&slopes);
        for face in &profile.faces {
            let v: Vec<f64> = face.points.iter().map(|point| point.v).collect();
            let slopes: Vec<f64> = face.points.iter().map(|point| point.slope).collect();
            for (v, slope) in v.chunks(5).zip(slopes.chunks(5)) {
                let difference = (v[0] - 8.0 * v[1] + 8.0 * v[3] - v[4]) / (12.0 * step);
                let off = (difference - slope[2]).abs() / steepest;
                assert!(off < 3e-5, "{} layer {} {:?}: {off:e}", scene.title(), face.layer, face.side);
            }
        }
    }
}

#[test]
fn the_top_face_follows_the_punch() {
    // a face that gives way does not keep its profile
    let is_rigid = |scene: &&Scene| {
        scene.top.material().is_none() && scene.top.punch().is_none_or(|punch| punch.cover().is_none())
    };
    for scene in scenes().iter().filter(|scene| scene.top.loads().is_none()).filter(is_rigid) {
        let inside = |solution: &Solution| {
            let interval = *solution.contacts()[0].intervals().last().unwrap();
            [0.2, 0.55, 0.8].map(|s| interval.left + s * (interval.right - interval.left)).to_vec()
        };
        let (solution, profile) = profile(scene, &inside);
        let steepest = scene.top.punch().unwrap().slope(0.999 * solution.contacts()[0].reach()).abs();
        for point in &profile.faces[0].points {
            let off = (point.slope - scene.top.punch().unwrap().slope(point.x)).abs();
            assert!(off <= 1e-7 * steepest + 1e-10, "{}: {off:e} of {steepest:e} at {}", scene.title(), point.x);
        }
    }
}

#[test]
fn gaps_on_a_half_plane_are_those_of_hertz() {
    let (radius, s) = (500.0, [1.0001, 1.01, 1.3, 3.0, 10.0]);
    // a circle is higher than its parabola by the square of x/R
    let punches =
        [("Parabola(radius: 500)", 1e-8), ("ElasticCylinder(radius: 500, shear_modulus: 2, poisson: 0.4)", 1e-7)];
    for (punch, allowed) in punches {
        let text = format!(
            "Scene(geometry: PlaneStrain, punch: {punch}, force: 1e-6, stack: [HalfPlane(shear_modulus: 1, poisson: 0.25)])"
        );
        let (solution, profile) =
            profile(&scene(&text), &|solution| s.map(|s| s * solution.contacts()[0].reach()).to_vec());
        let a = solution.contacts()[0].reach();
        for (s, gap) in s.iter().zip(profile.contacts[0].gap.as_ref().unwrap()) {
            let root = (s * s - 1.0).sqrt();
            let expected = a * a / (2.0 * radius) * (s * root - (s + root).ln());
            // next to the end the displacements of both bodies are much larger than the gap
            assert!(
                (gap - expected).abs() <= allowed * expected + 1e-12 * a * a / radius,
                "{punch}: {gap:e} {expected:e} at {s} a"
            );
        }
    }
}

#[test]
fn the_command_writes_columns_that_need_no_quotes() {
    let run = recede(&["profile", "examples/scenes/two_wheels.ron", "--points", "50", "--to", "3"], b"");
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    let lines: Vec<Vec<&str>> = run.stdout.lines().map(|line| line.split(',').collect()).collect();
    assert!(lines[0].iter().all(|name| name.bytes().all(|c| c.is_ascii_alphanumeric() || c == b'_')), "{:?}", lines[0]);
    assert!(lines.iter().all(|line| line.len() == lines[0].len()));
    assert_eq!((lines[1][0], *lines.last().unwrap().first().unwrap()), ("-3.0", "3.0"));
    let refused = recede(&["profile", "examples/scenes/hertz.ron", "--to", "-1"], b"");
    assert!(refused.status == Some(2) && refused.stderr.contains("allowed is a length > 0"), "{}", refused.stderr);
}

/// A wedge that rises hardly more than the face below it sinks, and a punch beside it: the gap to each of them is looked at half of the way to the other one.
#[test]
fn gaps_are_the_ones_of_the_punch_that_is_there() {
    let scene = scene(
        "Scene(geometry: PlaneStrain, punches: [(shape: Wedge(slope: 0.00125), at: 0.0, force: 19.0, tilt: Free(eccentricity: 100.0)), \
         (shape: RoundedFlat(half_width: 142.0, radius: 209000.0), at: 1600.0, force: 19.0, tilt: Free(eccentricity: 2.5))], \
         stack: [Homogeneous(thickness: 31.6, shear_modulus: 100.0, poisson: 0.0), Spring(normal: 0.0086, tangential: 0.7), \
         HalfPlane(shear_modulus: 100.0, poisson: -0.5)])",
    );
    let (solution, profile) = profile(&scene, &|solution| profile_places(solution, None, 200));
    let gaps = || profile.x.iter().zip(profile.contacts[0].gap.as_ref().unwrap());
    let largest = gaps().fold(0.0, |most: f64, (_, gap)| most.max(*gap));
    let right = solution.contacts()[0].intervals().last().unwrap().right;
    assert!(gaps().any(|(x, gap)| *x > 1.2 * right && *gap > 0.0));
    for (x, gap) in gaps() {
        assert!(*gap >= -1e-9 * largest, "{gap} at {x}, the largest {largest}");
    }
}
