//! Runs the command `recede` as a user does.
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// How a run of the command ended.
pub struct Run {
    /// Exit status.
    pub status: Option<i32>,
    /// What it wrote to standard output.
    pub stdout: String,
    /// What it wrote to standard error.
    pub stderr: String,
}

/// Runs `recede` in the folder of the package with these arguments and this standard input.
pub fn recede(arguments: &[&str], stdin: &[u8]) -> Run {
    recede_in(Path::new(env!("CARGO_MANIFEST_DIR")), arguments, stdin)
}

/// The same in another folder.
pub fn recede_in(folder: &Path, arguments: &[&str], stdin: &[u8]) -> Run {
    let mut child = Command::new(env!("CARGO_BIN_EXE_recede"))
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // it may end without reading everything
    let _ = child.stdin.take().unwrap().write_all(stdin);
    let output = child.wait_with_output().unwrap();
    Run {
        status: output.status.code(),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}

/// All that is written in a picture.
pub fn texts(svg: &[u8]) -> String {
    let svg = String::from_utf8(svg.to_vec()).unwrap();
    let texts = svg.split("aria-label=\"").skip(1).filter_map(|part| part.split_once('"'));
    texts.map(|(text, _)| text).collect::<Vec<_>>().join("|")
}

/// The intervals of a contact for x ≥ 0, outwards; the first is that about x = 0 unless the bodies are apart there.
pub fn outwards(contact: &recede::Contact) -> Vec<recede::Interval> {
    contact.intervals().iter().copied().filter(|interval| interval.right >= 0.0).collect()
}

/// Where the innermost of them ends, and the error of that.
pub fn innermost_end(contact: &recede::Contact) -> (f64, f64) {
    let innermost = outwards(contact)[0];
    (innermost.right, innermost.right_error)
}

/// Loads at distances from x = 0 with their mirror images there, each with its share of a force: a share is of both images together.
pub fn mirrored(loads: &[(f64, f64, recede::Load)]) -> Result<recede::Loads, recede::ValueError> {
    let images = |(at, share, load): &(f64, f64, recede::Load)| {
        let sides = if *at > 0.0 { vec![-1.0, 1.0] } else { vec![1.0] };
        let force = share / sides.len() as f64;
        sides.into_iter().map(|side| (load.clone(), side * at, force)).collect::<Vec<_>>()
    };
    recede::Loads::new(&loads.iter().flat_map(images).collect::<Vec<_>>())
}
