//! The headings of the troubleshooting chapter are messages that the program prints.
use super::{files, read, root};

/// `...` in a heading stands for what varies, ` / ` separates messages. Each part between has to stand in the text of the program.
#[test]
fn headings_are_messages_of_the_program() {
    let program = program();
    let chapter = read(&root().join("docs/troubleshooting.md"));
    let messages = chapter.split("## Not messages").next().expect("messages");
    let headings: Vec<&str> = messages.lines().filter_map(|line| line.strip_prefix("### ")).collect();
    assert!(headings.len() > 30, "only {} headings found", headings.len());
    let parts = headings.iter().flat_map(|heading| heading.split(" / ")).flat_map(|message| message.split("..."));
    let unknown: Vec<&str> = parts.map(str::trim).filter(|part| !program.contains(part)).collect();
    assert!(unknown.is_empty(), "the program does not print {unknown:#?}");
}

/// The chapter says of each code of a warning what it means.
#[test]
fn codes_of_warnings_are_explained() {
    let chapter = read(&root().join("docs/troubleshooting.md"));
    let program = read(&root().join("src/solution/warning.rs"));
    let codes: Vec<&str> = program.lines().filter_map(|line| line.split_once("=> \"")?.1.strip_suffix("\",")).collect();
    assert!(codes.len() > 5, "only {codes:?} found");
    for code in codes {
        assert!(chapter.contains(&format!("`{code}`")), "nothing is said of {code}");
    }
}

/// The source text without comments, texts that go on in the next line in one piece.
fn program() -> String {
    let sources = ["src", "layers"].into_iter().flat_map(|folder| files(&root().join(folder), "rs"));
    let mut program = String::new();
    for line in sources.flat_map(|file| read(&file).lines().map(|line| line.trim().to_owned()).collect::<Vec<_>>()) {
        match line.strip_suffix('\\') {
            _ if line.starts_with("//") => {}
            Some(begun) => program += begun,
            None => program = program + &line + "\n",
        }
    }
    program
}
