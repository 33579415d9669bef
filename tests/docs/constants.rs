//! The page on numerical constants lists every named constant of the contact solver, and no other.
use super::{files, read, root};

/// Each row of the page has the file, the name and the value of a constant.
#[test]
fn every_constant_of_the_contact_solver_is_on_its_page() {
    let folder = root().join("src/contact");
    let page = read(&root().join("docs/numerical_constants.md"));
    let listed: Vec<&str> = page.lines().filter(|line| line.starts_with("| `")).collect();
    let mut constants = 0;
    for file in files(&folder, "rs") {
        let text = read(&file);
        let name = file.strip_prefix(&folder).expect("below the folder").to_string_lossy().replace('\\', "/");
        let lines =
            text.lines().map(|line| line.trim().trim_start_matches("pub(crate) ").trim_start_matches("pub(super) "));
        let named = lines.filter_map(|line| line.strip_prefix("const ")).filter_map(|line| line.split_once(':'));
        for constant in named.filter(|constant| !constant.0.starts_with("fn ")) {
            let begin = format!("| `{name}` | `{}` | `", constant.0);
            let value = constant.1.split_once('=').map_or("", |(_, value)| value.trim().trim_end_matches(';'));
            let row = listed.iter().find(|row| row.starts_with(&begin));
            let row = row.unwrap_or_else(|| panic!("{name}: {} is not on the page", constant.0));
            assert!(row[begin.len()..].starts_with(value), "{name}: {} is {value}, the page says {row}", constant.0);
            constants += 1;
        }
    }
    assert_eq!(constants, listed.len(), "constants on the page that the solver does not have");
}
