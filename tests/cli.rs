//! The command as scripts and people use it: what it prints where, and its exit status.
use crate::support;

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};

use serde_json::Value;
use support::{Run, recede};

const PAPER: &str = "examples/scenes/strip_fgm_half_plane.ron";

fn succeeds(arguments: &[&str]) -> String {
    let Run { status, stdout, stderr } = recede(arguments, b"");
    // what takes long on a busy machine says how far it has come
    let said: Vec<&str> = stderr.lines().filter(|line| !line.ends_with(" s left")).collect();
    assert_eq!((status, &said[..]), (Some(0), &[][..]), "{arguments:?}");
    stdout
}

fn refused(arguments: &[&str]) -> String {
    let Run { status, stdout, stderr } = recede(arguments, b"");
    assert_eq!((status, &stdout[..]), (Some(2), ""), "{arguments:?}: {stderr}");
    stderr
}

#[test]
fn open_middles_and_re_contacts_stand_under_the_table() {
    let apart = "Scene(geometry: PlaneStrain, loads: [(load: Uniform(half_width: 0.5), at: -30, force: 0.005),
        (load: Uniform(half_width: 0.5), at: 30, force: 0.005)],
        stack: [Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding,
        HalfPlane(shear_modulus: 1, poisson: 0.25)])";
    let again = fs::read_to_string("tests/data/hard/seed_23_number_1121.ron").unwrap();
    for (scene, line) in [(apart, "1|2: x from 28.5475"), (&again, ", and its mirror image, carry ")] {
        let Run { status, stdout, stderr } = recede(&["solve", "-"], scene.as_bytes());
        assert_eq!(status, Some(0), "{stderr}");
        assert!(stdout.contains(line), "{stdout}");
    }
}

#[test]
fn check_draws_the_stack() {
    insta::assert_snapshot!(succeeds(&["check", PAPER]), @r#"
                     ╲    Cylinder(radius: 500.0), force 0.002    ╱
                      ╰──────────────────────────────────────────╯
    ┌──────────────────────────────────────────────────────────────────────────────┐
    │ 1 Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25)             │
    ├─────────────────────────────────── bonded ───────────────────────────────────┤
    │ 2 Exponential(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25, beta: -1.0) │
    └──────────────────────────────────────────────────────────────────────────────┘
                                      receding 2|3
    ┌──────────────────────────────────────────────────────────────────────────────┐
    │ 3 HalfPlane(shear_modulus: 1.0, poisson: 0.25)                               │
    │╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱│
    "#);
    insta::assert_snapshot!(succeeds(&["check", "examples/scenes/table2_graded_half_plane.ron"]), @r#"
                     ╲    Cylinder(radius: 500.0), force 0.01    ╱
                      ╰─────────────────────────────────────────╯
    ┌──────────────────────────────────────────────────────────────────────────────┐
    │ 2 Exponential(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25, beta: -1.0) │
    └──────────────────────────────────────────────────────────────────────────────┘
                                      receding 2|3
    ┌──────────────────────────────────────────────────────────────────────────────┐
    │ 3 HalfPlane(shear_modulus: 1.0, poisson: 0.25)                               │
    │╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱│
    not there, because of thickness 0: layer 1 (Homogeneous)
    "#);
    insta::assert_snapshot!(succeeds(&["check", "examples/scenes/bonded_to_rigid.ron"]), @r#"
                ╲    Cylinder(radius: 50.0), force 1.0    ╱
                 ╰───────────────────────────────────────╯
    ┌─────────────────────────────────────────────────────────────────┐
    │ 1 Homogeneous(thickness: 2.0, shear_modulus: 0.8, poisson: 0.5) │
    ├──────────────────────────── bonded ─────────────────────────────┤
    │ 2 Rigid                                                         │
    │╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱│
    "#);
    insta::assert_snapshot!(succeeds(&["check", "examples/scenes/strip_on_rigid.ron"]), @r#"
               ╲    Cylinder(radius: 500.0), force 0.002    ╱
                ╰──────────────────────────────────────────╯
    ┌──────────────────────────────────────────────────────────────────┐
    │ 1 Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25) │
    └──────────────────────────────────────────────────────────────────┘
                                receding 1|2
    ┌──────────────────────────────────────────────────────────────────┐
    │ 2 Rigid                                                          │
    │╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱│
    "#);
}

#[test]
fn show_prints_the_block_matrix() {
    insta::assert_snapshot!(succeeds(&["show", PAPER]), @r#"
    10 conditions for 10 amplitudes
    ┌──────────────────┬───────────────┬───────────────┬─────────────┬───────┐
    │                  ┆ 1 Homogeneous ┆ 2 Exponential ┆ 3 HalfPlane ┆       │
    │                  ┆     C1..C4    ┆     C5..C8    ┆   C9..C10   ┆       │
    ╞══════════════════╪═══════════════╪═══════════════╪═════════════╪═══════╡
    │ punch S          ┆    +S(top)    ┆               ┆             ┆ = -p0 │
    │ punch T          ┆    +T(top)    ┆               ┆             ┆  = 0  │
    │ 1|2 U continuous ┆   +U(bottom)  ┆    -U(top)    ┆             ┆  = 0  │
    │ 1|2 V continuous ┆   +V(bottom)  ┆    -V(top)    ┆             ┆  = 0  │
    │ 1|2 S continuous ┆   +S(bottom)  ┆    -S(top)    ┆             ┆  = 0  │
    │ 1|2 T continuous ┆   +T(bottom)  ┆    -T(top)    ┆             ┆  = 0  │
    │ 2|3 S above      ┆               ┆   +S(bottom)  ┆             ┆ = -p1 │
    │ 2|3 T above      ┆               ┆   +T(bottom)  ┆             ┆  = 0  │
    │ 2|3 S below      ┆               ┆               ┆   +S(top)   ┆ = -p1 │
    │ 2|3 T below      ┆               ┆               ┆   +T(top)   ┆  = 0  │
    └──────────────────┴───────────────┴───────────────┴─────────────┴───────┘
    "#);
    insta::assert_snapshot!(succeeds(&["show", "examples/scenes/table1_strip_half_plane.ron"]), @r#"
    6 conditions for 6 amplitudes
    ┌─────────────┬───────────────┬─────────────┬───────┐
    │             ┆ 1 Homogeneous ┆ 3 HalfPlane ┆       │
    │             ┆     C1..C4    ┆    C5..C6   ┆       │
    ╞═════════════╪═══════════════╪═════════════╪═══════╡
    │ punch S     ┆    +S(top)    ┆             ┆ = -p0 │
    │ punch T     ┆    +T(top)    ┆             ┆  = 0  │
    │ 1|3 S above ┆   +S(bottom)  ┆             ┆ = -p1 │
    │ 1|3 T above ┆   +T(bottom)  ┆             ┆  = 0  │
    │ 1|3 S below ┆               ┆   +S(top)   ┆ = -p1 │
    │ 1|3 T below ┆               ┆   +T(top)   ┆  = 0  │
    └─────────────┴───────────────┴─────────────┴───────┘
    "#);
    insta::assert_snapshot!(succeeds(&["show", "examples/scenes/strip_on_rigid.ron", "--latex"]), @r#"
    % c_1 = (C_1, ..., C_4): Homogeneous
    \[
    \begin{array}{l|c|l}
      & \mathbf{c}_{1} & \\ \hline
      \text{punch}:\ S & +\mathbf{S}_{1}^{t} & = -\hat{p}_{0} \\
      \text{punch}:\ T & +\mathbf{T}_{1}^{t} & = 0 \\
      1\,|\,2:\ S\ \text{above} & +\mathbf{S}_{1}^{b} & = -\hat{p}_{1} \\
      1\,|\,2:\ T\ \text{above} & +\mathbf{T}_{1}^{b} & = 0 \\
    \end{array}
    \]
    "#);
}

#[test]
fn json_has_the_pinned_keys_and_all_digits() {
    let json: Value = serde_json::from_str(&succeeds(&["solve", PAPER, "--format", "json"])).unwrap();
    assert_eq!(json["scene"], "strip_fgm_half_plane");
    assert_eq!(json["contacts"][0]["interface"], "punch");
    assert_eq!(json["contacts"][1]["interface"], "2|3");
    for contact in json["contacts"].as_array().unwrap() {
        for key in ["half_length", "half_length_error", "central_pressure", "central_pressure_error", "resultant"] {
            assert!(contact[key].is_number(), "{key}");
        }
    }
    for key in ["min_pressure", "min_gap", "modes", "wavenumbers", "newton_steps", "seconds"] {
        assert!(json[key].is_number(), "{key}");
    }
    assert!(json["warnings"].is_array());
}

#[test]
fn the_largest_shear_stress_is_searched_where_it_is_printed_or_asked_for() {
    let json = |more: &[&str]| -> Value {
        serde_json::from_str(&succeeds(&[&["solve", PAPER, "--format", "json"][..], more].concat())).unwrap()
    };
    assert!(json(&[]).get("max_shear").is_none() && json(&["--fields", "--no-fields"]).get("max_shear").is_none());
    for key in ["value", "x", "depth", "layer"] {
        assert!(json(&["--fields"])["max_shear"][key].is_number(), "{key}");
    }
    let line = "largest shear stress 6.8749e-4";
    assert!(succeeds(&["solve", PAPER]).contains(line) && !succeeds(&["solve", PAPER, "--no-fields"]).contains(line));
}

#[test]
fn the_largest_shear_stress_is_found_below_a_layer_that_is_next_to_nothing() {
    let largest = |coating: &str| {
        let scene = format!(
            "Scene(geometry: PlaneStrain, punch: Parabola(radius: 100), force: 0.05, stack: [{coating}
            Homogeneous(thickness: 1, shear_modulus: 3.0, poisson: 0.3), Receding, HalfPlane(shear_modulus: 1.0, poisson: 0.3)])"
        );
        let run = recede(&["solve", "-", "--format", "json", "--fields"], scene.as_bytes());
        assert_eq!(run.status, Some(0), "{}", run.stderr);
        let json: Value = serde_json::from_str(&run.stdout).unwrap();
        json["max_shear"]["value"].as_f64().unwrap()
    };
    let with = largest("Homogeneous(thickness: 1e-5, shear_modulus: 1.0, poisson: 0.3), Bonded,");
    assert!((with / largest("") - 1.0).abs() < 1e-3, "{with}");
}

#[test]
fn counts_are_told_on_standard_error_and_always_in_json() {
    let run = recede(&["solve", PAPER, "--stats", "--format", "json"], b"");
    let json: Value = serde_json::from_str(&run.stdout).unwrap();
    let stats = &json["stats"];
    let list = |key: &str| -> Vec<u64> { stats[key].as_array().unwrap().iter().map(|n| n.as_u64().unwrap()).collect() };
    assert_eq!(stats["wavenumbers"], json["wavenumbers"]);
    assert_eq!(list("modes").into_iter().max(), json["modes"].as_u64());
    assert_eq!(list("newton_steps").iter().sum::<u64>(), json["newton_steps"].as_u64().unwrap());
    let counts: Vec<u64> = [
        "layers_dropped",
        "layers_merged",
        "wavenumbers",
        "layers_evaluated",
        "layers_repeated",
        "layers_below_decay_depth",
        "couplings_vanished",
        "wavenumbers_interpolated",
        "factorisations",
    ]
    .iter()
    .map(|key| stats[key].as_u64().unwrap_or_else(|| panic!("{key}")))
    .collect();
    // the same counts, one line for each, lists before the last
    let told: Vec<u64> = run.stderr.lines().filter_map(|line| line.split_whitespace().next()?.parse().ok()).collect();
    assert_eq!(told.len(), counts.len() + 2);
    assert_eq!(told[..8], counts[..8]);
    assert_eq!(told.last(), counts.last());
    assert_eq!(recede(&["solve", PAPER], b"").stderr, "");
}

#[test]
fn csv_has_one_line_for_each_contact_with_the_same_numbers_as_json() {
    let csv = succeeds(&["solve", PAPER, "--format", "csv"]);
    let json: Value = serde_json::from_str(&succeeds(&["solve", PAPER, "--format=json"])).unwrap();
    let mut lines = csv.lines();
    let keys: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert_eq!(keys[..2], ["interface", "half_length"]);
    for (line, contact) in lines.zip(json["contacts"].as_array().unwrap()) {
        for (key, value) in keys.iter().zip(line.split(',')).skip(1) {
            // the reader of JSON used here rounds the last digit in its own way
            let json = match *key {
                "intervals" => contact["intervals"].as_array().unwrap().len() as f64,
                "left" | "left_error" | "right" | "right_error" => contact["intervals"][0][*key].as_f64().unwrap(),
                key => contact[key].as_f64().unwrap(),
            };
            let csv = value.parse::<f64>().unwrap();
            assert!((csv - json).abs() <= 1e-15 * json.abs(), "{key}: {csv} {json}");
        }
    }
    assert_eq!(csv.lines().count(), 3);
}

#[test]
fn the_table_names_scene_units_and_contacts() {
    let table = succeeds(&["solve", "examples/scenes/bonded_to_rigid.ron"]);
    for part in [
        "rubber on steel\n",
        "force 1 N/mm",
        "half-length, mm",
        "x = 0, MPa",
        " mm, stiffness ",
        " punch ",
        " ± ",
        "Newton steps",
    ] {
        assert!(table.contains(part), "{part}: {table}");
    }
    assert!(!table.contains('\u{1b}'), "colours belong on a terminal");
}

#[test]
fn a_hyphen_reads_standard_input() {
    let text = std::fs::read(PAPER).unwrap();
    let run = recede(&["solve", "-", "--format", "json"], &text);
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    assert_eq!(serde_json::from_str::<Value>(&run.stdout).unwrap()["scene"], "stdin");
}

#[test]
fn fields_are_told_at_points_and_on_grids() {
    let text = succeeds(&["field", PAPER, "--at", "0.3,2", "--at=-0.3,2@2", "--at", "0,0", "--format", "json"]);
    let json: Value = serde_json::from_str(&text).unwrap();
    let points = json["points"].as_array().unwrap();
    let layers: Vec<_> = points.iter().map(|point| point["layer"].as_u64().unwrap()).collect();
    assert_eq!(layers, [3, 2, 1]);
    let number = |k: usize, key: &str| points[k][key].as_f64().unwrap();
    assert!((number(0, "sigma_yy") - number(1, "sigma_yy")).abs() < 1e-12);
    for key in ["x", "depth", "sigma_xx", "sigma_xy", "u", "v", "von_mises", "sigma_1", "sigma_2", "max_shear"] {
        assert!(number(2, key).is_finite(), "{key}");
    }
    let csv = succeeds(&["field", PAPER, "--x", "-1:1:5", "--depth", "0:3:4", "--format", "csv"]);
    assert_eq!(csv.lines().count(), 1 + 5 * 4);
    let file = std::env::temp_dir().join(format!("recede-field-{}.csv", std::process::id()));
    let name = file.display().to_string();
    assert_eq!(succeeds(&["field", PAPER, "--x=-1:1:5", "--depth=0:3:4", "--out", &name]), "");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), csv);
    std::fs::remove_file(&file).unwrap();
}

#[test]
fn fields_that_are_not_there_are_refused() {
    assert!(
        refused(&["field", PAPER, "--at", "0,-1"]).contains("allowed is layer 1 from 0.0 to 1.0, layer 2 from 1.0")
    );
    assert!(refused(&["field", PAPER, "--at", "0,0.5@2"]).contains("in layer 2"));
    for bad in ["0", "0,a", "0,1@x", "0,1@-1"] {
        assert!(refused(&["field", PAPER, "--at", bad]).contains("expected X,DEPTH or X,DEPTH@LAYER"), "{bad}");
    }
    for bad in ["0:1", "0:1:2:3", "0:1:0", "0:inf:3", "0:1:1e9"] {
        refused(&["field", PAPER, "--x", bad]);
    }
    assert!(refused(&["field", PAPER, "--out", "field.exe"]).contains(".csv or .json"));
    refused(&["field", PAPER, "--out", "no/such/folder/field.csv"]);
}

#[test]
fn bad_arguments_are_bad_input() {
    refused(&[]);
    refused(&["dance", PAPER]);
    refused(&["solve"]);
    refused(&["solve", PAPER, "--format", "xml"]);
    refused(&["solve", PAPER, "--method", "guess"]);
    refused(&["solve", PAPER, "--tolerance", "small"]);
    for tolerance in ["1e-14", "0.1", "0", "-1", "NaN", "inf"] {
        let message = refused(&["solve", PAPER, &format!("--tolerance={tolerance}")]);
        assert!(message.contains("allowed is 1e-13 <= tolerance <= 1e-2"), "{message}");
    }
}

#[test]
fn help_tells_examples_and_exit_statuses() {
    let help = succeeds(&["--help"]);
    assert!(help.contains("recede solve scene.ron") && help.contains("Exit status"), "{help}");
    for command in ["solve", "check", "show", "field"] {
        assert!(succeeds(&[command, "--help"]).contains("SCENE.ron"));
    }
    assert!(succeeds(&["--version"]).starts_with("recede "));
}

#[test]
fn a_reader_that_stops_early_is_no_error() {
    // more text than a pipe holds
    let strip = "Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25), Bonded,\n";
    let text = format!(
        "(geometry: PlaneStrain, punch: Parabola(radius: 1.0), force: 1.0, stack: [{} Rigid])",
        strip.repeat(5000)
    );
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("many_layers.ron");
    std::fs::write(&path, text).unwrap();
    for arguments in [&["check"][..], &["show"], &["show", "--latex"]] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_recede"))
            .args(arguments)
            .arg(&path)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        assert!(output.stderr.is_empty());
    }
}

#[test]
fn a_first_scene_is_written_once_and_solved() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("init");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join("first.ron");
    let file = file.to_str().unwrap();
    let run = recede(&["init", file], b"");
    assert_eq!((run.status, &run.stdout[..]), (Some(0), ""), "{}", run.stderr);
    assert!(run.stderr.contains("next: recede check"), "{}", run.stderr);
    succeeds(&["solve", file]);
    fs::write(file, "mine").unwrap();
    assert!(refused(&["init", file]).contains("exists and is left as it is"));
    assert_eq!(fs::read_to_string(file).unwrap(), "mine");
}

#[test]
fn completions_and_manual_know_all_subcommands() {
    let names = ["solve", "check", "show", "sweep", "merge", "plot", "init", "completions", "man"];
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = succeeds(&["completions", shell]);
        assert!(names.iter().all(|name| script.contains(name)), "{shell}");
    }
    let page = succeeds(&["man"]);
    assert!(page.contains(".TH recede 1") && names.iter().all(|name| page.contains(name)), "{page}");
    assert!(succeeds(&["man", "sweep"]).contains("\\-\\-resume"));
    assert!(refused(&["man", "dance"]).contains("there is no subcommand `dance`"));
    assert!(refused(&["completions", "perl"]).contains("possible values"));
}

#[test]
fn names_that_are_nearly_right_are_understood() {
    assert!(refused(&["slove", PAPER]).contains("a similar subcommand exists: 'solve'"));
    assert!(refused(&["solve", PAPER, "--fromat", "json"]).contains("a similar argument exists: '--format'"));
    for name in ["solve", "sweep", "merge", "plot", "init", "completions", "man"] {
        assert!(succeeds(&[name, "--help"]).contains("Examples:\n"), "{name}");
    }
}

#[test]
fn selftest_reports_the_results_of_random_scenes() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("selftest");
    let folder = folder.to_str().unwrap();
    let of = ["selftest", "--paper-kinds", "--seed", "1", "--first", "1", "--count", "4"];
    let said = succeeds(&[&of[..], &["--verify", "--save", folder, "--threads", "1"]].concat());
    for part in ["solved", "100.00 %", "estimated error", "slowest", "4 scenes compared", "0 errors more than 10 times"]
    {
        assert!(said.contains(part), "{part}: {said}");
    }
    // what is saved are the scenes that were solved
    let saved = format!("{folder}/selftest_1_4.ron");
    let text = fs::read_to_string(&saved).unwrap();
    assert!(text.starts_with("// solved\n"), "{text}");
    assert!(succeeds(&["solve", &saved, "--format", "csv"]).starts_with("interface,half_length"));
    // all kinds, to another tolerance
    let said = succeeds(&["selftest", "--seed", "1", "--first", "1", "--count", "2", "--tolerance", "1e-6"]);
    assert!(said.contains("100.00 %") && !said.contains("compared"), "{said}");
}

/// A scene that takes too much memory or time ends its own process only.
#[cfg(unix)]
#[test]
fn selftest_survives_scenes_that_take_too_much() {
    let of = ["selftest", "--seed", "1", "--count", "3", "--threads", "1"];
    let run = recede(&[&of[..], &["--memory", "1"]].concat(), b"");
    assert_eq!(run.status, Some(1), "{}", run.stderr);
    assert!(run.stdout.contains("killed   aborted, or more memory than 1 MB"), "{}", run.stdout);
    assert!(run.stdout.contains("100.00 %   0, 1, 2"), "{}", run.stdout);
    let run = recede(&[&of[..], &["--seconds", "0"]].concat(), b"");
    assert!(run.stdout.contains("killed   longer than 0 s"), "{}", run.stdout);
}
