//! The promises of docs/architecture.md: one direction of imports, layers that know no solver, files one can read.
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

#[path = "support/modules.rs"]
mod imports;

use imports::Files;

/// A file longer than this holds more than one thing.
const LONGEST: usize = 450;

/// For each module of the library the modules that it may import, in the order in which data flow. Plain
/// values that everybody may name are not listed, see [`SHARED`].
const MAY_IMPORT: [(&str, &[&str]); 23] = [
    ("numeric", &[]),
    ("axis", &[]),
    ("files", &[]),
    ("options", &[]),
    ("geometry", &[]),
    ("solution", &[]),
    ("scene", &[]),
    ("stack", &["numeric", "scene"]),
    ("system", &["stack"]),
    ("kernel", &["numeric", "stack", "system"]),
    ("validity", &["kernel", "scene"]),
    ("contact", &["kernel", "numeric", "scene", "system", "validity"]),
    ("field", &["numeric", "stack", "system"]),
    ("weights", &["field", "kernel", "numeric", "stack", "system"]),
    ("approach", &["contact", "field", "kernel", "numeric", "scene", "stack"]),
    // put together from the errors of the stages, for all that stands above them
    ("errors", &["approach", "axis", "contact", "field", "scene", "stack", "system"]),
    ("profile", &["field", "scene", "stack"]),
    ("collocation", &["contact", "errors", "field", "kernel", "numeric", "profile", "scene", "stack"]),
    (
        "model",
        &["approach", "collocation", "contact", "errors", "field", "kernel", "profile", "scene", "stack", "weights"],
    ),
    ("sweep", &["approach", "axis", "errors", "field", "model", "scene", "stack"]),
    ("plot", &["axis", "field", "files", "profile", "scene", "stack", "sweep"]),
    ("report", &["approach", "collocation", "errors", "field", "profile", "scene", "sweep"]),
    (
        "selftest",
        &[
            "approach", "contact", "errors", "field", "model", "profile", "numeric", "plot", "report", "scene",
            "stack", "system",
        ],
    ),
];

/// The rooms of the contact solver, in the order in which an answer goes through them: each imports those before it only.
const ROOMS: [&str; 10] = [
    "error",
    "problem",
    "answer",
    "integrals",
    "programme",
    "intervals",
    "starts",
    "thin",
    "prescribed",
    "interpolation",
];

/// Leaves: what is asked for, and what comes out. Anything but `numeric` may import them.
const SHARED: [&str; 3] = ["options", "geometry", "solution"];

/// Words that end a program, and a phrase of the one line that may contain them: a macro that makes tests.
const ABRUPT: [&str; 6] = [".unwrap()", ".expect(", "panic!(", "unreachable!(", "todo!(", "unimplemented!("];
const IN_A_MACRO_FOR_TESTS: &str = "panic!(\"{violation}\")";

/// Words that write past the writer that a function was given.
const PRINTING: [&str; 5] = ["println!(", "eprintln!(", "print!(", "eprint!(", "dbg!("];

#[test]
fn imports_go_one_way() {
    let exported = exported();
    let mut wrong = Vec::new();
    for file in library() {
        let module = module(&file);
        let allowed = MAY_IMPORT.iter().find(|(name, _)| *name == module).map(|(_, allowed)| *allowed);
        for path in paths(&code(&file)) {
            let first = path.trim_start_matches("crate::").split("::").next().unwrap_or_default();
            let target = exported.get(first).map_or(first, String::as_str);
            let legal = match (&module[..], allowed) {
                ("lib", _) => true,
                (own, _) if own == target => true,
                ("numeric" | "options" | "solution", _) => false,
                (_, Some(allowed)) => allowed.contains(&target) || SHARED.contains(&target),
                (_, None) => false,
            };
            if !legal {
                wrong.push(format!("{}: `{module}` imports `{path}`", file.display()));
            }
        }
    }
    none(&wrong);
}

#[test]
fn a_module_may_import_only_modules_before_it() {
    let before = |module: &str| MAY_IMPORT.iter().position(|(name, _)| *name == module);
    let arrows = MAY_IMPORT.iter().flat_map(|(module, allowed)| allowed.iter().map(move |target| (module, target)));
    let backward = arrows.filter(|(module, target)| before(target) >= before(module) || before(target).is_none());
    none(&backward.map(|(module, target)| format!("`{module}` may import `{target}`")).collect::<Vec<_>>());
}

#[test]
fn an_answer_goes_through_the_rooms_of_the_contact_solver_in_order() {
    let files = modules(library(), "src");
    let room = |path: &[String]| ROOMS.iter().position(|room| path.get(1).is_some_and(|own| own == room));
    let mut wrong = Vec::new();
    for module in files.texts.keys().filter(|module| module.len() > 1 && module[0] == "contact") {
        let own = room(module).unwrap_or_else(|| panic!("{}: say in `ROOMS` where it is", module.join("::")));
        for path in files.imports(module).iter().filter(|path| path[0] == "contact") {
            if room(path).is_none_or(|other| other > own) {
                wrong.push(format!("{} imports {}", module.join("::"), path.join("::")));
            }
        }
    }
    none(&wrong);
}

#[test]
fn no_two_files_import_each_other_in_a_circle() {
    let crates = [
        ("src", modules(library(), "src")),
        ("layers", modules(layers(), "layers")),
        ("python/src", modules(rust_files("python/src"), "python/src")),
    ];
    for (name, files) in crates {
        let circles = files.circles();
        let circles = circles.iter().map(|circle| format!("{name}: {}", circle.join(" -> ")));
        none(&circles.collect::<Vec<_>>());
    }
}

#[test]
fn every_module_has_its_place_in_the_order() {
    for file in library() {
        let module = module(&file);
        let known = module == "lib" || MAY_IMPORT.iter().any(|(name, _)| *name == module);
        assert!(known, "{}: say in `MAY_IMPORT` what `{module}` may import", file.display());
    }
}

#[test]
fn the_command_uses_the_library_as_anybody_does() {
    for file in command() {
        let text = code(&file);
        assert!(paths(&text).is_empty(), "{}: not through `recede::`: {:?}", file.display(), paths(&text));
    }
}

#[test]
fn layers_know_no_solver() {
    let manifest = read(&root().join("layers/Cargo.toml"));
    let depends = manifest.lines().any(|line| line.split(['=', '.']).next().is_some_and(|key| key.trim() == "recede"));
    assert!(!depends, "layers/Cargo.toml depends on `recede`");
    for file in rust_files("layers") {
        assert!(!code(&file).contains("recede::"), "{}", file.display());
    }
}

#[test]
fn every_file_begins_with_what_it_is_for() {
    let silent = all().into_iter().filter(|file| !read(file).starts_with("//! "));
    none(&silent.map(|file| format!("{} does not begin with `//! `", file.display())).collect::<Vec<_>>());
}

#[test]
fn no_file_is_too_long_to_read() {
    let lengths = all().into_iter().map(|file| (read(&file).lines().count(), file));
    let long = lengths.filter(|(lines, _)| *lines > LONGEST);
    none(&long.map(|(lines, file)| format!("{}: {lines} lines", file.display())).collect::<Vec<_>>());
}

#[test]
fn errors_are_returned() {
    let files = rust_files("src").into_iter().chain(rust_files("layers"));
    let mut abrupt = Vec::new();
    for file in files.filter(|file| !is_test(file)) {
        for (number, line) in code(&file).lines().enumerate() {
            if ABRUPT.iter().any(|word| line.contains(word)) && !line.contains(IN_A_MACRO_FOR_TESTS) {
                abrupt.push(format!("{}:{}: {}", file.display(), number + 1, line.trim()));
            }
        }
    }
    none(&abrupt);
}

#[test]
fn nothing_is_printed_behind_the_callers_back() {
    let files = rust_files("src").into_iter().chain(rust_files("layers"));
    let mut printing = Vec::new();
    for file in files.filter(|file| !is_test(file)) {
        for (number, line) in code(&file).lines().enumerate() {
            if PRINTING.iter().any(|word| line.contains(word)) {
                printing.push(format!("{}:{}: {}", file.display(), number + 1, line.trim()));
            }
        }
    }
    none(&printing);
}

#[test]
fn a_path_is_found_wherever_it_stands() {
    let text = "use crate::error::Error;\nuse crate::{kernel::Kernel, numeric};\nlet x = crate::scene::Punch::new();\n";
    let found = paths(text);
    assert_eq!(found, ["crate::error::Error", "crate::kernel::Kernel", "crate::numeric", "crate::scene::Punch::new"]);
    assert_eq!(paths("use crate::{\n    stack::{Base, Stack},\n    Error,\n};"), ["crate::stack", "crate::Error"]);
    assert!(paths("my_crate::x, $crate::y").is_empty());
}

/// The modules of a crate in a folder.
fn modules(files: Vec<PathBuf>, folder: &str) -> Files {
    Files::of(files.into_iter().map(|file| (file.clone(), code(&file))).collect(), &root().join(folder))
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// All Rust files below a folder of the package, in order.
fn rust_files(folder: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![root().join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).into_iter().flatten() {
            let path = entry.expect("a readable folder").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

fn all() -> Vec<PathBuf> {
    ["src", "layers", "tests", "examples"].into_iter().flat_map(rust_files).collect()
}

/// The files of the command.
fn command() -> Vec<PathBuf> {
    let main = root().join("src/main.rs");
    rust_files("src").into_iter().filter(|file| *file == main || file.starts_with(root().join("src/cli"))).collect()
}

/// The files of the library.
fn library() -> Vec<PathBuf> {
    let command = command();
    rust_files("src").into_iter().filter(|file| !command.contains(file) && !is_test(file)).collect()
}

/// The files of the layers' crate.
fn layers() -> Vec<PathBuf> {
    rust_files("layers").into_iter().filter(|file| !is_test(file)).collect()
}

/// Whether the whole file is a test.
fn is_test(file: &Path) -> bool {
    file.ends_with("tests.rs") || file.starts_with(root().join("layers/tests"))
}

/// The module of a library file, the first name below the crate.
fn module(file: &Path) -> String {
    let inside = file.strip_prefix(root().join("src")).expect("a file of the library");
    let first = inside.components().next().expect("a file has a name");
    first.as_os_str().to_string_lossy().trim_end_matches(".rs").to_owned()
}

/// The text of a file up to its tests, comments blanked.
fn code(file: &Path) -> String {
    let text = read(file);
    let end = text.find("\n#[cfg(test)]").unwrap_or(text.len());
    let lines = text[..end].lines().map(|line| if line.trim_start().starts_with("//") { "" } else { line });
    lines.collect::<Vec<_>>().join("\n")
}

/// Names that the crate's root re-exports, with the module they come from.
fn exported() -> BTreeMap<String, String> {
    let mut exported = BTreeMap::new();
    for statement in code(&root().join("src/lib.rs")).split(';') {
        let Some((module, names)) = statement.trim().strip_prefix("pub use ").and_then(|path| path.split_once("::"))
        else {
            continue;
        };
        for name in names.split([',', '{', '}']).map(str::trim).filter(|name| !name.is_empty()) {
            exported.insert(name.to_owned(), module.to_owned());
        }
    }
    exported
}

/// The paths that begin with `crate::`. Of a nested list only the first names are returned.
fn paths(text: &str) -> Vec<String> {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let mut found = Vec::new();
    for (at, prefix) in text.match_indices("crate::") {
        if text[..at].ends_with(|c: char| is_name(c) || c == '$') {
            continue;
        }
        let rest = &text[at + prefix.len()..];
        let path = |text: &str| -> String {
            let end = text.find(|c: char| !is_name(c) && c != ':').unwrap_or(text.len());
            format!("crate::{}", text[..end].trim_end_matches(':'))
        };
        match rest.strip_prefix('{') {
            None => found.push(path(rest)),
            Some(list) => {
                let (mut depth, mut start) = (0, 0);
                for (i, c) in list.char_indices() {
                    match c {
                        '{' => depth += 1,
                        '}' if depth > 0 => depth -= 1,
                        ',' | '}' if depth == 0 => {
                            let item = list[start..i].trim();
                            if !item.is_empty() {
                                found.push(path(item));
                            }
                            start = i + 1;
                            if c == '}' {
                                break;
                            }
                        }
                        _ => {}
                    }
                }
            }
        }
    }
    found
}

#[track_caller]
fn none(wrong: &[String]) {
    let root = format!("{}/", root().display());
    let list: String = wrong.iter().map(|line| format!("\n  {}", line.replace(&root, ""))).collect();
    assert!(wrong.is_empty(), "{} in all:{list}", wrong.len());
}
