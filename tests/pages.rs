//! Pages of pictures have the size, and their letters the height, that are asked for.
use crate::support;

use std::fs;
use std::path::Path;

use recede::Scene;
use recede::plot::{self, Picture};
use support::recede;

const SCENE: &str = "examples/scenes/strip_fgm_half_plane.ron";

fn run(options: &[&str], name: &str) -> (Option<i32>, String, String) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pages");
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join(name);
    let out = if options[0] == "sweep" { "--plot" } else { "--out" };
    let run = recede(&[options, &[out, file.to_str().unwrap()]].concat(), b"");
    (run.status, run.stderr, fs::read_to_string(&file).unwrap_or_default())
}

#[test]
fn a_page_has_the_size_that_is_asked_for() {
    for command in [&["plot", SCENE][..], &["field", SCENE], &["sweep", SCENE, "--vary", "force=[0.001,0.002,0.004]"]] {
        let (status, said, svg) = run(&[command, &["--size", "320x500", "--title"]].concat(), "sized.svg");
        assert_eq!((status, &said[..]), (Some(0), ""), "{command:?}");
        assert!(svg.contains("width=\"320\" height=\"500\""), "{command:?}: {}", &svg[..200]);
    }
}

/// The distance of two labels tells by how much a picture was enlarged.
#[test]
fn letters_have_the_size_that_is_asked_for() {
    let scene = Scene::read(SCENE).unwrap();
    let stack = || plot::stack(&scene, &scene.stack().unwrap(), &recede::solve(&scene).unwrap());
    let width = |picture: &Picture| {
        let labels = picture.labels();
        let frame = labels.iter().find(|(text, _)| text == "cylinder").unwrap().1;
        frame.right - frame.left
    };
    let (plain, large) = (stack(), stack().sized(None, Some(15.0)).unwrap());
    assert!((width(&large) / width(&plain) - 1.5).abs() < 1e-4);
    assert!((large.size().0 / plain.size().0 - 1.5).abs() < 1e-9);
    let both = stack().sized(Some((700.0, 900.0)), Some(9.0)).unwrap();
    assert!((width(&both) / width(&plain) - 0.9).abs() < 1e-4 && both.size() == (700.0, 900.0));
    let shown = stack().sized(Some((330.0, 900.0)), None).unwrap();
    assert!((width(&shown) / width(&plain) - 330.0 / plain.size().0).abs() < 1e-4);
    for picture in [large, both, shown] {
        assert_eq!(picture.faults(), Vec::<String>::new());
    }
}

#[test]
fn pages_that_cannot_be_are_refused() {
    for (options, said) in [
        (["--size", "400"], "found `400`, expected WIDTHxHEIGHT as in 400x300, each from 50 to 5000"),
        (["--size", "10x400"], "each from 50 to 5000"),
        (["--font-size", "0"], "found `0`, allowed is a number from 1 to 100"),
    ] {
        let (status, found, _) = run(&[&["plot", SCENE], &options[..]].concat(), "refused.svg");
        assert!(status == Some(2) && found.contains(said), "{options:?}: {found}");
    }
    let (status, said, _) = run(&["plot", SCENE, "--size", "300x300", "--font-size", "10"], "refused.svg");
    assert!(status == Some(2) && said.contains("letters of 10 points need a page of 551 x 4"), "{said}");
}

#[test]
fn layers_are_labelled_by_the_modulus_that_the_scene_gives() {
    let layers = "stack: [Homogeneous(thickness: 1, young: 2.5, poisson: 0.25), Bonded, HalfPlane(shear_modulus: 3, poisson: 0.25)]";
    let text = format!(
        "Scene(geometry: PlaneStress, units: (length: \"um\", force: \"uN\"), punch: Cylinder(radius: 100), force: 0.01, {layers})"
    );
    let scene = Scene::from_ron(&text).unwrap();
    let picture = plot::stack(&scene, &scene.stack().unwrap(), &recede::solve(&scene).unwrap());
    let labels = picture.labels();
    for wanted in ["h₁ = 1 µm, E₁ = 2.5 ", "μ₂ = 3 ", "radius R = 100 µm", "P = 0.01 µN/µm"] {
        assert!(labels.iter().any(|(text, _)| text.starts_with(wanted)), "{wanted}: {labels:?}");
    }
}
