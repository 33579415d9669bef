//! Pictures: SVG and PNG appear whole, name what they show with units, and show the numbers that were solved.
use crate::support;

use std::fs;
use std::path::{Path, PathBuf};

use recede::plot::{self, Anchor, Picture, style};
use support::recede;
use tiny_skia::Pixmap;

const SCENE: &str = "examples/scenes/strip_fgm_half_plane.ron";

fn file(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("plot");
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join(name);
    let _ = fs::remove_file(&file);
    file
}

fn plot(scene: &str, name: &str) -> Vec<u8> {
    let file = file(name);
    let run = recede(&["plot", scene, "--out", file.to_str().unwrap()], b"");
    assert_eq!((run.status, &run.stdout[..], &run.stderr[..]), (Some(0), "", ""), "{scene}");
    fs::read(file).unwrap()
}

/// All text of a picture without its markup.
fn texts(svg: &[u8]) -> String {
    let svg =
        String::from_utf8(svg.to_vec()).unwrap().replace("<tspan font-style=\"italic\">", "").replace("</tspan>", "");
    let texts = svg.split("<text").skip(1).filter_map(|part| part.split_once('>')?.1.split_once("</text>"));
    texts.map(|(text, _)| text.trim()).collect::<Vec<_>>().join("|")
}

#[test]
fn a_picture_names_what_it_shows() {
    let shown = texts(&plot(SCENE, "stack.svg"));
    for text in [
        "P = 0.002",
        "Cylinder(radius: 500.0)",
        "a = 0.7373",
        "b = 2.449",
        "μ₁ = 1",
        "contact pressure, 10⁻³",
        "q(0) = ",
    ] {
        assert!(shown.contains(text), "{text}: {shown}");
    }
    let shown = texts(&plot("examples/scenes/bonded_to_rigid.ron", "rubber.svg"));
    for text in ["P = 1 N/mm", "(radius: 50.0)", "rigid", "contact pressure, N/mm²", "x, mm"] {
        assert!(shown.contains(text), "{text}: {shown}");
    }
}

#[test]
fn pictures_leave_the_files_beside_them_alone() {
    let beside = file("beside.svg.tmp");
    fs::write(&beside, "mine").unwrap();
    plot(SCENE, "beside.svg");
    assert_eq!(fs::read(beside).unwrap(), b"mine");
    // threads that draw the same picture do not take away each other's unfinished one
    let shared = file("shared.svg");
    let picture = Picture::new(10.0, 10.0);
    std::thread::scope(|scope| {
        let draw = || (0..50).try_for_each(|_| plot::save(&shared, &picture));
        let threads = [scope.spawn(draw), scope.spawn(draw)];
        threads.into_iter().for_each(|thread| thread.join().unwrap().unwrap());
    });
    assert_eq!(fs::read_to_string(&shared).unwrap(), picture.svg());
}

#[test]
fn every_scene_can_be_drawn() {
    for entry in fs::read_dir("examples/scenes").unwrap() {
        let scene = entry.unwrap().path();
        let svg = String::from_utf8(plot(scene.to_str().unwrap(), "any.svg")).unwrap();
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"), "{scene:?}");
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{scene:?}");
    }
}

#[test]
fn pixels_are_those_of_the_drawing() {
    let png = plot(SCENE, "stack.png");
    assert_eq!(&png[..8], b"\x89PNG\r\n\x1a\n");
    let size = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
    assert!(size(16) > 1200 && size(20) > 900, "{} x {}", size(16), size(20));
}

#[test]
fn letters_are_there_whatever_fonts_the_computer_has() {
    let dark = |anchor: Anchor, text: &str| {
        let mut picture = Picture::new(60.0, 60.0);
        picture.text((30.0, 30.0), text, 10.0, style::INK, anchor);
        let pixmap = Pixmap::decode_png(&picture.png().unwrap()).unwrap();
        let dark: Vec<(u32, u32)> = (0..180)
            .flat_map(|x| (0..180).map(move |y| (x, y)))
            .filter(|(x, y)| pixmap.pixel(*x, *y).unwrap().red() < 128)
            .collect();
        let ends = |pick: fn(&(u32, u32)) -> u32| [dark.iter().map(pick).min(), dark.iter().map(pick).max()];
        (dark.len(), ends(|(x, _)| *x).map(Option::unwrap), ends(|(_, y)| *y).map(Option::unwrap))
    };
    // three pixels to a point; a small letter is 5.5 points high, and so are its pixels about the middle
    let (count, x, y) = dark(Anchor::Centre, "xxxx");
    assert!(count > 300, "{count}");
    assert!(x[0].abs_diff(180 - x[1]) < 6 && x[1] - x[0] > 60, "{x:?}");
    assert!(y[0].abs_diff(90 - 8) < 3 && y[1].abs_diff(90 + 8) < 3, "{y:?}");
    let (_, left, _) = dark(Anchor::Left, "xxxx");
    let (_, right, _) = dark(Anchor::Right, "xxxx");
    assert!(left[0].abs_diff(90) < 4 && right[1].abs_diff(90) < 4, "{left:?} {right:?}");
    // turned, it is as wide as it was high
    let (_, turned_x, turned_y) = dark(Anchor::Upwards, "xxxx");
    assert!(turned_x[1] - turned_x[0] < 24 && (turned_y[1] - turned_y[0]).abs_diff(x[1] - x[0]) < 4);
    // an index is smaller and lower, a symbol leans
    let (_, _, low) = dark(Anchor::Centre, &plot::subscript("xxxx"));
    assert!(low[1] > y[1] - 4 && low[0] > y[0] + 3, "{low:?} {y:?}");
    assert_ne!(dark(Anchor::Centre, &plot::italic("l")), dark(Anchor::Centre, "l"));
}

#[test]
fn what_cannot_be_drawn_is_refused_before_anything_is_solved() {
    for (arguments, said) in [
        (&["plot", SCENE, "--out", "stack.pdf"][..], "a picture is a file that ends in .svg or .png"),
        (&["plot", "nowhere.ron", "--out", "stack.svg"], "nowhere.ron: cannot be read"),
        (&["plot", SCENE, "--out", "/nowhere/stack.svg"], "/nowhere/stack.svg: "),
        (&["plot", SCENE], "--out"),
        (&["sweep", SCENE, "--vary", "force=[1]", "--plot", "curves.jpg"], "ends in .svg or .png"),
        (&["sweep", SCENE, "--vary", "force=[0.001]", "--plot", "curves.svg"], "a quantity that takes two values"),
        (&["field", SCENE, "--out", "map.pdf"], "does not say what to write"),
        (&["field", SCENE, "--out", "map.svg", "--at", "0,0"], "a map is drawn of a grid, not of points"),
        (&["field", SCENE, "--out", "map.svg", "--quantity", "von_mise"], "a similar value exists: 'von_mises'"),
        (&["field", SCENE, "--out", "map.svg", "--x", "0:0:1"], "a map needs two places along x and two depths"),
        (&["field", SCENE, "--out", "map.svg", "--depth", "1:1:1"], "a map needs two places along x and two depths"),
    ] {
        let run = recede(arguments, b"");
        assert_eq!(run.status, Some(2), "{arguments:?}: {}", run.stderr);
        assert!(run.stderr.contains(said), "{arguments:?}: {}", run.stderr);
    }
}

#[test]
fn a_sweep_draws_a_curve_for_each_of_the_other_values() {
    let (picture, rows) = (file("curves.svg"), file("curves.csv"));
    let arguments = |resume: &[&'static str]| {
        let vary = ["sweep", SCENE, "--vary", "punch.radius=[250,500,1000]", "--vary", "force=0.0005:0.004:8"];
        let out = ["--out", rows.to_str().unwrap(), "--plot", picture.to_str().unwrap()];
        let run = recede(&[&vary[..], &out[..], resume].concat(), b"");
        assert_eq!(run.status, Some(0), "{}", run.stderr);
        fs::read_to_string(&picture).unwrap()
    };
    let whole = arguments(&[]);
    let shown = texts(whole.as_bytes());
    for text in ["force P", "half-length a", "half-length b", "p(0)", "q(0)", "radius R", "250", "1000"] {
        assert!(shown.contains(text), "{text}: {shown}");
    }
    // rows that are read look like rows that are computed
    let text = fs::read_to_string(&rows).unwrap();
    fs::write(&rows, &text[..text.len() / 2]).unwrap();
    assert_eq!(arguments(&["--resume"]), whole);
}

fn map(scene: &str, name: &str, more: &[&str]) -> Vec<u8> {
    let file = file(name);
    let run = recede(&[&["field", scene, "--out", file.to_str().unwrap()], more].concat(), b"");
    assert_eq!((run.status, &run.stdout[..], &run.stderr[..]), (Some(0), "", ""), "{scene}");
    fs::read(file).unwrap()
}

#[test]
fn a_map_names_what_it_shows() {
    let svg = map(SCENE, "map.svg", &[]);
    assert!(svg.len() < 300_000, "{} bytes", svg.len());
    let shown = texts(&svg);
    for text in [
        "largest shear stress, 10⁻⁴",
        "P = 0.002",
        "a = 0.7373",
        "b = 2.449",
        "layer 3",
        "ring: ",
        "x = 0, depth 1 in layer 1",
    ] {
        assert!(shown.contains(text), "{text}: {shown}");
    }
    let shown = texts(&map("examples/scenes/bonded_to_rigid.ron", "rubber_map.svg", &["--quantity", "von_mises"]));
    for text in ["von Mises stress, N/mm²", "depth, mm", "a = 2.765 mm", "depths drawn × "] {
        assert!(shown.contains(text), "{text}: {shown}");
    }
}

#[test]
fn any_quantity_of_any_layer_can_be_mapped() {
    for (scene, quantity) in [
        ("hertz", "sigma_xx"),
        ("two_strips", "sigma_xy"),
        ("orthotropic_ply", "sigma_1"),
        ("plate_on_springs", "v"),
        ("stiffening_ground", "sigma_zz"),
        ("bonded_coating", "u"),
    ] {
        let scene = format!("examples/scenes/{scene}.ron");
        let svg = String::from_utf8(map(&scene, "any_map.svg", &["--quantity", quantity])).unwrap();
        assert!(svg.trim_end().ends_with("</svg>") && !svg.contains("NaN") && !svg.contains("inf"), "{scene}");
    }
    // a part of the stack, off the centre
    let shown = texts(&map(SCENE, "part.svg", &["--x", "1:3:50", "--depth", "0.5:1.5:30"]));
    assert!(shown.contains("layer 1") && shown.contains("layer 2") && !shown.contains("layer 3"), "{shown}");
}

#[test]
fn a_map_is_dark_where_the_stress_is_large() {
    let png = map("examples/scenes/hertz.ron", "map.png", &["--x", "-1:1:101", "--depth", "0:1:81"]);
    let pixmap = Pixmap::decode_png(&png).unwrap();
    // the map begins 62 points from the left and 72 from above, is 340 points wide and as high as it is deep, 3 pixels each
    let light = |x: f64, depth: f64| {
        let place = |at: f64| (3.0 * at) as u32;
        let pixel = pixmap.pixel(place(62.0 + 340.0 * (0.5 + 0.5 * x)), place(72.0 + 170.0 * depth)).unwrap();
        u32::from(pixel.red()) + u32::from(pixel.green()) + u32::from(pixel.blue())
    };
    // along the axis and beside it the shear stress is largest at 0.786 of the half-length 0.69
    let lights = [(0.9, 0.03), (0.9, 0.12), (0.0, 0.17), (0.0, 0.3), (0.0, 0.58)].map(|(x, depth)| light(x, depth));
    assert!(lights.is_sorted_by(|a, b| a > b), "{lights:?}");
}
