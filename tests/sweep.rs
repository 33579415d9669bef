//! Sweeps: the same numbers on any thread, a file that survives interruption, rows for scenes without solution.
use crate::support;

use std::fs;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::thread;
use std::time::Duration;

use recede::report::SweepCsv;
use recede::{Axis, Error, Force, Item, Punch, Scene, Sweep};
use support::recede;

const SCENE: &str = "examples/scenes/strip_fgm_half_plane.ron";

fn file(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("sweep");
    fs::create_dir_all(&folder).unwrap();
    folder.join(name)
}

fn sweep(axes: &[&str]) -> Sweep {
    let axes = axes.iter().map(|axis| axis.parse::<Axis>().unwrap()).collect();
    Sweep::new(Scene::read(SCENE).unwrap(), axes).unwrap()
}

/// What `recede sweep` writes to a file.
fn written(name: &str, arguments: &[&str]) -> String {
    let path = file(name);
    let run = recede(&[&["sweep", SCENE, "--out", path.to_str().unwrap()], arguments].concat(), b"");
    assert_eq!((run.status, &run.stdout[..]), (Some(0), ""), "{}", run.stderr);
    fs::read_to_string(path).unwrap()
}

#[test]
fn rows_are_those_of_single_scenes() {
    let sweep = sweep(&["layer[2].beta=[-1,0.5]", "punch.radius=[250,500]", "layer[3].shear_modulus=[1,4]"]);
    let rows: Vec<_> = sweep.rows().collect();
    assert_eq!(rows.len(), 8);
    assert_eq!(rows[3].values, [-1.0, 500.0, 4.0]);
    assert_eq!(rows[4].values, [0.5, 250.0, 1.0]);
    for row in rows {
        let scene = sweep.scene_at(row.index).unwrap();
        assert_eq!(row.result.unwrap(), recede::solve(&scene).unwrap(), "{:?}", row.values);
    }
}

#[test]
fn a_tolerance_is_that_of_all_rows() {
    let of = |name: &str, tolerance: &str| {
        let text = written(name, &["--vary", "punch.radius=[250,500]", "--tolerance", tolerance]);
        let rows = text.lines().skip(1).map(|row| row.split(',').map(str::to_owned).collect::<Vec<_>>());
        // radius, then a and its error
        rows.map(|row| [row[1].parse::<f64>().unwrap(), row[2].parse::<f64>().unwrap()]).collect::<Vec<_>>()
    };
    let (rough, fine) = (of("rough.csv", "1e-4"), of("fine.csv", "1e-11"));
    for ([a, error], [exact, least]) in rough.iter().zip(&fine) {
        assert!(
            (a - exact).abs() <= 10.0 * error && error / a <= 1e-4 && least / exact <= 1e-11,
            "{a} {error} {least}"
        );
        assert!(error > least);
    }
}

#[test]
fn numbers_do_not_depend_on_threads_nor_on_where_one_begins() {
    let sweep = Arc::new(sweep(&["punch.radius=100:1000:11", "layer[2].beta=[-1,1]", "force=0.001:0.004:9"]));
    assert!(sweep.len() > 3 * 64, "chunks have more than one row");
    let csv = SweepCsv::new(&sweep);
    let alone: Vec<String> = sweep.rows().map(|row| csv.line(&row).unwrap()).collect();
    assert_eq!(alone.len(), sweep.len());
    for threads in [2, 4] {
        let rows = sweep.parallel_rows(0..sweep.len(), NonZeroUsize::new(threads).unwrap());
        assert!(rows.map(|row| csv.line(&row).unwrap()).eq(alone.iter().cloned()), "{threads} threads");
    }
    for first in [7, 150, 198] {
        assert!(
            sweep.rows_in(first..sweep.len()).map(|row| csv.line(&row).unwrap()).eq(alone[first..].iter().cloned())
        );
        let rows = sweep.parallel_rows(first..sweep.len(), NonZeroUsize::MIN);
        assert!(rows.map(|row| csv.line(&row).unwrap()).eq(alone[first..].iter().cloned()));
    }
    // the receiver may stop at any row
    assert_eq!(sweep.parallel_rows(0..sweep.len(), NonZeroUsize::new(2).unwrap()).take(3).count(), 3);
}

#[test]
fn a_scene_without_solution_is_a_row() {
    let sweep = sweep(&["punch.radius=[500,0.0001]", "layer[2].beta=[-1,-60]", "layer[2].thickness=[1,2]"]);
    let csv = SweepCsv::new(&sweep);
    let rows: Vec<_> = sweep.rows().collect();
    assert!(rows[0].result.is_ok());
    assert!(matches!(rows[3].result, Err(Error::Scene(_))), "beta h = -120: {:?}", rows[3].result);
    assert!(matches!(rows[4].result, Err(Error::NoSolution(_))), "a needle: {:?}", rows[4].result);
    let line = csv.line(&rows[4]).unwrap();
    assert!(
        line.contains("bad_input,,\"") || line.contains("bad_input,,the punch Cylinder(radius: 0.0001) cannot"),
        "{line}"
    );
    let columns = csv.header().unwrap().split(',').count();
    for row in &rows {
        let line = csv.line(row).unwrap();
        let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(line.as_bytes());
        let fields: Vec<_> = reader.records().map(|record| record.unwrap().len()).collect();
        assert_eq!(fields, [columns], "{line}");
    }
}

#[test]
fn contacts_are_found_though_the_first_row_has_no_solution() {
    let sweep = sweep(&["layer[2].beta=[-60,-1]", "layer[2].thickness=[0,1]"]);
    let header = SweepCsv::new(&sweep).header().unwrap();
    assert!(header.contains("contact_1_3_half_length") && header.contains("contact_2_3_half_length"), "{header}");
    let solved: Vec<bool> = sweep.rows().map(|row| row.result.is_ok()).collect();
    assert_eq!(solved, [true, false, true, true]);
}

#[test]
fn each_of_several_punches_has_columns_of_its_own() {
    let text = "Scene(geometry: PlaneStrain, punches: [(shape: Parabola(radius: 50), at: 4.0, force: 2e-3),
        (shape: Parabola(radius: 100), at: 0.0, force: 1e-3)], stack: [Homogeneous(thickness: 1, shear_modulus: 1,
        poisson: 0.25), Bonded, HalfPlane(shear_modulus: 2, poisson: 0.25)])";
    let sweep = Sweep::new(Scene::from_ron(text).unwrap(), vec!["punches[1].at=[4, 5]".parse().unwrap()]).unwrap();
    let csv = SweepCsv::new(&sweep);
    let header = csv.header().unwrap();
    assert!(header.starts_with("punches_1_at,punch_1_half_length,") && !header.contains("punch_left"), "{header}");
    for row in sweep.rows() {
        let numbers = csv.numbers(&row);
        let number = |name: &str| numbers[header.split(',').position(|column| column == name).unwrap()];
        // from left to right, whatever their order in the scene
        for (k, interval) in row.result.unwrap().contacts()[0].intervals().iter().enumerate() {
            let ends = ["left", "right"].map(|end| number(&format!("punch_{}_{end}", k + 1)));
            assert_eq!(ends, [interval.left, interval.right]);
        }
        assert!(number("punch_1_right") < 1.0 && number("punch_2_left") > row.values[0] - 1.0);
    }
}

#[test]
fn contacts_that_only_some_rows_have_are_columns_of_all() {
    let sweep = sweep(&["layer[2].thickness=[0,1]"]);
    let header = SweepCsv::new(&sweep).header().unwrap();
    for column in
        ["layer_2_thickness,punch_half_length,", "contact_1_3_half_length", "contact_2_3_central_pressure_error"]
    {
        assert!(header.contains(column), "{header}");
    }
    let lines: Vec<_> = sweep.rows().map(|row| row.result.unwrap().contacts().len()).collect();
    assert_eq!(lines, [2, 2]);
}

#[test]
fn what_cannot_vary_is_told_before_anything_is_solved() {
    let refused = |axes: &[&str]| {
        let arguments: Vec<&str> = axes.iter().flat_map(|axis| ["--vary", axis]).collect();
        let run = recede(&[&["sweep", SCENE], &arguments[..]].concat(), b"");
        assert_eq!((run.status, &run.stdout[..]), (Some(2), ""), "{}", run.stderr);
        run.stderr
    };
    assert!(refused(&["layer[2].bta=[1]"]).contains("hint: did you mean `layer[2].beta`?"));
    assert!(refused(&["layer[4].beta=[1]"]).contains("the scene has no quantity `layer[4].beta`"));
    assert!(refused(&["layer[1].poisson=0:1:3"]).contains("found 1.0, allowed is -1 < poisson <= 0.5"));
    assert!(refused(&["force=0:1:3"]).contains("found 0.0, allowed is a finite number > 0"));
    assert!(refused(&["force=[1]", "force=[2]"]).contains("varies already"));
    assert!(refused(&["force=1:2"]).contains("START:STOP:COUNT is expected"));
    assert!(refused(&["force=1:2:100000", "punch.radius=1:2:100000"]).contains("more than 1000000000 points"));
    assert!(refused(&[]).contains("nothing varies"));
}

#[test]
fn values_are_found_and_replaced_among_comments() {
    let text = "// force: 7\nScene(\n  geometry: PlaneStrain, punch: /* a: 1 */ Cylinder(radius: 500),\n  force: 0.002,
        stack: [Homogeneous(thickness: 1, shear_modulus: /* b */ 2.0 /* c */, poisson: 0.25), Receding, Rigid])";
    let scene = Scene::from_ron(text).unwrap();
    let changes = [
        ("force", 0.004),
        ("punch.radius", 250.0),
        ("layer[1].thickness", 3.0),
        ("layer[1].shear_modulus", 1e-7),
        ("layer[1].poisson", 0.5),
    ];
    assert_eq!(scene.paths(), changes.map(|(path, _)| path));
    let axes = changes.map(|(path, value)| format!("{path}=[{value}]").parse().unwrap());
    let changed = Sweep::new(scene.clone(), axes.to_vec()).unwrap().scene_at(0).unwrap();
    assert_eq!(changed.paths(), scene.paths());
    assert_eq!(changes.map(|(path, _)| changed.number(path).unwrap()), changes.map(|(_, value)| value));
    assert_eq!((changed.force, changed.top), (Force::Given(0.004), Punch::cylinder(250.0).unwrap().into()));
    let Item::Layer(layer) = &changed.stack[0] else { panic!("a layer is expected") };
    assert_eq!(layer.notation().parameters, "thickness: 3.0, shear_modulus: 1e-7, poisson: 0.5");
    // mistakes have the places of the values in the text
    for (path, said) in [
        ("force", "scene:4:10: `force` of the scene: found -1.0, allowed is a finite number > 0"),
        ("punch.radius", "scene:3:61: `radius` of the punch: found -1.0, allowed is a finite number > 0"),
        ("layer[1].thickness", "scene:5:40: `thickness` of layer 1 (Homogeneous): found -1.0"),
    ] {
        let error = scene.with(path, -1.0).unwrap_err().to_string();
        assert!(error.starts_with(said), "{error}");
    }
    let error = scene.with("layer[1].posson", 0.3).unwrap_err();
    assert_eq!(error.hint(), Some("did you mean `layer[1].poisson`?"));
    assert!(error.message().contains("those that can vary are `force`, `punch.radius`, `layer[1].thickness`"));
    let scene = Scene::new(scene.geometry, scene.top, scene.force, scene.stack);
    assert!(scene.paths().is_empty());
    assert!(scene.with("force", 1.0).unwrap_err().to_string().contains("not read from a text"));
}

#[test]
fn an_interrupted_file_is_continued_to_the_same_bytes() {
    let vary = ["--vary", "force=0.001:0.004:20", "--vary", "punch.radius=[250,500]"];
    let whole = written("whole.csv", &vary);
    assert_eq!(whole.lines().count(), 41);
    let resumed = [&vary[..], &["--resume"]].concat();
    let ends = [0, 5, 200, 700, whole.len() / 2, whole.len() - 2, whole.len()];
    for end in ends {
        fs::write(file("cut.csv"), &whole[..end]).unwrap();
        assert_eq!(written("cut.csv", &resumed), whole, "cut after {end} bytes");
    }
    let _ = fs::remove_file(file("new.csv"));
    assert_eq!(written("new.csv", &resumed), whole);

    // and of no other sweep
    for other in [&["--vary", "force=0.001:0.005:20", "--vary", "punch.radius=[250,500]"][..], &vary[..2]] {
        fs::write(file("other.csv"), &whole).unwrap();
        let path = file("other.csv");
        let run = recede(&[&["sweep", SCENE, "--resume", "--out", path.to_str().unwrap()], other].concat(), b"");
        assert_eq!(run.status, Some(2), "{}", run.stderr);
        assert!(run.stderr.contains("holds something else than rows of this sweep"), "{}", run.stderr);
        assert_eq!(fs::read_to_string(path).unwrap(), whole);
    }
}

/// What may become of a line, and of the lines around it, but for digits that are others.
fn damages(lines: &[&str], at: usize) -> Vec<Vec<u8>> {
    let line = lines[at];
    let fields: Vec<&str> = line.split(',').collect();
    let comma = line.rfind(',').unwrap();
    let damaged = [
        line.replacen(',', "", 1),
        line.replacen(',', ",,", 1),
        line.replacen('.', "x", 1),
        line.replacen('.', "..", 1),
        line.replacen("solved", "solvd", 1),
        line.replacen("solved", "no_solution", 1),
        line.replacen("solved", "solved,\"", 1),
        format!("{}\n", &line[..line.len() / 2]),
        format!("{}{}", &line[..line.len() / 2], &lines[at - 1]),
        format!("{}{}", &line[..comma], &line[comma + 1..]),
        format!("{},{},{}", fields[0], fields[1], fields[fields.len() - 4..].join(",")),
        format!("# {line}"),
        "a note\n".to_owned(),
        "\n".to_owned(),
        format!("{line}{line}"),
        String::new(),
    ];
    let mut all: Vec<Vec<u8>> = Vec::new();
    for damaged in damaged {
        assert_ne!(damaged, line);
        let (before, after) = (lines[..at].concat(), lines[at + 1..].concat());
        all.push([before, damaged, after].concat().into_bytes());
    }
    all.push([lines[..at].concat().into_bytes(), vec![0; line.len()], lines[at..].concat().into_bytes()].concat());
    all
}

#[test]
fn rows_that_are_damaged_are_told_and_not_taken() {
    let vary = ["--vary", "force=[0.001,0.002,0.003]", "--vary", "punch.radius=[250,500]"];
    let whole = written("sound.csv", &vary);
    let lines: Vec<&str> = whole.split_inclusive('\n').collect();
    let path = file("damaged.csv");
    let ways: [&[&str]; 2] = [&["sweep", SCENE, "--resume"], &["merge", SCENE, path.to_str().unwrap()]];
    for at in [1, 2, 3, 6] {
        for damaged in damages(&lines, at) {
            for way in ways {
                if way[0] == "sweep" && whole.as_bytes().starts_with(&damaged) {
                    // a row that is missing at the end is what one resumes for
                    continue;
                }
                fs::write(&path, &damaged).unwrap();
                let out = if way[0] == "merge" { file("merged.csv") } else { path.clone() };
                let run = recede(&[way, &vary, &["--out", out.to_str().unwrap()]].concat(), b"");
                let shown = String::from_utf8_lossy(&damaged);
                assert_eq!(run.status, Some(2), "{way:?}: {}\n{shown}", run.stderr);
                // a line that follows twice is wrong where it comes again; a merge looks at both ends of a part first
                let is_end = way[0] == "merge" && [1, 6].contains(&at) && run.stderr.contains("damaged.csv");
                let is_line = |line: usize| run.stderr.contains(&format!("damaged.csv, line {line}"));
                assert!(is_end || is_line(at + 1) || is_line(at + 2), "{}\n{shown}", run.stderr);
                assert_eq!(fs::read(&path).unwrap(), damaged, "nothing is lost");
            }
        }
    }
    // half a line at the end is made again if it is half of a row, and nothing else is taken for one
    for (end, sound) in
        [(lines[5][..20].to_owned(), true), ("my notes".to_owned(), false), (lines[4][..20].to_owned(), false)]
    {
        let text = lines[..5].concat() + &end;
        fs::write(&path, &text).unwrap();
        let run = recede(&[ways[0], &vary, &["--out", path.to_str().unwrap()]].concat(), b"");
        assert_eq!(run.status, Some(if sound { 0 } else { 2 }), "{end}: {}", run.stderr);
        assert_eq!(fs::read_to_string(&path).unwrap(), if sound { &whole } else { &text }.as_str());
    }
    // nor is anything behind the last row
    fs::write(&path, whole.clone() + "my").unwrap();
    let run = recede(&[ways[0], &vary, &["--out", path.to_str().unwrap()]].concat(), b"");
    assert!(run.status == Some(2) && run.stderr.contains("damaged.csv, line 8, "), "{}", run.stderr);
}

#[test]
fn a_killed_sweep_leaves_whole_rows() {
    let vary = ["--vary", "force=0.001:0.004:150"];
    let path = file("killed.csv");
    let _ = fs::remove_file(&path);
    let mut child = Command::new(env!("CARGO_BIN_EXE_recede"))
        .args(["sweep", SCENE, "--out", path.to_str().unwrap()])
        .args(vary)
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    let lines = || fs::read_to_string(&path).unwrap_or_default().lines().count();
    while lines() < 5 && child.try_wait().unwrap().is_none() {
        thread::sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let left = fs::read_to_string(&path).unwrap();
    assert!(left.ends_with('\n') && left.lines().count() >= 5, "{left}");
    let resumed = written("killed.csv", &[&vary[..], &["--resume"]].concat());
    assert!(resumed.starts_with(&left));
    assert_eq!(resumed, written("unkilled.csv", &vary));
}

#[test]
fn a_sweep_can_be_a_file() {
    let path = "examples/sweeps/radius_and_load.ron";
    let run = recede(&["sweep", path, "--vary", "layer[2].beta=[-1]"], b"");
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    assert_eq!(run.stdout.lines().count(), 28);
    assert!(run.stdout.starts_with("punch_radius,force,layer_2_beta,punch_half_length,"));
    let refused = |text: &str| {
        let run = recede(&["sweep", "-"], text.as_bytes());
        assert_eq!((run.status, &run.stdout[..]), (Some(2), ""), "{}", run.stderr);
        run.stderr
    };
    let scene = format!("Sweep(scene: \"{SCENE}\", ");
    let error = refused(&format!("{scene}vary: [Linear(path: \"force\", start: 1, stop: 2, cont: 3)])"));
    assert!(error.contains("stdin:1:") && error.contains("did you mean `count`?"), "{error}");
    let error = refused(&format!("{scene}vary: [List(path: \"force\", values: [])])"));
    assert!(error.contains("`force`: found 0 values, allowed are 1 to 1000000"), "{error}");
    let error = refused(&format!("{scene}vary: [], tolerance: 1)"));
    assert!(error.contains("tolerance: found 1.0"), "{error}");
    let error = refused("Sweep(scene: \"nowhere.ron\", vary: [])");
    assert!(error.contains("nowhere.ron: cannot be read"), "{error}");
}

#[test]
fn layers_of_thickness_zero_keep_their_number() {
    let run = recede(&["sweep", SCENE, "--vary", "layer[1].thickness=[0,0.5]", "--vary", "force=[0.001]"], b"");
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    assert!(run.stdout.lines().skip(1).all(|line| line.contains(",solved,")), "{}", run.stdout);
}

/// The contacts are those of all stacks, though no stack is built but for its rows.
#[test]
fn contacts_are_those_of_all_rows() {
    let strip = "Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25)";
    for between in ["Receding, Bonded, Receding", "Bonded, Receding, Bonded", "Receding, Sliding, Bonded"] {
        for zeros in [&[1][..], &[2], &[3], &[1, 2], &[2, 3], &[1, 3], &[1, 2, 3]] {
            let stack: Vec<String> = between.split(", ").map(|name| format!("{strip}, {name}, ")).collect();
            let stack = stack.concat() + "HalfPlane(shear_modulus: 1, poisson: 0.25)";
            let text =
                format!("Scene(geometry: PlaneStrain, punch: Parabola(radius: 500), force: 0.002, stack: [{stack}])");
            let axis = |layer: &usize| format!("layer[{layer}].thickness=0:1:3").parse::<Axis>().unwrap();
            // of a layer that is not there another axis changes nothing
            let beside = "layer[2].shear_modulus=[1,2]".parse::<Axis>().unwrap();
            let axes = zeros.iter().map(axis).chain([beside]).collect();
            let sweep = Sweep::new(Scene::from_ron(&text).unwrap(), axes).unwrap();
            let mut expected = std::collections::BTreeSet::new();
            for index in 0..sweep.len() {
                let stack = sweep.scene_at(index).unwrap().stack().unwrap();
                expected.extend(stack.contacts().iter().map(ToString::to_string));
            }
            let found: std::collections::BTreeSet<String> =
                sweep.interfaces().iter().map(ToString::to_string).collect();
            assert_eq!(found, expected, "{between} {zeros:?}");
            assert_eq!(found.len(), sweep.interfaces().len());
        }
    }
}

#[test]
fn a_sweep_without_any_stack_is_refused() {
    let layer = "Exponential(thickness: 1, shear_modulus: 1, poisson: 0.25, beta: 1)";
    let text = |base: &str| {
        format!(
            "Scene(geometry: PlaneStrain, punch: Parabola(radius: 500), force: 0.002, stack: [{layer}, Bonded, {base}])"
        )
    };
    let refused = |base: &str, axis: &str| {
        Sweep::new(Scene::from_ron(&text(base)).unwrap(), vec![axis.parse().unwrap()]).err().map(|e| e.to_string())
    };
    let error = refused("Rigid", "layer[1].thickness=[0]").expect("nothing is there");
    assert!(error.contains("nothing can deform between the punch and the rigid base"), "{error}");
    assert!(refused("Rigid", "layer[1].beta=[-1000,1000]").is_some());
    // some rows have one
    assert_eq!(refused("Rigid", "layer[1].thickness=0:1:2"), None);
    assert_eq!(refused("Rigid", "layer[1].beta=-1000:1000:4001"), None);
    assert_eq!(refused("Rigid", "layer[1].beta=[-1000,1,1000]"), None);
}

/// A billion rows begin at once, alone and on several threads, and are those of small grids.
#[test]
fn a_large_grid_begins_at_once() {
    let axes = ["layer[2].beta=-2:-1:1000000", "punch.radius=500:1000:1000"];
    let sweep = Arc::new(sweep(&axes));
    assert_eq!(sweep.len(), 1_000_000_000);
    let small = self::sweep(&["layer[2].beta=[-2]", "punch.radius=500:1000:1000"]);
    let few = |rows: &mut dyn Iterator<Item = recede::SweepRow>| {
        rows.take(3).map(|row| row.result.unwrap().contacts()[0].half_length().unwrap()).collect::<Vec<_>>()
    };
    let expected = few(&mut small.rows());
    assert_eq!(few(&mut sweep.rows()), expected);
    for threads in [1, 2] {
        assert_eq!(few(&mut sweep.parallel_rows(0..sweep.len(), NonZeroUsize::new(threads).unwrap())), expected);
    }
    assert_eq!(sweep.rows_in(999_999_999..1_000_000_000).map(|row| row.values).collect::<Vec<_>>(), [[-1.0, 1000.0]]);
    // of what is drawn there is no more than of a small grid
    let drawn = (0..1_000_000).filter(|row| recede::plot::is_drawn(&sweep, *row)).count();
    assert_eq!(drawn, 100);
    assert!((0..small.len()).all(|row| recede::plot::is_drawn(&small, row)));
}

#[test]
fn values_are_those_that_one_would_write() {
    let sweep = sweep(&["force=0.001:0.01:10", "punch.radius=5:40:8"]);
    let values: Vec<Vec<f64>> = (0..sweep.len()).map(|index| sweep.values(index)).collect();
    let radii = [5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0];
    let forces = [0.001, 0.002, 0.003, 0.004, 0.005, 0.006, 0.007, 0.008, 0.009, 0.01];
    assert!(values.iter().enumerate().all(|(i, value)| value[..] == [forces[i / 8], radii[i % 8]]), "{values:?}");
    let decades: Axis = "force=0.003:3000:7:log".parse().unwrap();
    assert!(decades.values().eq([0.003, 0.03, 0.3, 3.0, 30.0, 300.0, 3000.0]));
}
