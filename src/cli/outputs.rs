//! The files that a command writes: of which kind they are by their names, and that they are neither read by the same command
//! nor the same file twice. All of this is told before anything is computed.
use std::io::{self, Write};
use std::path::Path;

use recede::files;

use super::Failure;

/// Endings that promise a kind of file; any other may hold any text.
const ENDINGS: [&str; 7] = ["csv", "json", "ron", "parquet", "svg", "pdf", "png"];

/// Standard input and standard output by name.
const INPUT: &str = "/dev/stdin";
pub(super) const OUTPUT: &str = "/dev/stdout";

/// The ending of the name of a file, in small letters.
pub(super) fn ending(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().to_lowercase()
}

/// Refuses a name that promises another kind of file than these, the first of which is what is written.
pub(super) fn fits(path: &Path, own: &[&str]) -> Result<(), Failure> {
    let ending = ending(path);
    if own.contains(&&ending[..]) || !ENDINGS.contains(&&ending[..]) {
        return Ok(());
    }
    let endings = own.iter().map(|own| format!(".{own}")).collect::<Vec<_>>().join(" or ");
    Err(Failure::usage(
        format!("{}: what is written here is no .{ending} file", path.display()),
        format!("let the name end in {endings}"),
    ))
}

/// The kind of output: as it was asked for, as the name of the file ends, or else, to standard output, to a pipe and to a device,
/// as usual.
pub(super) fn kind<T: Copy + PartialEq>(
    path: Option<&Path>,
    asked: Option<T>,
    kinds: &[(&str, T)],
    usual: T,
    hint: &str,
) -> Result<T, Failure> {
    let Some(path) = path else { return Ok(asked.unwrap_or(usual)) };
    let found = kinds.iter().find(|(own, _)| ending(path) == *own).map(|(_, kind)| *kind);
    match (asked, found) {
        (Some(asked), _) => {
            let own: Vec<&str> = kinds.iter().filter(|(_, kind)| *kind == asked).map(|(own, _)| *own).collect();
            fits(path, &own).map(|()| asked)
        }
        (None, Some(found)) => Ok(found),
        (None, None) if files::is_stream(path) => Ok(usual),
        (None, None) => {
            let message = format!("{}: the name of the file does not say what to write", path.display());
            Err(Failure::usage(message, hint))
        }
    }
}

/// Writes to a file, which appears when it is complete, or without one to standard output.
pub(super) fn write(
    path: Option<&Path>,
    out: &mut dyn Write,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Failure> {
    match path {
        Some(path) => files::replace(path, |out| write(out)).map_err(|cause| Failure::file(path, cause)),
        None => Ok(write(out)?),
    }
}

/// Refuses to write a file that the command reads, the same file twice, and a file that cannot be there.
pub(super) fn check(read: &[&Path], written: &[&Path]) -> Result<(), Failure> {
    let other_name = "name another file";
    for (i, path) in written.iter().enumerate() {
        let name = path.display();
        if path.is_dir() {
            return Err(Failure::usage(format!("{name} is a folder"), "name a file in it"));
        }
        let folder = files::folder(path);
        if !folder.is_dir() {
            let message = format!("{name}: there is no folder {}", folder.display());
            return Err(Failure::usage(message, "make the folder first, or name another one"));
        }
        let read = read.iter().map(|read| if *read == Path::new("-") { Path::new(INPUT) } else { read });
        if let Some(read) = read.into_iter().find(|read| files::same(read, path)) {
            let same = if read == *path { String::new() } else { format!("; it is {}", read.display()) };
            return Err(Failure::usage(
                format!("{name} is what this command reads, and would be lost{same}"),
                other_name,
            ));
        }
        if let Some(other) = written[..i].iter().find(|other| files::same(other, path)) {
            return Err(Failure::usage(format!("{} and {name} are the same file", other.display()), other_name));
        }
    }
    Ok(())
}
