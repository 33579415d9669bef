//! What the command was compiled from serves the Python package: crates are compiled once for both.
use std::collections::BTreeSet;
use std::process::Command;

/// The crates that are compiled for a package of the workspace, each with its version and its features.
fn crates(arguments: &[&str]) -> BTreeSet<String> {
    let tree =
        ["tree", "--locked", "--offline", "--edges=normal,build", "--prefix=none", "--no-dedupe", "--format={p} {f}"];
    let cargo = Command::new(env!("CARGO")).current_dir(env!("CARGO_MANIFEST_DIR")).args(tree).args(arguments).output();
    let output = cargo.expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect()
}

#[test]
fn the_python_package_is_built_from_the_crates_of_the_command() {
    let command = crates(&["--package=recede"]);
    let package = crates(&["--package=recede-python", "--features=command"]);
    assert!(command.len() > 100, "{} crates", command.len());
    let twice: Vec<_> = command.difference(&package).collect();
    assert!(twice.is_empty(), "compiled again for the Python package, with other features:\n{twice:#?}");
}

#[test]
fn the_python_package_alone_does_without_what_only_the_command_needs() {
    let package = crates(&["--package=recede-python"]);
    let needless: Vec<_> =
        package.iter().filter(|line| line.starts_with("clap") || line.starts_with("proptest")).collect();
    assert!(needless.is_empty(), "{needless:#?}");
}
