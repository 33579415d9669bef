//! Files of rows of a sweep: one that grows by whole lines, so that a sweep can be interrupted at any time, and one that is made of such files:
//! comma-separated values, or Parquet.
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::Path;

use recede::files;
use recede::report::SweepCsv;

use super::{Failure, outputs};

/// No line of a sweep has more bytes.
const LONGEST: u64 = 1 << 20;

/// Begins a file, or what is written in its place, with a header. Each line is handed over to it in one piece.
pub(super) fn create(path: &Path, csv: &SweepCsv) -> Result<Box<dyn Write>, Failure> {
    let failed = |cause| Failure::file(path, cause);
    let mut rows = match files::stream(path).map_err(failed)? {
        Some(stream) => stream as Box<dyn Write>,
        None => {
            let file = open(path)?;
            file.set_len(0).map_err(failed)?;
            Box::new(file)
        }
    };
    rows.write_all(csv.header()?.as_bytes()).map_err(failed)?;
    Ok(rows)
}

/// A file that was begun with the first of these rows, and how many it has, each of which is shown to `see` with its number; a new one
/// if there is none.
pub(super) fn resume(
    path: &Path,
    csv: &SweepCsv,
    rows: Range<usize>,
    see: impl FnMut(usize, &str),
) -> Result<(Box<dyn Write>, usize), Failure> {
    let failed = |cause| Failure::file(path, cause);
    if files::is_stream(path) {
        let message =
            format!("{} is no regular file: what was written to it is not there to go on with", path.display());
        return Err(Failure::usage(message, "leave out --resume, or name a file"));
    }
    let mut file = open(path)?;
    let begun = begun(path, &file, csv, |_| Ok(rows.clone()), see)?;
    let (name, of_other) = (path.display(), "holds something else than rows of this sweep, or of this part of it");
    if let Some(line) = begun.wrong {
        let (place, hint) = match line {
            1 => (String::new(), "without --resume it is begun anew, and what it holds is lost"),
            _ => {
                let hint = "if lines were damaged, remove this one and all below it: --resume computes them again";
                (format!(", line {line},"), hint)
            }
        };
        return Err(Failure::usage(format!("{name}{place} {of_other}"), hint));
    }
    // half a line, if there is one, is made again
    file.set_len(begun.bytes).and_then(|()| file.seek(SeekFrom::Start(begun.bytes))).map_err(failed)?;
    if begun.bytes == 0 {
        file.write_all(csv.header()?.as_bytes()).map_err(failed)?;
    }
    Ok((Box::new(file), begun.rows.len()))
}

/// Opens a file of lines, there or not, for one sweep at a time: lines of two would be mixed.
fn open(path: &Path) -> Result<File, Failure> {
    let file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path);
    let file = file.map_err(|cause| Failure::file(path, cause))?;
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => Err(Failure::usage(
            format!("{} is being written by another sweep", path.display()),
            "wait until that has ended, or name another file",
        )),
        // some file systems have no locks
        Ok(()) | Err(TryLockError::Error(_)) => Ok(file),
    }
}

/// The state of a file of lines, which may have been interrupted.
#[derive(Default)]
pub(super) struct Begun {
    /// The rows of the whole lines below the header.
    pub(super) rows: Range<usize>,
    /// Bytes of all whole lines, the header included.
    pub(super) bytes: u64,
    /// The first line, from 1, that is not the line of the row that is to stand there.
    pub(super) wrong: Option<usize>,
    /// Whether the last line has no end.
    pub(super) is_cut: bool,
}

/// Compares a file with the header and the lines of rows, and shows each of them to `see` with its number. Which rows may stand there
/// is told by `rows` of the first line below the header.
pub(super) fn begun(
    path: &Path,
    file: &File,
    csv: &SweepCsv,
    rows: impl Fn(&str) -> Result<Range<usize>, Failure>,
    mut see: impl FnMut(usize, &str),
) -> Result<Begun, Failure> {
    let header = csv.header()?;
    let mut reader = BufReader::new(file);
    let mut line = Vec::new();
    let mut begun = Begun::default();
    let mut allowed = 0..0;
    let mut read = |line: &mut Vec<u8>| {
        line.clear();
        reader.by_ref().take(LONGEST).read_until(b'\n', line).map_err(|cause| Failure::file(path, cause))
    };
    while read(&mut line)? > 0 {
        // what is no text is replaced, and then is no line of a sweep
        let text = String::from_utf8_lossy(&line);
        let is_header = begun.bytes == 0;
        let is_cut = !line.ends_with(b"\n");
        if !is_header && begun.rows.is_empty() {
            allowed = rows(&text)?;
            begun.rows = allowed.start..allowed.start;
        }
        let row = begun.rows.end;
        let expected = match (is_header, is_cut) {
            (true, true) => header.starts_with(&*text),
            (true, false) => text == header,
            // the beginning of a row of this sweep, and of no other text
            (false, true) => allowed.contains(&row) && csv.is_begun(&text, row),
            (false, false) => allowed.contains(&row) && csv.is_line_of(&text, row),
        };
        if !expected {
            begun.wrong = Some(if is_header { 1 } else { begun.rows.len() + 2 });
        }
        begun.is_cut = is_cut;
        if is_cut || !expected {
            break;
        }
        if !is_header {
            see(row, &text);
            begun.rows.end += 1;
        }
        begun.bytes += line.len() as u64;
    }
    Ok(begun)
}

/// Whether a file of rows with this name is a Parquet file, which not every program can write, rather than one of comma-separated values.
pub(super) fn is_parquet(path: &Path) -> Result<bool, Failure> {
    outputs::fits(path, &["csv", "parquet"])?;
    let is_parquet = outputs::ending(path) == "parquet";
    if is_parquet && !cfg!(feature = "parquet") {
        return Err(Failure::usage(
            format!("{}: this program was built without Parquet", path.display()),
            "build it with `--features parquet`, name a file that ends with .csv, or use `to_parquet` of the Python package",
        ));
    }
    Ok(is_parquet)
}

/// Copies the lines of files whose lines were compared with the rows of the sweep to a file that appears when it is complete.
pub(super) fn copy<'a>(path: &Path, csv: &SweepCsv, parts: impl IntoIterator<Item = &'a Path>) -> Result<(), Failure> {
    let is_parquet = is_parquet(path)?;
    let mut parts = parts.into_iter();
    let mut copy = |write: &mut dyn FnMut(&str) -> io::Result<()>| {
        parts.try_for_each(|part| {
            let mut lines = BufReader::new(File::open(part)?).lines().skip(1);
            lines.try_for_each(|line| write(&(line? + "\n")))
        })
    };
    let written = files::replace(path, |out| match is_parquet {
        #[cfg(feature = "parquet")]
        true => {
            let mut file = recede::report::SweepParquet::new(csv, out)?;
            copy(&mut |line| file.write(line))?;
            file.finish().map(drop)
        }
        _ => {
            out.write_all(csv.header()?.as_bytes())?;
            copy(&mut |line| out.write_all(line.as_bytes()))
        }
    });
    written.map_err(|cause| Failure::file(path, cause))
}
