//! The file of one part of a sweep, read line by line.
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::{Path, PathBuf};

use recede::report::SweepCsv;

use super::Failure;

/// No line of a sweep has more bytes.
const LONGEST: u64 = 1 << 20;

/// A file and the rows that it has by its first and its last line.
pub(super) struct PartFile {
    pub(super) path: PathBuf,
    pub(super) rows: Range<usize>,
}

impl PartFile {
    /// Looks at header, first and last line; `None` if there is nothing but a header.
    pub(super) fn open(path: &Path, csv: &SweepCsv) -> Result<Option<Self>, Failure> {
        let failed = |cause| Failure::file(path, cause);
        let mut reader = BufReader::new(File::open(path).map_err(failed)?);
        let header = csv.header()?;
        let found = read_line(&mut reader).map_err(failed)?;
        if header != found {
            return Err(if header.starts_with(&found) { cut_off(path) } else { other_columns(path) });
        }
        let first = read_line(&mut reader).map_err(failed)?;
        if first.is_empty() {
            return Ok(None);
        }
        let last = last_line(reader.get_mut()).map_err(failed)?;
        if !last.ends_with('\n') {
            return Err(cut_off(path));
        }
        let [first, last] = [row(path, "line 2", csv, &first)?, row(path, "the last line", csv, &last)?];
        Ok(Some(Self { path: path.to_owned(), rows: first..last + 1 }))
    }

    /// Hands on the lines, each of which has to be that of its row.
    pub(super) fn copy(&self, csv: &SweepCsv, write: &mut dyn FnMut(&str) -> io::Result<()>) -> Result<(), Failure> {
        let failed = |cause| Failure::file(&self.path, cause);
        let mut reader = BufReader::new(File::open(&self.path).map_err(failed)?);
        read_line(&mut reader).map_err(failed)?;
        for (index, row) in self.rows.clone().enumerate() {
            let line = read_line(&mut reader).map_err(failed)?;
            if !csv.is_line_of(&line, row) {
                return Err(self.disordered(index + 2));
            }
            write(&line)?;
        }
        if reader.fill_buf().map_err(failed)?.is_empty() { Ok(()) } else { Err(self.disordered(self.rows.len() + 2)) }
    }

    fn disordered(&self, line: usize) -> Failure {
        Failure::usage(
            format!("{}, line {line}: the row that belongs here is missing, or was changed", self.path.display()),
            "remove the file, and compute this part again",
        )
    }
}

/// The number of the row of a line, which is called so.
fn row(path: &Path, which: &str, csv: &SweepCsv, line: &str) -> Result<usize, Failure> {
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
    let row = csv.row_of(line).filter(|row| csv.is_line_of(line, *row));
    row.ok_or_else(|| {
        Failure::usage(
            format!("{name}, {which}: it cannot be told which row of the sweep this is, `{}`", start(line)),
            "where an axis has a value twice, rows cannot be told apart; otherwise the file was changed: compute this part again",
        )
    })
}

/// The beginning of a line, to be shown.
fn start(line: &str) -> String {
    line.trim_end().chars().take(60).collect()
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

/// The next line with its end; what is no text is replaced, and then is no line of a sweep.
fn read_line(reader: &mut impl BufRead) -> io::Result<String> {
    let mut line = Vec::new();
    reader.take(LONGEST).read_until(b'\n', &mut line)?;
    Ok(String::from_utf8_lossy(&line).into_owned())
}

/// The last line of a file that has several, found from its end.
fn last_line(file: &mut File) -> io::Result<String> {
    let bytes = file.metadata()?.len();
    file.seek(SeekFrom::Start(bytes.saturating_sub(LONGEST)))?;
    let mut end = Vec::new();
    file.take(LONGEST).read_to_end(&mut end)?;
    let inner = &end[..end.len().saturating_sub(1)];
    let begin = inner.iter().rposition(|byte| *byte == b'\n').map_or(0, |at| at + 1);
    Ok(String::from_utf8_lossy(&end[begin..]).into_owned())
}
