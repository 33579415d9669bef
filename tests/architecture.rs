//! The promises of docs/architecture.md: one direction of imports, layers that know no solver, files one can read.
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// A file longer than this holds more than one thing.
const LONGEST: usize = 450;

/// For each module of the library the modules that it may import, in the order in which data flow. Plain
/// values that everybody may name are not listed, see [`SHARED`].
const MAY_IMPORT: [(&str, &[&str]); 17] = [
    ("numeric", &[]),
    ("exact", &[]),
    ("files", &[]),
    ("options", &[]),
    ("solution", &[]),
    ("scene", &[]),
    ("stack", &["scene"]),
    ("system", &["stack"]),
    ("kernel", &["numeric", "stack", "system"]),
    ("contact", &["kernel", "numeric", "scene", "system"]),
    ("field", &["numeric", "stack", "system"]),
    // put together from the errors of the stages, for all that stands above them
    ("errors", &["contact", "field", "scene", "stack", "sweep", "system"]),
    ("model", &["contact", "errors", "field", "kernel", "scene", "stack"]),
    ("stress", &["contact", "errors", "field", "model", "numeric", "plot", "report", "scene", "stack", "system"]),
    ("sweep", &["errors", "model", "scene", "stack"]),
    ("plot", &["field", "files", "scene", "stack", "sweep"]),
    ("report", &["errors", "field", "scene", "sweep"]),
];

/// Leaves: what is asked for, and what comes out. Anything but `numeric` and `exact` may import them.
const SHARED: [&str; 2] = ["options", "solution"];

/// The one circle of files that is still to be undone.
const STILL: &str = "src: system::across -> system::evaluate";

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
                ("numeric" | "exact" | "options" | "solution", _) => false,
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
fn no_two_files_import_each_other_in_a_circle() {
    let crates = [("src", Files::of(library(), "src")), ("layers", Files::of(layers(), "layers"))];
    for (name, files) in crates {
        let circles = files.circles();
        let circles = circles.iter().map(|circle| format!("{name}: {}", circle.join(" -> ")));
        none(&circles.filter(|circle| circle != STILL).collect::<Vec<_>>());
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

/// The files of a crate as modules, with what each imports.
struct Files {
    /// The path of each module below the crate, and its text.
    texts: BTreeMap<Vec<String>, String>,
}

impl Files {
    fn of(files: Vec<PathBuf>, folder: &str) -> Self {
        let path = |file: &Path| {
            let inside = file.strip_prefix(root().join(folder)).expect("a file of the crate").with_extension("");
            let mut path: Vec<String> = inside.iter().map(|part| part.to_string_lossy().into_owned()).collect();
            let is_folder = path.last().is_some_and(|last| last == "mod" || last == "lib" && path.len() == 1);
            path.truncate(path.len() - usize::from(is_folder));
            path
        };
        Self { texts: files.iter().map(|file| (path(file), code(file))).collect() }
    }

    /// What a module imports: the modules in which the names are defined, re-exports followed.
    fn imports(&self, module: &[String]) -> Vec<Vec<String>> {
        let names = uses(&self.texts[module]).into_iter().filter_map(|(_, path)| absolute(module, &path));
        let mut found: Vec<_> =
            names.filter_map(|path| self.defined(&path, 0)).filter(|found| found != module).collect();
        found.sort();
        found.dedup();
        found
    }

    /// The module that defines what a path names.
    fn defined(&self, path: &[String], depth: usize) -> Option<Vec<String>> {
        let known = (0..=path.len()).rev().find(|length| self.texts.contains_key(&path[..*length]))?;
        let (module, rest) = path.split_at(known);
        let Some(name) = rest.first().filter(|_| depth < 8) else { return Some(module.to_vec()) };
        let exported =
            uses(&self.texts[module]).into_iter().find(|(is_public, path)| *is_public && path.last() == Some(name));
        match exported.and_then(|(_, path)| absolute(module, &path)) {
            Some(path) => self.defined(&path, depth + 1),
            None => Some(module.to_vec()),
        }
    }

    /// Each circle of imports once, a file and its own children aside.
    fn circles(&self) -> Vec<Vec<String>> {
        let related = |a: &[String], b: &[String]| a.starts_with(b) || b.starts_with(a);
        let arrows: BTreeMap<&[String], Vec<Vec<String>>> = self
            .texts
            .keys()
            .map(|module| (&module[..], self.imports(module).into_iter().filter(|to| !related(module, to)).collect()))
            .collect();
        let reached = |from: &[String]| {
            let (mut seen, mut left) = (Vec::<Vec<String>>::new(), arrows[from].clone());
            while let Some(module) = left.pop() {
                if !seen.contains(&module) {
                    left.extend(arrows[&module[..]].iter().cloned());
                    seen.push(module);
                }
            }
            seen
        };
        let all: BTreeMap<&[String], Vec<Vec<String>>> =
            arrows.keys().map(|module| (*module, reached(module))).collect();
        let mut circles: Vec<Vec<String>> = Vec::new();
        for (module, reached) in &all {
            let same = reached.iter().filter(|other| all[&other[..]].iter().any(|back| back == module));
            let mut circle: Vec<String> = same.map(|other| other.join("::")).collect();
            circle.sort();
            if !circle.is_empty() && !circles.contains(&circle) {
                circles.push(circle);
            }
        }
        circles
    }
}

/// A path from the crate on; `None` for other crates.
fn absolute(module: &[String], path: &[String]) -> Option<Vec<String>> {
    let mut base = match path.first()?.as_str() {
        "crate" => Vec::new(),
        "self" | "super" => module.to_vec(),
        _ => return None,
    };
    let mut rest = path;
    while let Some((first, others)) =
        rest.split_first().filter(|(first, _)| ["crate", "self", "super"].contains(&&first[..]))
    {
        if first == "super" {
            base.pop();
        }
        rest = others;
    }
    base.extend(rest.iter().cloned());
    Some(base)
}

/// Every path that a text imports or names from `crate`, `self` or `super` on, one by one, and whether it is re-exported.
/// A path that begins with the name of a child is one from `self` on.
fn uses(text: &str) -> Vec<(bool, Vec<String>)> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(at) = rest.find("use ") {
        let before = rest[..at].rsplit('\n').next().unwrap_or_default().trim();
        let end = rest[at..].find(';').map_or(rest.len(), |end| at + end);
        if before.is_empty() || before.starts_with("pub") {
            let is_public = before.starts_with("pub");
            let mut paths = Vec::new();
            expand(&rest[at + 4..end], &[], &mut paths);
            for path in paths {
                let is_child = is_public && !["crate", "self", "super"].contains(&&path[0][..]);
                let path = if is_child { [vec!["self".to_owned()], path].concat() } else { path };
                found.push((is_public, path));
            }
        }
        rest = &rest[end.max(at + 4)..];
    }
    for prefix in ["crate::", "super::"] {
        for (at, _) in text.match_indices(prefix) {
            let is_name = |c: char| c.is_alphanumeric() || c == '_';
            if text[..at].ends_with(|c: char| is_name(c) || c == '$' || c == ':') {
                continue;
            }
            let end = text[at..].find(|c: char| !is_name(c) && c != ':').map_or(text.len(), |end| at + end);
            let path = text[at..end].trim_end_matches(':').split("::").map(str::to_owned).collect();
            if !text[at..].contains(';') || !text[end..].starts_with('{') {
                found.push((false, path));
            }
        }
    }
    found
}

/// The paths of one tree of imports.
fn expand(tree: &str, before: &[String], paths: &mut Vec<Vec<String>>) {
    let tree = tree.trim();
    if let Some(list) = tree.strip_prefix('{').and_then(|list| list.strip_suffix('}')) {
        let (mut depth, mut start) = (0, 0);
        for (at, c) in list.char_indices().chain([(list.len(), ',')]) {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                ',' if depth == 0 => {
                    if !list[start..at].trim().is_empty() {
                        expand(&list[start..at], before, paths);
                    }
                    start = at + 1;
                }
                _ => {}
            }
        }
        return;
    }
    match tree.split_once("::") {
        Some((first, rest)) => expand(rest, &[before, &[first.trim().to_owned()]].concat(), paths),
        None => {
            let name = tree.split(" as ").next().unwrap_or(tree).trim().to_owned();
            let last = if name == "self" { Vec::new() } else { vec![name] };
            paths.push([before, &last].concat());
        }
    }
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

/// The paths that begin with `crate::`. Of a nested list only the first names are told.
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
