//! The file of one part of a sweep.
use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::ops::Range;
use std::path::{Path, PathBuf};

use recede::report::SweepCsv;

use super::Failure;
use super::rows_file::begun;

/// No line of a sweep has more bytes.
const LONGEST: u64 = 1 << 20;

/// A file and the rows that it has.
pub(super) struct PartFile {
    pub(super) path: PathBuf,
    pub(super) rows: Range<usize>,
}

impl PartFile {
    /// Looks at all lines, each of which has to be the line of the row behind the last; `None` if there is nothing but a header.
    pub(super) fn open(path: &Path, csv: &SweepCsv) -> Result<Option<Self>, Failure> {
        let failed = |cause| Failure::file(path, cause);
        let mut reader = BufReader::new(File::open(path).map_err(failed)?);
        let mut line = || -> Result<String, Failure> {
            let mut line = Vec::new();
            reader.by_ref().take(LONGEST).read_until(b'\n', &mut line).map_err(failed)?;
            // what is no text is replaced, and then is no line of a sweep
            Ok(String::from_utf8_lossy(&line).into_owned())
        };
        let (header, found, first) = (csv.header()?, line()?, line()?);
        if header != found {
            return Err(if header.starts_with(&found) { cut_off(path) } else { other_columns(path) });
        }
        if first.is_empty() {
            return Ok(None);
        }
        let start = row(path, csv, &first)?;
        let begun =
            begun(&File::open(path).map_err(failed)?, csv, &(start..csv.sweep().len()), |_, _| ()).map_err(failed)?;
        match begun.wrong {
            _ if begun.is_cut => Err(cut_off(path)),
            Some(line) => Err(Failure::usage(
                format!("{}, line {line}: the row that belongs here is missing, or was changed", path.display()),
                "remove the file, and compute this part again",
            )),
            None => Ok(Some(Self { path: path.to_owned(), rows: start..start + begun.rows })),
        }
    }
}

/// The number of the row of the first line.
fn row(path: &Path, csv: &SweepCsv, line: &str) -> Result<usize, Failure> {
    let name = path.display();
    let found = line.trim_end().rsplit(',').next().unwrap_or_default();
    let is_fingerprint = found.len() == csv.fingerprint().len() && found.bytes().all(|byte| byte.is_ascii_hexdigit());
    if is_fingerprint && found != csv.fingerprint() {
        return Err(Failure::usage(
            format!(
                "{name} is of another sweep: its lines end with `{found}`, those of this sweep with `{}`",
                csv.fingerprint()
            ),
            "scene, --vary, --approach, --extremes, --tolerance and the version of recede have to be those with which the parts were computed",
        ));
    }
    let start: String = line.trim_end().chars().take(60).collect();
    let row = csv.row_of(line).filter(|row| csv.is_line_of(line, *row));
    row.ok_or_else(|| {
        Failure::usage(
            format!("{name}, line 2: it cannot be told which row of the sweep this is, `{start}`"),
            "where an axis has a value twice, rows cannot be told apart; otherwise the file was changed: compute this part again",
        )
    })
}

fn cut_off(path: &Path) -> Failure {
    Failure::usage(
        format!("{}: the last line is cut off", path.display()),
        "the command that made this part completes it if it is run again with --resume",
    )
}

fn other_columns(path: &Path) -> Failure {
    Failure::usage(
        format!("{} does not begin with the names of the columns of this sweep", path.display()),
        "the sweep comes first, then the files of its parts; --vary, --approach and --extremes have to be those of the parts",
    )
}
