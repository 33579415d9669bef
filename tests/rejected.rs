//! Rejected input: line, column, what was found, what is allowed and what to do, with exit status 2.
//!
//! Each `tests/rejected/THEME.txt` holds cases one after the other:
//!
//! ```text
//! == NAME
//! the scene, called NAME.ron
//! $ the command
//! ? its exit status
//! all that it writes to standard error
//! ```
//!
//! In a scene `\r`, `\t`, `\\` and `\xff` stand for one byte, and a `\` at the end of a line for no new line. Scenes of
//! `tests/accepted.txt` look like mistakes and are none; they have no command.
//!
//! After a deliberate change of messages, or for a new case without a command, run
//!
//! ```text
//! RECEDE_REWRITE=1 cargo test --locked --test all rejected::
//! ```
//!
//! which writes commands and messages again, and read the difference before committing it. Where `CI` is set this is an error.
use crate::support;

use std::collections::HashSet;
use std::env;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use recede::Scene;
use support::{Run, recede, recede_in};

/// The command of a case that has none.
const COMMAND: &str = "recede check";

/// One case of a table.
struct Case {
    name: String,
    /// The scene as it stands in the table.
    scene: String,
    /// The command, its exit status and what it writes.
    expected: String,
}

impl Case {
    /// The bytes of the scene.
    fn bytes(&self) -> Vec<u8> {
        let (mut bytes, mut rest) = (Vec::new(), &self.scene[..]);
        while let Some((before, escape)) = rest.split_once('\\') {
            bytes.extend(before.bytes());
            let (found, length): (&[u8], usize) = match escape.as_bytes() {
                [b'\n', ..] => (b"", 1),
                [b'r', ..] => (b"\r", 1),
                [b't', ..] => (b"\t", 1),
                [b'\\', ..] => (b"\\", 1),
                [b'x', _, _, ..] => (&[u8::from_str_radix(&escape[1..3], 16).unwrap()], 3),
                _ => panic!("{}: an escape is none of those above", self.name),
            };
            bytes.extend(found);
            rest = &escape[length..];
        }
        bytes.extend(rest.bytes());
        bytes
    }

    /// The scene as a file in a folder of its theme.
    fn file(&self, theme: &str) -> PathBuf {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("scenes").join(theme);
        fs::create_dir_all(&folder).unwrap();
        let file = folder.join(format!("{}.ron", self.name));
        fs::write(&file, self.bytes()).unwrap();
        file
    }

    /// The command of the case, and how it ends.
    fn found(&self, theme: &str) -> String {
        let file = self.file(theme);
        let name = format!("{}.ron", self.name);
        let first = self.expected.lines().next().unwrap_or_default();
        let command = first.strip_prefix("$ ").map_or(format!("{COMMAND} {name}"), str::to_owned);
        let words: Vec<&str> = command.split(' ').collect();
        assert_eq!((words[0], words[words.len() - 1]), ("recede", &name[..]), "{theme}");
        let Run { status, stdout, stderr } = recede_in(file.parent().unwrap(), &words[1..], b"");
        assert_eq!((status, &stdout[..]), (Some(2), ""), "{theme}, {name}: {stderr}");
        format!("$ {command}\n? 2\n{stderr}")
    }
}

/// The cases of a table.
fn cases(table: &Path) -> Vec<Case> {
    let text = format!("\n{}", fs::read_to_string(table).unwrap());
    let mut parts = text.split("\n== ");
    assert_eq!(parts.next(), Some(""), "{} begins with a case", table.display());
    let case = |part: &str| {
        let (name, body) = part.split_once('\n').unwrap();
        let (scene, expected) = body.split_at(body.find("$ recede ").unwrap_or(body.len()));
        Case { name: name.to_owned(), scene: scene.to_owned(), expected: expected.to_owned() }
    };
    let cases: Vec<Case> = parts.map(case).collect();
    let names: HashSet<&str> = cases.iter().map(|case| &case.name[..]).collect();
    assert_eq!(names.len(), cases.len(), "{}: a name stands twice", table.display());
    cases
}

/// All tables of rejected scenes, in order.
fn tables() -> Vec<PathBuf> {
    let folder = tests().join("rejected");
    let mut tables: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    tables.sort();
    assert!(!tables.is_empty() && tables.iter().all(|table| table.extension().is_some_and(|ending| ending == "txt")));
    tables
}

fn tests() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests")
}

#[test]
#[expect(clippy::disallowed_methods, reason = "who changes a message rewrites all, see above")]
fn scenes_are_rejected_with_the_message_below_them() {
    let rewrite = env::var_os("RECEDE_REWRITE").is_some();
    assert!(!(rewrite && env::var_os("CI").is_some()), "expectations are not rewritten where nobody reads them");
    let mut wrong = String::new();
    for table in tables() {
        let theme = table.file_stem().unwrap().to_str().unwrap();
        let mut written = Vec::new();
        for case in cases(&table) {
            let found = case.found(theme);
            if found != case.expected {
                writeln!(wrong, "{theme}, {}\n{}", case.name, difference(&case.expected, &found)).unwrap();
            }
            written.push(format!("== {}\n{}{found}", case.name, case.scene));
        }
        if rewrite {
            fs::write(&table, written.join("\n")).unwrap();
        }
    }
    assert!(rewrite || wrong.is_empty(), "- expected, + found\n{wrong}");
}

#[test]
fn what_looks_like_a_mistake_and_is_none() {
    for case in cases(&accepted()) {
        let Run { status, stderr, .. } = recede(&["check", case.file("accepted").to_str().unwrap()], b"");
        assert_eq!((status, &stderr[..]), (Some(0), ""), "{}", case.name);
    }
}

fn accepted() -> PathBuf {
    tests().join("accepted.txt")
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

/// A legal scene, to be spoilt.
fn plain() -> String {
    let plain = cases(&accepted()).into_iter().find(|case| case.name == "plain").unwrap();
    String::from_utf8(plain.bytes()).unwrap()
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
fn places_are_shown_in_long_lines_and_at_the_end() {
    let place = |text: &str| {
        let error = Scene::from_ron(text).unwrap_err();
        (error.line().unwrap(), error.column().unwrap(), error.excerpt().unwrap())
    };
    // columns count characters
    let excerpt = "2 | /* µµ */ geometri: 1)\n  |          ^".to_owned();
    assert_eq!(place("Scene(\n/* µµ */ geometri: 1)"), (2, 10, excerpt));
    assert_eq!(place("Scene(\r\n"), (2, 1, "2 | \n  | ^".to_owned()));
    // long lines are cut around the column
    let (line, column, excerpt) = place(&format!("(/*{}*/!/*{}*/)", "a".repeat(5000), "b".repeat(5000)));
    assert_eq!((line, column), (1, 5006));
    let (shown, caret) = excerpt.split_once('\n').unwrap();
    assert_eq!(shown.chars().count(), "1 | ".len() + 100);
    assert_eq!(shown.chars().nth(caret.find('^').unwrap()), Some('!'));
}

#[test]
fn of_long_messages_both_ends_are_shown() {
    let error = Scene::from_ron(&format!("Scene({}: 1)", "µ".repeat(5000))).unwrap_err();
    let message = error.message();
    assert!(message.starts_with("the scene has no field `µ") && message.ends_with("`stack`"), "{message}");
    assert!(message.contains("µ...µ") && message.chars().count() == 603, "{message}");
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
