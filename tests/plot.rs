//! Pictures: SVG, PDF and PNG appear whole, name what they show with units, show the numbers that were solved, and are fit to
//! print: labels lie on the page, and not over each other or over colours.
use crate::support;

use std::fs;
use std::path::{Path, PathBuf};

use recede::plot::{self, Anchor, Picture, style};
use recede::report::SweepCsv;
use recede::{FieldQuantity, Model, Scene, Sweep};
use support::{recede, texts};
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

#[test]
fn a_picture_names_what_it_shows() {
    let shown = texts(&plot(SCENE, "stack.svg"));
    for text in [
        "P = 0.002",
        "cylinder",
        "R = 500",
        "heights drawn × 20",
        "a = 0.7373",
        "b = 2.449",
        "μ₁ = 1",
        "contact pressure, 10⁻³",
        "p, under the punch",
        "q, contact 2|3",
        "largest 0.001719",
    ] {
        assert!(shown.contains(text), "{text}: {shown}");
    }
    let shown = texts(&plot("examples/scenes/bonded_to_rigid.ron", "rubber.svg"));
    for text in ["P = 1 N/mm", "R = 50 mm", "rigid", "contact pressure, MPa", "x, mm"] {
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
        (&["plot", SCENE, "--out", "stack.jpg"][..], "a picture is a file that ends in .svg, .pdf or .png"),
        (&["plot", "nowhere.ron", "--out", "stack.svg"], "nowhere.ron: cannot be read"),
        (&["plot", SCENE, "--out", "/nowhere/stack.svg"], "/nowhere/stack.svg: "),
        (&["plot", SCENE], "--out"),
        (&["sweep", SCENE, "--vary", "force=[1]", "--plot", "curves.jpg"], "ends in .svg, .pdf or .png"),
        (&["sweep", SCENE, "--vary", "force=[0.001]", "--plot", "curves.svg"], "a quantity that takes two values"),
        (&["field", SCENE, "--out", "map.jpg"], "does not say what to write"),
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
    for text in ["force P", "half-length a", "half-length b", "largest p", "largest q", "radius R", "250", "1000"] {
        assert!(shown.contains(text), "{text}: {shown}");
    }
    // rows that are read look like rows that are computed
    let text = fs::read_to_string(&rows).unwrap();
    fs::write(&rows, &text[..text.len() / 2]).unwrap();
    assert_eq!(arguments(&["--resume"]), whole);
}

/// Where a label stands in a picture.
fn place(svg: &str, label: &str) -> (f64, f64) {
    let (_, after) = svg.split_once(&format!("aria-label=\"{label}\" transform=\"translate(")).unwrap();
    let (x, y) = after.split_once(')').unwrap().0.split_once(' ').unwrap();
    (x.parse().unwrap(), y.parse().unwrap())
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
        "cross: largest in the stack, 6.875·10⁻⁴ at x = 0, depth 1 in layer 1",
    ] {
        assert!(shown.contains(text), "{text}: {shown}");
    }
    let shown = texts(&map("examples/scenes/bonded_to_rigid.ron", "rubber_map.svg", &["--quantity", "von_mises"]));
    for text in [
        "von Mises stress, MPa",
        "depth, mm",
        "a = 2.765 mm",
        "depths drawn × ",
        "cross: largest on the grid of this map",
    ] {
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
    let grid = ["--x", "-1:1:101", "--depth", "0:1:81"];
    let svg = String::from_utf8(map("examples/scenes/hertz.ron", "map.svg", &grid)).unwrap();
    let pixmap = Pixmap::decode_png(&map("examples/scenes/hertz.ron", "map.png", &grid)).unwrap();
    // where the numbers at the axes stand, in points of three pixels
    let [(left, _), (right, _), (_, top), (_, bottom)] = ["−1.00", "1.00", "0.0", "1.0"].map(|at| place(&svg, at));
    let light = |x: f64, depth: f64| {
        let at = (0.5 * (left + right) + 0.5 * (right - left) * x, top + (bottom - top) * depth);
        let pixel = pixmap.pixel((3.0 * at.0) as u32, (3.0 * at.1) as u32).unwrap();
        u32::from(pixel.red()) + u32::from(pixel.green()) + u32::from(pixel.blue())
    };
    // along the axis and beside it the shear stress is largest at 0.786 of the half-length 0.69
    let lights = [(0.9, 0.03), (0.9, 0.12), (0.0, 0.17), (0.0, 0.3), (0.0, 0.58)].map(|(x, depth)| light(x, depth));
    assert!(lights.is_sorted_by(|a, b| a > b), "{lights:?}");
}

fn scene(text: &str) -> Scene {
    Scene::from_ron(&format!("Scene(geometry: PlaneStrain, {text})")).unwrap()
}

/// A stack of layers of this thickness, every second one loose, on a half-plane.
fn many_layers(count: usize) -> Scene {
    let layer = |i: usize| {
        let below = if i.is_multiple_of(2) { "Bonded" } else { "Receding" };
        format!("Homogeneous(thickness: 0.1, shear_modulus: {}, poisson: 0.3), {below}, ", 1 + i % 3)
    };
    let layers: String = (0..count).map(layer).collect();
    let stack = format!("stack: [{layers} HalfPlane(shear_modulus: 1, poisson: 0.25)]");
    scene(&format!("punch: Parabola(radius: 500), force: 0.02, {stack}"))
}

/// A hard coating of three micrometres on a loose plate: pressures differ by a factor of 200.
fn thin_coating() -> Scene {
    scene(
        "punch: Cylinder(radius: 10), force: 20, units: (length: \"mm\", force: \"N\"), stack: [
            Homogeneous(thickness: 0.003, shear_modulus: 1e5, poisson: 0.25), Bonded,
            Homogeneous(thickness: 2, shear_modulus: 8e4, poisson: 0.3), Receding,
            HalfPlane(shear_modulus: 1000, poisson: 0.3)]",
    )
}

fn examples() -> impl Iterator<Item = Scene> {
    let folders = ["examples/scenes", "examples/axisymmetric"];
    let files = folders.into_iter().flat_map(|folder| fs::read_dir(folder).unwrap());
    files.map(|entry| Scene::read(entry.unwrap().path()).unwrap())
}

fn stack(scene: &Scene) -> Picture {
    let model = Model::new(scene.stack().unwrap()).unwrap();
    plot::stack(scene, model.stack(), &model.press(&scene.top, scene.force).unwrap())
}

fn fit_to_print(picture: &Picture, what: &str) {
    assert_eq!(picture.faults(), Vec::<String>::new(), "{what}");
    let (width, height) = picture.size();
    assert!(width < 800.0 && height < 700.0, "{what}: {width} x {height}");
}

#[test]
fn stacks_are_fit_to_print() {
    let long_units = "units: (length: \"hundred millimetres\", force: \"kilogramme-force\")";
    let base = "stack: [HalfPlane(shear_modulus: 1, poisson: 0.25)]";
    let others = [
        many_layers(60),
        thin_coating(),
        scene(&format!("punch: Cylinder(radius: 0.6), force: 0.3, {base}")),
        scene(&format!("punch: Table([(0, 0), (0.5, 0.1), (1, 0.5)]), force: 0.3, {base}, {long_units}")),
        scene(&format!("loads: [(load: Line, at: -1, force: 1), (load: Line, at: 3, force: 1)], {base}")),
    ];
    for scene in examples().chain(others) {
        let what = scene.title().to_owned();
        fit_to_print(&stack(&scene), &what);
        fit_to_print(&stack(&scene).titled(&"a long title ".repeat(50)), &what);
    }
}

#[test]
fn axes_reach_from_the_leftmost_to_the_rightmost_load() {
    let loads = "loads: [(load: Line, at: 5.5, force: 0.2), (load: Line, at: 7, force: 0.8)]";
    let labels = stack(&scene(&format!("{loads}, stack: [HalfPlane(shear_modulus: 1, poisson: 0.25)]"))).labels();
    let all = ["5.5", "6.0", "7.0", "P = 1 in all"].iter().all(|text| labels.iter().any(|(label, _)| label == text));
    assert!(all && !labels.iter().any(|(label, _)| label.starts_with('−')), "{labels:?}");
}

#[test]
fn maps_are_fit_to_print() {
    let quantities = [FieldQuantity::MaxShear, FieldQuantity::SigmaXx, FieldQuantity::SigmaYy, FieldQuantity::V];
    for (i, scene) in examples().chain([thin_coating(), many_layers(20)]).enumerate() {
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let solution = model.press(&scene.top, scene.force).unwrap();
        let field = model.field(&solution).unwrap();
        let longest = solution.extent().unwrap_or(1.0);
        let (_, [_, bottom]) = field.layers().last().unwrap();
        let steps = |from: f64, to: f64| (0..=30).map(|k| from + (to - from) * f64::from(k) / 30.0).collect::<Vec<_>>();
        let grids =
            field.by_layer(&steps(-2.0 * longest, 2.0 * longest), &steps(0.0, bottom.min(3.0 * longest))).unwrap();
        // under a line load on a half-plane displacements are infinite
        let number = if scene.top.loads().is_some() { 0 } else { i % quantities.len() };
        let picture = plot::map(&scene, &solution, &field, &grids, quantities[number]).unwrap();
        fit_to_print(&picture, &format!("{} {}", scene.title(), quantities[number].name()));
    }
}

fn sweep(scene: Scene, axes: &[&str]) -> Picture {
    let sweep = Sweep::new(scene, axes.iter().map(|axis| axis.parse().unwrap()).collect()).unwrap();
    let csv = SweepCsv::new(&sweep);
    let points: Vec<_> = sweep.rows().map(|row| csv.point(&row)).collect();
    plot::sweep(&sweep, &points, &plot::DrawnColumns::default()).unwrap()
}

#[test]
fn sweeps_are_fit_to_print_and_mark_what_is_missing() {
    let said = |picture: &Picture, text: &str| picture.labels().iter().any(|(label, _)| label.contains(text));
    let maps = sweep(Scene::read(SCENE).unwrap(), &["force=0.0005:0.004:7", "layer[2].beta=1:-1:6"]);
    assert_eq!(maps.faults(), Vec::<String>::new());
    assert!(said(&maps, "force P") && said(&maps, "grading exponent β₂") && said(&maps, "half-length b"));
    let curves = sweep(Scene::read(SCENE).unwrap(), &["force=0.0005:0.004:7", "layer[2].beta=[-1, 0, 1]"]);
    assert_eq!(curves.faults(), Vec::<String>::new());
    assert!(!said(&curves, "no solution"));
    // more than the punch can carry
    let base = "stack: [HalfPlane(shear_modulus: 1, poisson: 0.25)]";
    let table = scene(&format!("punch: Table([(0, 0), (0.5, 0.1), (1, 0.5)]), force: 0.3, {base}"));
    let marked = sweep(table, &["force=0.1:9:9"]);
    assert!(said(&marked, "cross: no solution") && marked.faults().is_empty(), "{:?}", marked.labels());
    // of many contacts the first ones
    let many = sweep(many_layers(20), &["force=[0.01, 0.02]"]);
    assert!(said(&many, "not drawn: 5 more contacts") && many.faults().is_empty(), "{:?}", many.faults());
}

#[test]
fn every_interval_in_which_bodies_touch_is_drawn() {
    for scene in examples() {
        let solution = recede::solve(&scene).unwrap();
        // two wheels, one of them behind the other
        let all = if solution.axes().is_empty() { solution.contacts() } else { &solution.contacts()[..1] };
        // layers that weights press together touch between openings and beyond them
        let closed = solution.closed().iter().map(|own| own.openings.len() + 1);
        let touching: usize = all.iter().map(|contact| contact.intervals().len()).chain(closed).sum();
        assert_eq!(stack(&scene).svg().matches("stroke-width=\"3\"").count(), touching, "{}", scene.title());
    }
}

#[test]
fn uniform_loads_have_upright_sides_and_punches_no_brim() {
    let points = |svg: &str, width: &str| -> Vec<(f64, f64)> {
        let line = svg.lines().find(|line| line.contains(&format!("stroke-width=\"{width}\""))).unwrap();
        let path = line.split('"').nth(1).unwrap().trim_start_matches('M');
        let numbers: Vec<f64> = path.split(' ').map(|number| number.parse().unwrap()).collect();
        numbers.chunks(2).map(|pair| (pair[0], pair[1])).collect()
    };
    let base = "stack: [HalfPlane(shear_modulus: 1, poisson: 0.25)]";
    let load = points(&stack(&scene(&format!("load: Uniform(half_width: 1), force: 1, {base}"))).svg(), "1");
    let highest = load.iter().map(|(_, y)| *y).fold(f64::INFINITY, f64::min);
    let at = |pick: fn(f64, f64) -> f64, upper: bool| {
        let points = load.iter().filter(|(_, y)| !upper || *y == highest).map(|(x, _)| *x);
        points.reduce(pick).unwrap()
    };
    assert_eq!((at(f64::min, true), at(f64::max, true)), (at(f64::min, false), at(f64::max, false)));
    // a cylinder leaves the drawing above where it is narrower than below: its outline rises all the way
    let steep = points(&stack(&scene(&format!("punch: Cylinder(radius: 0.6), force: 0.3, {base}"))).svg(), "1");
    let right: Vec<f64> = steep.iter().skip(steep.len() / 2 + 1).map(|(_, y)| *y).collect();
    let from = right.iter().rposition(|y| *y == right[0]).unwrap();
    assert!(right[from..].is_sorted_by(|a, b| a > b), "{right:?}");
}

#[test]
fn a_narrow_load_has_an_arrow_in_its_middle() {
    let arrows = |half_width: f64| {
        let scene = scene(&format!(
            "load: Uniform(half_width: {half_width}), force: 1, stack: [
                Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, HalfPlane(shear_modulus: 1, poisson: 0.25)]"
        ));
        let svg = stack(&scene).svg();
        let paths =
            svg.lines().filter(|line| line.contains("stroke-width=\"1\"")).filter_map(|line| line.split('"').nth(1));
        let points = paths.map(|path| {
            let numbers = path.trim_start_matches('M').split(' ').filter_map(|number| number.parse().ok());
            numbers.collect::<Vec<f64>>()
        });
        points.filter(|path| path.len() == 4 && path[0] == path[2]).count()
    };
    let counts = [2.0, 0.5, 0.1, 0.02].map(arrows);
    assert!(counts.is_sorted_by(|a, b| a >= b) && counts[0] > 4 && counts[3] == 1, "{counts:?}");
}

#[test]
fn pressures_that_differ_much_are_drawn_in_parts_of_their_largest() {
    let said = |scene: &Scene, text: &str| stack(scene).labels().iter().any(|(label, _)| label.contains(text));
    assert!(said(&thin_coating(), "pressure / its largest") && said(&thin_coating(), "largest 381 MPa"));
    assert!(said(&thin_coating(), "depths not to scale"));
    assert!(!said(&Scene::read(SCENE).unwrap(), "its largest"));
}

#[test]
fn a_page_of_pdf_is_whole_and_always_the_same() {
    let [once, again] = ["stack.pdf", "again.pdf"].map(|name| plot(SCENE, name));
    assert!(once.starts_with(b"%PDF-") && once.trim_ascii_end().ends_with(b"%%EOF"));
    assert_eq!(once, again);
    assert!(once.len() > 5_000 && once.windows(9).any(|part| part == b"/MediaBox"), "{}", once.len());
    let map = map(SCENE, "map.pdf", &["--quantity", "sigma_xx", "--title=Stresses along the layers"]);
    assert!(map.starts_with(b"%PDF-"));
}

#[test]
fn titles_are_written_on_request() {
    let title = |more: &[&str]| {
        let file = file("titled.svg");
        let run = recede(&[&["plot", SCENE, "--out", file.to_str().unwrap()], more].concat(), b"");
        assert_eq!(run.status, Some(0), "{}", run.stderr);
        texts(&fs::read(file).unwrap())
    };
    assert!(!title(&[]).contains("strip_fgm"));
    assert!(title(&["--title"]).contains("strip_fgm_half_plane"));
    assert!(title(&["--title=A & B"]).contains("A &amp; B"));
}

/// Whatever fonts a reader has: the pictures of the documents have none of their own.
#[test]
fn pictures_of_documents_need_no_font() {
    let folders = ["docs", "docs/figures", "docs/pictures"];
    let files = folders.iter().flat_map(|folder| fs::read_dir(folder).unwrap()).map(|entry| entry.unwrap().path());
    let pictures: Vec<PathBuf> = files.filter(|file| file.extension().is_some_and(|ending| ending == "svg")).collect();
    assert!(pictures.len() > 12, "{pictures:?}");
    for file in pictures {
        let svg = fs::read_to_string(&file).unwrap();
        assert!(!svg.contains("<text") && svg.contains("aria-label"), "{}", file.display());
    }
}
