//! Publications cited in documents and code are those of `docs/references.md`.
use super::{documents, files, read, root};

/// A name and a year, as in `Steuermann 1939`, stand for a publication that `docs/references.md` has.
#[test]
fn publications_that_are_cited_are_listed() {
    let list = read(&root().join("docs/references.md"));
    let listed: Vec<&str> =
        list.lines().filter_map(|line| line.strip_prefix("| ")?.split(" |").next()).filter_map(last_two).collect();
    let sources =
        ["src", "layers", "tests", "examples"].into_iter().flat_map(|folder| files(&root().join(folder), "rs"));
    let mut cited = Vec::new();
    for file in documents().into_iter().chain(sources).filter(|file| !file.ends_with("docs/references.md")) {
        for citation in citations(&read(&file)) {
            assert!(listed.contains(&&citation[..]), "{}: {citation}", file.display());
            cited.push(citation);
        }
    }
    for name in listed {
        assert!(cited.iter().any(|citation| citation == name), "nobody cites {name}");
    }
}

/// The last two words of a citation, the last author and the year.
fn last_two(citation: &str) -> Option<&str> {
    let (before, year) = citation.rsplit_once(' ')?;
    year.parse::<u32>().ok()?;
    Some(&citation[before.rfind(' ').map_or(0, |at| at + 1)..])
}

/// Capitalised words before a year between 1800 and 2099.
fn citations(text: &str) -> Vec<String> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let pairs = words.windows(2).filter_map(|pair| {
        let name = pair[0].trim_start_matches(['(', '[', '|', '*']);
        let end = pair[1].find(|c: char| !c.is_ascii_digit()).unwrap_or(pair[1].len());
        let (year, rest) = pair[1].split_at(end);
        let is_name = name.starts_with(char::is_uppercase)
            && name.chars().all(char::is_alphabetic)
            && name.chars().any(char::is_lowercase);
        let is_year = year.len() == 4 && ["18", "19", "20"].iter().any(|century| year.starts_with(century));
        let ends = rest.is_empty() || rest.starts_with([',', ';', ')', '.', ':']) && !rest.starts_with(".0");
        (is_name && is_year && ends).then(|| format!("{name} {year}"))
    });
    pairs.collect()
}

#[test]
fn citations_are_found() {
    assert_eq!(
        citations("(Fritsch and Carlson 1980). See Steuermann 1939; not MAX 2000 or Units 2000.0"),
        ["Carlson 1980", "Steuermann 1939"]
    );
}
