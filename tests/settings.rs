//! Other values for a scene on the command line, and sweeps over the rows of a table.
use std::fs;
use std::path::{Path, PathBuf};

use crate::support::{recede, texts};
use recede::report::SweepCsv;
use recede::{Axis, Model, Scene, Sweep};

const SCENE: &str = "examples/scenes/strip_fgm_half_plane.ron";

fn table(name: &str, text: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("settings");
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join(name), text).unwrap();
    folder.join(name)
}

#[test]
fn a_scene_with_other_values_is_solved_as_if_they_were_written() {
    let set = ["--set", "force=0.004", "--set", "layer[2].beta=-0.5"];
    let text = fs::read_to_string(SCENE).unwrap();
    let scene = Scene::from_ron(&text).unwrap().with("force", 0.004).unwrap().with("layer[2].beta", -0.5).unwrap();
    for (command, options) in [("solve", &["--format", "csv"][..]), ("convert", &["--to", "ron"]), ("check", &[])] {
        let run = recede(&[&[command, SCENE], options, &set].concat(), b"");
        let other = recede(&[&[command, "-"], options].concat(), scene.to_ron().as_bytes());
        assert_eq!((run.status, run.stdout), (Some(0), other.stdout), "{command} {}", run.stderr);
    }
    let refused = |set: &str, message: &str| {
        let run = recede(&["solve", SCENE, "--set", set], b"");
        assert!(run.status == Some(2) && run.stderr.contains(message), "{}", run.stderr);
    };
    refused("layer[2].bet=1", "did you mean `layer[2].beta`?");
    refused("layer[1].poisson=0.7", "found 0.7, allowed is -1 < poisson <= 0.5");
    refused("force", "PATH=VALUE is expected, such as force=0.01, found `force`");
    refused("force=much", "`force`: found `much`, a number is expected");
    refused("force=3 N/mm", "has a unit, and the scene does not say in which units it is");
    let slab = |set: &str| {
        let run = recede(&["solve", "examples/gallery/slab_on_soil.ron", "--format", "csv", "--set", set], b"");
        assert_eq!(run.status, Some(0), "{}", run.stderr);
        run.stdout
    };
    assert_eq!(slab("layer[1].thickness=150 mm"), slab("layer[1].thickness=0.15"));
    assert_ne!(slab("layer[1].young=\"15 GPa\""), slab("layer[1].young=31e6"));
    let sweep = recede(&["sweep", SCENE, "--set", "layer[2].beta=-0.5", "--vary", "force=[0.004]"], b"");
    let expected = recede::solve(&scene).unwrap().contacts()[0].half_length().unwrap().to_string();
    assert!(sweep.stdout.contains(&expected), "{}", sweep.stdout);
}

#[test]
fn each_row_of_a_table_is_a_scene() {
    let text = "# samples\nforce, layer[1].thickness ,layer[2].beta\n0.001,0.5,-1\n0.002,0.25,0.5\n0.001,0.5,2\n";
    let rows = table("samples.csv", text);
    let run = recede(&["sweep", SCENE, "--rows", rows.to_str().unwrap()], b"");
    assert_eq!((run.status, &run.stderr[..]), (Some(0), ""));
    let axes = ["force=[0.001,0.002,0.001]", "layer[1].thickness=[0.5,0.25,0.5]", "layer[2].beta=[-1,0.5,2]"];
    let axes: Vec<Axis> = axes.iter().map(|axis| axis.parse().unwrap()).collect();
    let sweep = Sweep::of_rows(Scene::read(SCENE).unwrap(), axes.clone()).unwrap();
    let csv = SweepCsv::new(&sweep);
    let lines: Vec<String> = sweep.rows().map(|row| csv.line(&row).unwrap()).collect();
    assert_eq!(run.stdout, csv.header().unwrap() + &lines.concat());
    for row in sweep.rows() {
        assert_eq!(csv.row_of(&lines[row.index]), Some(row.index));
        let [force, thickness, beta] = row.values[..] else { panic!("{row:?}") };
        let scene = Scene::read(SCENE).unwrap().with("force", force).unwrap().with("layer[1].thickness", thickness);
        let scene = scene.unwrap().with("layer[2].beta", beta).unwrap();
        assert_eq!(row.result.unwrap(), recede::solve(&scene).unwrap());
    }
    assert_eq!(sweep.index_of(&[0.001, 0.5, 0.5]), None);
    // a grid of the same axes is another sweep
    assert_ne!(sweep.fingerprint(), Sweep::new(Scene::read(SCENE).unwrap(), axes).unwrap().fingerprint());
}

#[test]
fn columns_have_what_fields_have_at_points() {
    let at = ["0,0=sigma_yy", "0.3,1.5@2=eps_1", "-0.3,2=u"];
    let options: Vec<&str> = at.iter().flat_map(|at| ["--at", at]).collect();
    let run = recede(&[&["sweep", SCENE, "--vary", "force=[0.001,0.002]"], &options[..]].concat(), b"");
    let lines: Vec<Vec<&str>> = run.stdout.lines().map(|line| line.split(',').collect()).collect();
    let column =
        |name: &str| lines[0].iter().position(|own| *own == name).unwrap_or_else(|| panic!("{name}: {}", run.stderr));
    for (line, force) in lines[1..].iter().zip([0.001, 0.002]) {
        let scene = Scene::read(SCENE).unwrap().with("force", force).unwrap();
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let solution = model.press(&scene.top, scene.force).unwrap();
        let field = model.field(&solution).unwrap();
        let expected = [
            ("sigma_yy_at_0_0", field.at(0.0, 0.0).unwrap().sigma_yy),
            ("eps_1_at_0.3_1.5_in_2", field.at_layer(0.3, 1.5, 2).unwrap().principal_strains()[0]),
            ("u_at_-0.3_2", field.at(-0.3, 2.0).unwrap().u),
        ];
        for (name, expected) in expected {
            let found: f64 = line[column(name)].parse().unwrap();
            assert!((found / expected - 1.0).abs() < 1e-9, "{name}: {found} {expected}");
        }
    }
    // a point that is in no layer leaves its column empty, and says so
    let outside = recede(&["sweep", SCENE, "--vary", "layer[1].thickness=[0.5]", "--at", "0,9@1=u"], b"");
    assert!(outside.stdout.contains("quantities at points were not found: "), "{}", outside.stdout);
    for (at, message) in [("0,0=eps_rr", "there is no eps_rr in this geometry; there are"), ("0=u", "expected X,DEPTH")]
    {
        let refused = recede(&["sweep", SCENE, "--vary", "force=[0.001]", "--at", at], b"");
        assert!(refused.status == Some(2) && refused.stderr.contains(message), "{}", refused.stderr);
    }
}

#[test]
fn tables_that_make_no_scenes_are_refused() {
    let refused = |text: &str, options: &[&str], message: &str| {
        let rows = table("wrong.csv", text);
        let run = recede(&[&["sweep", SCENE, "--rows", rows.to_str().unwrap()], options].concat(), b"");
        assert!((run.status, &run.stdout[..]) == (Some(2), "") && run.stderr.contains(message), "{}", run.stderr);
    };
    refused("force\n0.001\nmuch\n", &[], "wrong.csv: found `much` as force in line 3, a number is expected");
    refused("force,layer[2].beta\n0.001\n", &[], "wrong.csv: ");
    refused("force\n", &[], "wrong.csv: there are no rows");
    refused("forc\n1\n", &[], "did you mean `force`?");
    refused("layer[1].poisson\n0.7\n", &[], "found 0.7");
    refused("force\n0.001\n", &["--vary", "layer[2].beta=[1]"], "cannot be used with");
    refused("force\n0.001\n", &["--plot", "rows.svg"], "--plot cannot be used with --rows");
    let missing = recede(&["sweep", SCENE, "--rows", "nowhere.csv"], b"");
    assert!(missing.status == Some(2) && missing.stderr.contains("nowhere.csv"), "{}", missing.stderr);
    let axes = ["force=[0.001,0.002]", "layer[2].beta=[1]"].map(|axis| axis.parse().unwrap());
    let error = Sweep::of_rows(Scene::read(SCENE).unwrap(), axes.to_vec()).unwrap_err().to_string();
    assert!(error.contains("found 1 values, force has 2"), "{error}");
}

#[test]
fn any_columns_are_drawn() {
    let picture = table("columns.svg", "");
    let drawn = |options: &[&str]| {
        let own = [
            "sweep",
            SCENE,
            "--vary",
            "force=0.001:0.004:7",
            "--at",
            "0,0=sigma_yy",
            "--plot",
            picture.to_str().unwrap(),
        ];
        let run = recede(&[&own, options].concat(), b"");
        (run.status, run.stderr)
    };
    let (status, message) = drawn(&["--x", "punch_half_length", "--y", "force,sigma_yy_at_0_0"]);
    assert_eq!((status, &message[..]), (Some(0), ""));
    let written = texts(&fs::read(&picture).unwrap());
    for label in ["punch_half_length", "force", "sigma_yy_at_0_0"] {
        assert!(written.contains(label), "{label}: {written}");
    }
    assert!(!written.contains("largest"), "{written}");
    let (status, message) = drawn(&["--y", "sigma_yy_at_0_1"]);
    assert!(status == Some(2) && message.contains("the table has no column of numbers `sigma_yy_at_0_1`"), "{message}");
    assert!(message.contains("punch_half_length"), "{message}");
}

/// Numbers with units vary as in the units of the scene, and entries of tables by their rows; axes of pictures may be logarithmic.
#[test]
fn axes_have_units_and_logarithms() {
    let swept = |file: &str, vary: &str, options: &[&str]| {
        let run = recede(&[&["sweep", file, "--vary", vary], options].concat(), b"");
        (run.status, run.stdout, run.stderr)
    };
    let soil = "examples/gallery/slab_on_soil.ron";
    let [plain, other] =
        ["[0.2, 0.25]", "[20 cm, 250 mm]"].map(|list| swept(soil, &format!("layer[1].thickness={list}"), &[]));
    assert_eq!((plain.0, &plain.1), (Some(0), &other.1), "{} {}", plain.2, other.2);
    let (status, _, message) = swept(soil, "layer[1].thickness=[20 kN]", &[]);
    assert!(status == Some(2) && message.contains("is a force"), "{message}");
    // the value of the second row, and its place
    let graded = "examples/scenes/graded_by_a_table.ron";
    for path in ["layer[1].shear_modulus[2]=[1.6, 1.7]", "layer[1].shear_modulus[2].at=[0.1, 0.12]"] {
        let (status, table, message) = swept(graded, path, &[]);
        assert!(status == Some(0) && table.lines().count() == 3, "{message}");
    }
    let picture = table("logarithmic.svg", "");
    let picture = picture.to_str().unwrap();
    let (status, _, message) = swept(SCENE, "force=0.001:0.1:5", &["--plot", picture, "--log", "x,y"]);
    assert_eq!((status, &message[..]), (Some(0), ""));
    let (status, _, message) = swept(SCENE, "layer[2].beta=[-1,1]", &["--plot", picture, "--log", "x"]);
    assert!(status == Some(2) && message.contains("logarithmic axes need values > 0, found −1"), "{message}");
}
