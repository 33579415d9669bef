//! Which modules of a crate import which, read from their texts.
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The files of a crate as modules, with what each imports.
pub struct Files {
    /// The path of each module below the crate, and its text.
    pub texts: BTreeMap<Vec<String>, String>,
}

impl Files {
    /// The files of a folder with their texts.
    pub fn of(files: Vec<(PathBuf, String)>, folder: &Path) -> Self {
        let path = |file: &Path| {
            let inside = file.strip_prefix(folder).expect("a file of the crate").with_extension("");
            let mut path: Vec<String> = inside.iter().map(|part| part.to_string_lossy().into_owned()).collect();
            let is_folder = path.last().is_some_and(|last| last == "mod" || last == "lib" && path.len() == 1);
            path.truncate(path.len() - usize::from(is_folder));
            path
        };
        Self { texts: files.into_iter().map(|(file, text)| (path(&file), text)).collect() }
    }

    /// What a module imports: the modules in which the names are defined, re-exports followed.
    pub fn imports(&self, module: &[String]) -> Vec<Vec<String>> {
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
    pub fn circles(&self) -> Vec<Vec<String>> {
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
