//! What a newcomer reads first: help on terminals of any width, and the first scene.
use crate::support;

use std::fs;
use std::path::Path;
use std::process::Command;

use support::recede;

/// All commands that have a help of their own; "" for the command itself.
const COMMANDS: [&str; 15] = [
    "",
    "solve",
    "check",
    "show",
    "convert",
    "field",
    "profile",
    "list",
    "selftest",
    "sweep",
    "merge",
    "plot",
    "init",
    "completions",
    "man",
];

/// The help of a command on a terminal that is so wide.
fn help(command: &str, width: usize) -> String {
    let arguments = [command, "--help"].into_iter().filter(|argument| !argument.is_empty());
    let run =
        Command::new(env!("CARGO_BIN_EXE_recede")).args(arguments).env("COLUMNS", width.to_string()).output().unwrap();
    assert!(run.status.success(), "{command}");
    String::from_utf8(run.stdout).unwrap()
}

/// A paragraph that is broken by hand, too, has short lines between long ones.
#[test]
fn lines_end_where_the_next_word_does_not_fit() {
    for command in COMMANDS {
        for width in [80, 100] {
            let help = help(command, width);
            let lines: Vec<&str> = help.lines().collect();
            let is_text = |line: &str| line.starts_with(|c: char| c.is_alphabetic()) && !line.ends_with(':');
            for pair in lines.windows(2).filter(|pair| pair.iter().all(|line| is_text(line))) {
                let next = pair[1].split(' ').next().unwrap_or_default();
                let with_next = pair[0].trim_end().chars().count() + 1 + next.chars().count();
                assert!(with_next > width, "{command}, {width}: {:?} {:?}", pair[0], pair[1]);
            }
        }
    }
}

/// Examples are copied from a terminal of usual width: each is one line there.
#[test]
fn examples_are_not_broken() {
    for command in COMMANDS {
        let examples = |width: usize| {
            let help = help(command, width);
            let examples =
                help.split_once("Examples:\n").map(|(_, examples)| examples.split("\n\n").next().unwrap_or_default());
            examples.unwrap_or_default().to_owned()
        };
        let wide = examples(100);
        assert_eq!(examples(80), wide, "{command}");
        assert!(wide.lines().all(|line| line.starts_with("  ") && line.contains("recede")), "{command}: {wide}");
    }
}

/// What the comments of the first scene say may stand there is accepted there.
#[test]
fn alternatives_in_the_first_scene_are_legal() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("help");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join("scene.ron");
    let run = recede(&["init", file.to_str().unwrap()], b"");
    assert_eq!(run.status, Some(0), "{}", run.stderr);
    let scene = fs::read_to_string(&file).unwrap();
    for command in ["recede check", "recede solve", "recede plot", "recede list"] {
        assert!(scene.contains(command), "{command}");
    }
    let checks = |text: &str| {
        let run = recede(&["check", "-"], text.as_bytes());
        assert_eq!(run.status, Some(0), "{text}\n{}", run.stderr);
    };
    for other in ["two-rollers", "eccentric-seal"] {
        let run = recede(&["init", "-", "--scene", other], b"");
        assert!(run.status == Some(0) && run.stdout.contains("punches: ["), "{other}: {}", run.stderr);
        checks(&run.stdout);
    }
    let graded = scene.split_once("profiles: ").unwrap().1.split_once(".\n").unwrap().0;
    assert!(graded.starts_with("Graded("), "{graded}");
    checks(&scene.replace("Exponential(thickness: 1.0, young: 67600.0, poisson: 0.3, beta: -1.0)", graded));
    for round in ["Sphere(radius: 100.0)", "Cone(slope: 0.01)", "Flat(radius: 1.0)"] {
        let name = round.split('(').next().unwrap();
        assert!(scene.contains(&format!("{name}(")), "{name}");
        let scene = scene.replace("geometry: PlaneStrain,", "geometry: Axisymmetric,");
        checks(&scene.replace("punch: Cylinder(radius: 100.0)", &format!("punch: {round}")));
    }
}
