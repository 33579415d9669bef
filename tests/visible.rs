//! What others have written is shown, and does nothing to a terminal, a table or a picture.
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::support::recede;

fn stdout(arguments: &[&str]) -> String {
    recede(arguments, b"").stdout
}

/// Names come from others: nothing in them reaches a terminal, a table or a picture that could do something there.
#[test]
fn control_characters_are_shown_and_not_sent() {
    let evil = "\\u{1b}]0;a\\u{7}\\u{9b}31m\\u{7f}\\r\\n\\u{0}";
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("control");
    fs::create_dir_all(&folder).unwrap();
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let [scene, wrong, unnamed] = ["scene.ron", "wrong.ron", "un\u{1b}[31mnamed.ron"].map(at);
    let text = format!(
        "Scene(name: \"n{evil}\", description: \"d{evil}\", units: (length: \"l{evil}\", force: \"f{evil}\"),
        geometry: PlaneStrain, punch: Parabola(radius: 500), force: 0.002, stack: [
        Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Receding, HalfPlane(shear_modulus: 1, poisson: 0.25)])"
    );
    fs::write(&scene, &text).unwrap();
    fs::write(&unnamed, text.replacen("name", "nme", 1)).unwrap();
    fs::write(&wrong, text.replacen("500", "\"5 \u{1b}[31m\u{9b}m\"", 1)).unwrap();
    fs::write(at("part.csv"), "force\n\u{1b}[31m,\u{9b}\n").unwrap();
    let [svg, csv] = ["scene.svg", "rows.csv"].map(at);
    let vary = ["--vary", "force=0.001:0.002:3"];
    let json = |text: &str| serde_json::from_str::<Value>(text).unwrap();
    for words in [
        &["check", &scene][..],
        &["show", &scene],
        &["solve", &scene, "--extremes"],
        &["solve", &scene, "--format", "json"],
        &["solve", &scene, "--format", "csv"],
        &["convert", &scene],
        &["convert", &scene, "--to", "ron"],
        &["field", &scene],
        &["field", &scene, "--format", "json"],
        &["field", &scene, "--out", &svg],
        &["profile", &scene, "--points", "10"],
        &["plot", &scene, "--out", &svg, "--title"],
        &["plot", &scene, "--out", &svg, "--title=\u{1b}[31m"],
        &["sweep", &scene, vary[0], vary[1], "--plot", &svg, "--out", &csv],
        &["check", &wrong],
        &["check", &unnamed],
        &["check", "no\u{1b}[31m\u{9b}.ron"],
        &["sweep", &scene, "--vary", "fo\u{1b}[31m=[1]"],
        &["merge", &scene, vary[0], vary[1], &at("part.csv"), "--out", &csv],
        &["solve", &scene, "--out", "no\u{1b}[31m/x.csv"],
    ] {
        let run = recede(words, b"");
        let picture = fs::read_to_string(&svg).unwrap_or_default();
        for said in [&run.stdout, &run.stderr, &picture] {
            let found = said.chars().find(|c| c.is_control() && *c != '\n');
            assert!(found.is_none(), "{words:?}: {found:?} in {said:?}");
        }
        assert!(
            words[0] == "merge" || (run.status == Some(0)) == words[1].ends_with("scene.ron") || run.status == Some(2)
        );
    }
    // and nothing is lost where it is read again
    let name = "n\u{1b}]0;a\u{7}\u{9b}31m\u{7f}\r\n\u{0}";
    assert_eq!(json(&stdout(&["convert", &scene]))["name"], name);
    assert_eq!(json(&stdout(&["solve", &scene, "--format", "json"]))["scene"], name);
    assert!(stdout(&["solve", &scene]).starts_with("n\\u{1b}]0;a\\u{7}\\u{9b}31m\\u{7f}  \\u{0}\n"));
}
