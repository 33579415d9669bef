//! The file of one part of a sweep.
use std::fs::File;
use std::ops::Range;
use std::path::{Path, PathBuf};

use recede::report::SweepCsv;

use super::Failure;
use super::rows_file::begun;

/// A file and the rows that it has.
pub(super) struct PartFile {
    pub(super) path: PathBuf,
    pub(super) rows: Range<usize>,
}

impl PartFile {
    /// Looks at all lines, each of which has to be the line of the row behind the last; `None` if there is nothing but a header.
    pub(super) fn open(path: &Path, csv: &SweepCsv) -> Result<Option<Self>, Failure> {
        let name = path.display();
        let file = File::open(path).map_err(|cause| Failure::file(path, cause))?;
        let rows = |first: &str| Ok(row(path, csv, first)?..csv.sweep().len());
        let begun = begun(path, &file, csv, rows, |_, _| ())?;
        match begun.wrong {
            Some(1) => Err(Failure::usage(
                format!("{name} does not begin with the names of the columns of this sweep"),
                "the sweep comes first, then the files of its parts; --vary, --approach and --extremes have to be those of the parts",
            )),
            _ if begun.is_cut || begun.bytes == 0 => Err(Failure::usage(
                format!("{name}: the last line is cut off"),
                "the command that made this part completes it if it is run again with --resume",
            )),
            Some(line) => Err(Failure::usage(
                format!("{name}, line {line}: the row that belongs here is missing, or was changed"),
                "remove the file, and compute this part again",
            )),
            None if begun.rows.is_empty() => Ok(None),
            None => Ok(Some(Self { path: path.to_owned(), rows: begun.rows })),
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
