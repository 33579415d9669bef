//! Documents tell the truth: commands shown in a ```console block are run and print what is shown there, scenes are
//! legal, programs are those that are compiled here, and what is pointed to exists.
//!
//! In a console block a line `$ recede ...` or `$ cargo run ... -- ...` is a command, run in a folder that holds
//! `examples/` and every scene of the document that begins with a comment such as `// my_scene.ron`. A line `? 2` below
//! it is its exit status (else 0), the lines below that what it prints. There `...` stands for any lines. Numbers may
//! differ in the tenth digit, counts by a quarter, and error estimates by a factor of ten, since rounding differs between
//! processors; times are not compared.
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

#[path = "docs/constants.rs"]
mod constants;
#[path = "docs/library.rs"]
mod library;
#[path = "docs/messages.rs"]
mod messages;
#[path = "docs/references.rs"]
mod references;

/// Commands that are shown and not run: building and testing are not repeated within a test.
const NOT_RUN: [&str; 6] = [
    "cargo bench --bench work_precision",
    "cargo build --release --locked",
    "cargo install --path . --locked",
    "cargo test --workspace --locked",
    "cargo doc --workspace --no-deps --open",
    ".ci/run",
];
/// Numbers agree if they differ by less than this part of them.
const SAME: f64 = 1e-9;
/// Numbers below `SAME` are error estimates or rounding: they agree if they differ by less than this factor,
const ESTIMATE: f64 = 10.0;
/// or are both below this.
const ROUNDING: f64 = 1e-13;
/// Counts agree if they differ by less than this part of them.
const COUNT: f64 = 0.25;
/// The word after a time, or the JSON key before it.
const TIMES: [&str; 3] = ["ms", "s", "\"seconds\""];
/// The word after a count, or the JSON key before it.
const COUNTS: [&str; 6] = ["modes,", "wavenumbers,", "Newton", "\"modes\"", "\"wavenumbers\"", "\"newton_steps\""];
const MARK: &str = "// ---- not shown ----";

/// A fenced block of a document.
struct Block {
    language: String,
    text: String,
    line: usize,
}

#[test]
fn commands_print_what_is_shown() {
    let mut commands = 0;
    for document in documents() {
        let blocks = blocks(&document);
        let folder = folder(&document, &blocks);
        for block in blocks.iter().filter(|block| block.language == "console") {
            for (line, command, expected) in dialogue(block) {
                if NOT_RUN.contains(&command) {
                    continue;
                }
                let shown = run(command, &folder).unwrap_or_else(|| panic!("{}:{line}: {command}", document.display()));
                let same = same_lines(&lines(&shown), &expected);
                assert!(same, "{}:{line}: {command}\nprints\n{shown}", document.display());
                commands += 1;
            }
        }
    }
    assert!(commands > 10, "only {commands} commands found");
}

#[test]
fn scenes_are_legal() {
    for document in documents() {
        for block in blocks(&document).iter().filter(|block| block.language == "ron") {
            let name = format!("{}:{}", document.display(), block.line);
            if recede::Sweep::begins(&block.text) {
                assert!(file_name(block).is_some(), "{name}: a name by which a command runs it");
                continue;
            }
            let scene = recede::Scene::from_ron(&block.text).unwrap_or_else(|error| panic!("{name}: {error}"));
            assert!(scene.stack().is_ok(), "{name}");
        }
    }
}

#[test]
fn programs_are_those_that_are_compiled() {
    let sources: Vec<String> = ["tests/docs/library.rs", "examples/custom_layer.rs"]
        .iter()
        .map(|name| {
            let text = read(&root().join(name));
            let text = text.split(MARK).next().unwrap_or_default();
            text.lines().filter(|line| !line.starts_with("//!")).collect::<Vec<_>>().join("\n").trim().to_owned()
        })
        .collect();
    for document in documents() {
        for block in blocks(&document).iter().filter(|block| block.language == "rust") {
            let part = sources.iter().any(|source| source.contains(block.text.trim()));
            assert!(part, "{}:{}: no such program", document.display(), block.line);
        }
    }
    assert!(read(&root().join("README.md")).contains(&sources[0]), "README.md shows another program");
}

#[test]
fn what_is_pointed_to_exists() {
    for document in documents() {
        let text = read(&document);
        for (at, _) in text.match_indices("](") {
            let target = text[at + 2..].split(')').next().unwrap_or_default();
            let (file, anchor) = target.split_once('#').unwrap_or((target, ""));
            if target.starts_with("http") {
                continue;
            }
            let path = match file {
                "" => document.clone(),
                file => document.parent().expect("a folder").join(file),
            };
            assert!(path.exists(), "{}: {target}", document.display());
            let headings =
                || read(&path).lines().filter(|line| line.starts_with('#')).map(anchor_of).collect::<Vec<_>>();
            assert!(anchor.is_empty() || headings().iter().any(|a| a == anchor), "{}: {target}", document.display());
        }
        // names of files in backticks
        for name in text.split('`').skip(1).step_by(2) {
            let folders = ["src/", "layers/", "tests/", "examples/", "docs/", ".ci/"];
            let plain = name.chars().all(|c| c.is_alphanumeric() || "/._-".contains(c));
            if plain && folders.iter().any(|folder| name.starts_with(folder)) {
                assert!(root().join(name).exists(), "{}: {name}", document.display());
            }
        }
    }
}

#[test]
fn equations_are_numbered_in_order_and_cited_ones_exist() {
    let theory = read(&root().join("docs/theory.md"));
    let number = |text: &str| text.split('}').next().and_then(|number| number.parse::<usize>().ok());
    let numbers: Vec<usize> = theory.split("\\tag{").skip(1).filter_map(number).collect();
    assert_eq!(numbers, (1..=numbers.len()).collect::<Vec<_>>());
    let sources = ["src", "layers"].into_iter().flat_map(|folder| files(&root().join(folder), "rs"));
    for file in documents().into_iter().chain(sources) {
        for cited in read(&file).split("eq. (").skip(1) {
            let cited: usize = cited.split(')').next().and_then(|n| n.parse().ok()).expect("a number");
            assert!(numbers.contains(&cited), "{}: eq. ({cited})", file.display());
        }
    }
}

#[test]
fn the_laws_of_a_layer_are_those_that_examine_it() {
    let document = read(&root().join("docs/adding_a_layer.md"));
    let table = document.split("| law | what it says |").nth(1).expect("the table of laws");
    let rows = table.lines().skip(2).map_while(|line| line.strip_prefix("| `")?.split('`').next());
    assert!(rows.eq(recede::layers::conformance::LAWS.iter().map(|(name, _)| *name)));
}

/// A message that is quoted in a block of its own is one that the tests of rejected scenes know, but for the name of the file.
#[test]
fn messages_are_printed() {
    let known: String = files(&root().join("tests/rejected"), "txt").iter().map(|file| read(file)).collect();
    for document in documents() {
        for block in blocks(&document).iter().filter(|block| block.text.starts_with("error: ")) {
            let message = block.text.trim_end().split_once(".ron:").expect("a message names a scene").1;
            assert!(known.contains(message), "{}:{}: {message}", document.display(), block.line);
        }
    }
}

#[test]
fn keys_of_json_are_explained() {
    let explained = read(&root().join("docs/formats.md"));
    let scene = "examples/scenes/two_strips.ron";
    for command in [format!("solve {scene} --format json --fields"), format!("field {scene} --at 0,0 --format json")] {
        let shown = run(&format!("recede {command}"), &root()).expect("a command");
        let mut keys = Vec::new();
        collect_keys(&serde_json::from_str(&shown).expect("JSON"), &mut keys);
        for key in keys {
            let is_explained = [format!("`{key}`"), format!(".{key}`")].iter().any(|name| explained.contains(name));
            assert!(is_explained, "docs/formats.md does not explain {key} of `recede {command}`");
        }
    }
}

fn collect_keys(value: &serde_json::Value, keys: &mut Vec<String>) {
    match value {
        serde_json::Value::Object(fields) => fields.iter().for_each(|(key, value)| {
            keys.push(key.clone());
            collect_keys(value, keys);
        }),
        serde_json::Value::Array(items) => items.iter().for_each(|item| collect_keys(item, keys)),
        _ => {}
    }
}

/// What code hosts leave of formulas: within a line Markdown takes the backslash before punctuation for its own, and one
/// macro is not allowed at all.
#[test]
fn formulas_are_shown_by_code_hosts() {
    for document in documents() {
        let text = read(&document);
        assert!(!text.contains("\\operatorname"), "{}: \\operatorname", document.display());
        let mut inside_block = false;
        for (index, line) in text.lines().enumerate() {
            if line.starts_with("```") {
                inside_block = !inside_block;
            } else if !inside_block {
                // code first, then formulas
                let prose = line.split('`').step_by(2).collect::<Vec<_>>().join("x");
                for formula in prose.split('$').skip(1).step_by(2) {
                    let eaten =
                        formula.split('\\').skip(1).any(|rest| rest.starts_with(|c: char| c.is_ascii_punctuation()));
                    assert!(!eaten, "{}:{}: ${formula}$", document.display(), index + 1);
                }
            }
        }
    }
}

#[test]
fn the_test_command_of_the_readme_is_that_of_the_checks() {
    let checks = read(&root().join(".ci/run"));
    assert!(read(&root().join("README.md")).contains("$ cargo test --workspace --locked\n"));
    assert!(checks.lines().any(|line| line == "cargo test --workspace --locked"));
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// All Markdown files at the top and in docs/.
fn documents() -> Vec<PathBuf> {
    let top = fs::read_dir(root()).expect("a readable folder").map(|entry| entry.expect("a readable folder").path());
    let top = top.filter(|path| path.extension().is_some_and(|found| found == "md"));
    let mut documents: Vec<PathBuf> = top.chain(files(&root().join("docs"), "md")).collect();
    documents.sort();
    documents
}

/// All files below a folder with this ending.
fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let paths = entries.map(|entry| entry.expect("a readable folder").path());
    paths
        .flat_map(|path| match path.is_dir() {
            true => files(&path, ending),
            false => Vec::from_iter(path.extension().is_some_and(|found| found == ending).then_some(path)),
        })
        .collect()
}

fn blocks(document: &Path) -> Vec<Block> {
    let text = read(document);
    let mut blocks: Vec<Block> = Vec::new();
    let mut open = false;
    for (index, line) in text.lines().enumerate() {
        match (line.strip_prefix("```"), open) {
            (Some(language), false) => {
                blocks.push(Block { language: language.to_owned(), text: String::new(), line: index + 2 });
                open = true;
            }
            (Some(_), true) => open = false,
            (None, true) => {
                let block = blocks.last_mut().expect("an open block");
                block.text += line;
                block.text.push('\n');
            }
            (None, false) => {}
        }
    }
    assert!(!open, "{}: a block is not closed", document.display());
    blocks
}

/// A folder with the examples and the scenes of a document.
fn folder(document: &Path, blocks: &[Block]) -> PathBuf {
    let name = document.file_stem().expect("a name");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("docs").join(name);
    for examples in ["examples/scenes", "examples/axisymmetric", "examples/sweeps"] {
        fs::create_dir_all(folder.join(examples)).expect("a folder to write to");
        for path in files(&root().join(examples), "ron") {
            fs::copy(&path, folder.join(examples).join(path.file_name().expect("a name"))).expect("a file to copy");
        }
    }
    for block in blocks {
        if let Some(name) = file_name(block) {
            fs::write(folder.join(name), &block.text).expect("a file to write");
        }
    }
    folder
}

/// The name of the file that a block shows, in its first line.
fn file_name(block: &Block) -> Option<&str> {
    let name = block.text.lines().next()?.strip_prefix("// ")?;
    (name.ends_with(".ron") && !name.contains(['/', ' '])).then_some(name)
}

/// Line number, command and what is printed below it.
fn dialogue(block: &Block) -> Vec<(usize, &str, Vec<&str>)> {
    let mut dialogue: Vec<(usize, &str, Vec<&str>)> = Vec::new();
    for (index, line) in block.text.lines().enumerate() {
        match line.strip_prefix("$ ") {
            Some(command) => dialogue.push((block.line + index, command, Vec::new())),
            None => dialogue.last_mut().expect("a block begins with a command").2.push(line),
        }
    }
    dialogue
}

/// What a command prints, its exit status first unless it is 0; `None` if it is not a command that can be run here.
fn run(command: &str, folder: &Path) -> Option<String> {
    let arguments = command
        .strip_prefix("recede ")
        .or_else(|| command.strip_prefix("cargo run --release --locked -- "))
        .filter(|arguments| !arguments.contains(['"', '\'', '|', '>']))?;
    let (arguments, input) = arguments.split_once(" < ").unwrap_or((arguments, ""));
    let mut child = Command::new(env!("CARGO_BIN_EXE_recede"))
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .env("NO_COLOR", "1")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .ok()?;
    let mut stdin = child.stdin.take()?;
    if !input.is_empty() {
        let _ = stdin.write_all(&fs::read(folder.join(input)).ok()?);
    }
    drop(stdin);
    let output = child.wait_with_output().ok()?;
    let status = match output.status.code()? {
        0 => String::new(),
        status => format!("? {status}\n"),
    };
    Some(status + &String::from_utf8_lossy(&output.stdout) + &String::from_utf8_lossy(&output.stderr))
}

fn lines(text: &str) -> Vec<&str> {
    text.trim_end().lines().collect()
}

/// Whether lines are those expected, among which `...` stands for any.
fn same_lines(found: &[&str], expected: &[&str]) -> bool {
    match (found, expected) {
        ([], []) => true,
        (_, ["...", rest @ ..]) => (0..=found.len()).any(|skipped| same_lines(&found[skipped..], rest)),
        ([first, found @ ..], [line, expected @ ..]) => same_line(first, line) && same_lines(found, expected),
        ([], [line, rest @ ..]) => line.trim().is_empty() && same_lines(found, rest),
        _ => false,
    }
}

fn same_line(found: &str, expected: &str) -> bool {
    let (found, expected) = (words(found), words(expected));
    found.len() == expected.len()
        && found.iter().zip(&expected).enumerate().all(|(i, (a, b))| {
            let beside = |names: &[&str]| {
                let neighbours = [i.checked_sub(1), Some(i + 1)];
                neighbours.into_iter().flatten().any(|k| found.get(k).is_some_and(|word| names.contains(word)))
            };
            match (a.parse::<f64>(), b.parse::<f64>()) {
                (Ok(_), Ok(_)) if beside(&TIMES) => true,
                (Ok(a), Ok(b)) => same_number(a, b, if beside(&COUNTS) { COUNT } else { SAME }),
                // a rule of a table is as long as its numbers have digits
                _ => a == b || (is_rule(a) && is_rule(b)),
            }
        })
}

fn same_number(a: f64, b: f64, part: f64) -> bool {
    let (least, most) = (a.abs().min(b.abs()), a.abs().max(b.abs()));
    (a - b).abs() <= part * most || most < ROUNDING || most < SAME && most <= ESTIMATE * least
}

/// Whether a word is nothing but a horizontal line.
fn is_rule(word: &str) -> bool {
    word.chars().all(|c| c == '─')
}

/// The words of a line; commas and colons of CSV and JSON end a word where a number follows.
fn words(line: &str) -> Vec<&str> {
    let bare = |word: &'_ str| -> usize {
        let number = word.trim_end_matches(',');
        if number.parse::<f64>().is_ok() { number.len() } else { word.trim_end_matches(':').len() }
    };
    let parts = line.split_whitespace().flat_map(|word| word.split_inclusive(','));
    parts.map(|word| &word[..bare(word)]).collect()
}

/// The anchor under which a heading of Markdown is found.
fn anchor_of(heading: &str) -> String {
    let text = heading.trim_start_matches('#').trim().to_lowercase();
    text.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c)).map(|c| if c == ' ' { '-' } else { c }).collect()
}
