//! Rejected input: line, column, what was found, what is allowed and what to do, with exit status 2.
//!
//! Each `tests/rejected/GROUP/NAME.ron` has beside it `NAME.txt`: the command, its exit status and all that it writes to
//! standard error. Scenes of `tests/accepted` look like mistakes and are none.
//!
//! After a deliberate change of messages, or for a new scene, run
//!
//! ```text
//! RECEDE_REWRITE=1 cargo test --locked --test all rejected::
//! ```
//!
//! which writes every `NAME.txt` again, and read the difference before committing it. Where `CI` is set this is an error.
use crate::support;

use std::env;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use support::{Run, recede, recede_in};

/// The command of a scene without a text beside it.
const COMMAND: &str = "recede check";

#[test]
#[expect(clippy::disallowed_methods, reason = "who changes a message rewrites all, see above")]
fn scenes_are_rejected_with_the_message_beside_them() {
    let rewrite = env::var_os("RECEDE_REWRITE").is_some();
    assert!(!(rewrite && env::var_os("CI").is_some()), "expectations are not rewritten where nobody reads them");
    let mut wrong = String::new();
    let scenes = files("rejected", "ron");
    for scene in &scenes {
        let text = scene.with_extension("txt");
        let expected = fs::read_to_string(&text).unwrap_or_default();
        let found = message(scene, &expected);
        if rewrite {
            fs::write(text, found).unwrap();
        } else if found != expected {
            writeln!(wrong, "{}\n{}", text.display(), difference(&expected, &found)).unwrap();
        }
    }
    assert!(wrong.is_empty(), "- expected, + found\n{wrong}");
    let with_text = files("rejected", "txt").into_iter().map(|text| text.with_extension("ron"));
    assert!(with_text.eq(scenes), "every text belongs to a scene");
}

#[test]
fn what_looks_like_a_mistake_and_is_none() {
    for scene in files("accepted", "ron") {
        let Run { status, stderr, .. } = recede(&["check", scene.to_str().unwrap()], b"");
        assert_eq!((status, &stderr[..]), (Some(0), ""), "{}", scene.display());
    }
}

/// The command that stands in the text beside a scene, and how it ends.
fn message(scene: &Path, text: &str) -> String {
    let name = scene.file_name().unwrap().to_str().unwrap();
    let first = text.lines().next().unwrap_or_default();
    let command = first.strip_prefix("$ ").map_or(format!("{COMMAND} {name}"), str::to_owned);
    let words: Vec<&str> = command.split(' ').collect();
    assert_eq!((words[0], words[words.len() - 1]), ("recede", name), "{}", scene.display());
    let Run { status, stdout, stderr } = recede_in(scene.parent().unwrap(), &words[1..], b"");
    assert_eq!((status, &stdout[..]), (Some(2), ""), "{}: {stderr}", scene.display());
    format!("$ {command}\n? 2\n{stderr}")
}

/// The lines from the first to the last one that differ.
fn difference(expected: &str, found: &str) -> String {
    let (expected, found): (Vec<_>, Vec<_>) = (expected.lines().collect(), found.lines().collect());
    let alike = |a: &mut dyn Iterator<Item = (&&str, &&str)>| a.take_while(|(a, b)| a == b).count();
    let before = alike(&mut expected.iter().zip(&found));
    let after = alike(&mut expected[before..].iter().rev().zip(found[before..].iter().rev()));
    let marked = |sign: char, lines: &[&str]| -> String {
        lines[before..lines.len() - after].iter().map(|line| format!("{sign} {line}\n")).collect()
    };
    marked('-', &expected) + &marked('+', &found)
}

/// All files of a folder of tests with this ending, in order.
fn files(folder: &str, ending: &str) -> Vec<PathBuf> {
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(folder)];
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|found| found == ending) {
                files.push(path);
            }
        }
    }
    files.sort();
    assert!(!files.is_empty(), "{folder} has no .{ending}");
    files
}

/// A legal scene, to be spoilt.
fn plain() -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/accepted/plain.ron")).unwrap()
}

/// The legal scene with `from` replaced by `to`.
fn with(from: &str, to: &str) -> String {
    let plain = plain();
    assert_eq!(plain.matches(from).count(), 1, "{from}");
    plain.replace(from, to)
}

/// What `recede check` says to a text that must be rejected.
fn rejection(text: impl AsRef<[u8]>) -> String {
    let Run { status, stdout, stderr } = recede(&["check", "-"], text.as_ref());
    assert_eq!((status, &stdout[..]), (Some(2), ""), "{stderr}");
    stderr
}

#[test]
fn texts_cut_off_anywhere() {
    let plain = plain();
    for end in 0..plain.trim_end().len() {
        let text = rejection(&plain[..end]);
        assert!(text.starts_with("error: stdin:"), "{text}");
    }
}

#[test]
fn endless_texts_nesting_and_stacks() {
    for bracket in ["[", "(", "{", "Some(", "Cylinder(radius: ", "a(", "/*", "#![", "((((,"] {
        let nested = bracket.repeat((1 << 20) / bracket.len() - 100);
        rejection(&nested);
        for (from, to) in [("0.002", nested.as_str()), ("Cylinder(", &nested), ("Bonded", &nested), ("4.0", &nested)] {
            rejection(with(from, to));
        }
    }
    let long = rejection(vec![b' '; (1 << 20) + 1]);
    let expected = "error: stdin: the text is larger than 1048576 bytes, the most that is read\n\
                    hint: is this a scene file?\n";
    assert_eq!(long, expected);
    let plain = plain();
    let (start, end) = (plain.find("Homogeneous").unwrap(), plain.find("\n    ],").unwrap());
    let many = rejection(format!("{}{}{}", &plain[..start], "Rigid,".repeat(100_001), &plain[end..]));
    let expected = "error: stdin:5:12: the stack has 100001 items; allowed are at most 100000\n";
    assert_eq!(many, format!("{expected}  5 |     stack: [\n    |            ^\n"));
}

#[test]
fn files_that_cannot_be_read() {
    for (arguments, name) in
        [(["solve", "no/such/scene.ron"], "no/such/scene.ron"), (["check", "examples"], "examples")]
    {
        let Run { status, stderr, .. } = recede(&arguments, b"");
        assert_eq!(status, Some(2));
        assert!(stderr.starts_with(&format!("error: {name}: cannot be read: ")), "{stderr}");
    }
}
