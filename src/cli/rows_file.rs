//! A file of rows that grows by whole lines, so that a sweep can be interrupted at any time.
use std::fs::{File, OpenOptions};
use std::io::{self, BufRead, BufReader, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::Path;

use recede::report::SweepCsv;

use super::Failure;

/// Where rows go.
pub(super) enum RowsFile<'a> {
    /// A file of its own, to which each line is handed over in one piece.
    File(File),
    /// Standard output.
    Stream(&'a mut dyn Write),
}

impl RowsFile<'_> {
    /// A new file, with a header.
    pub(super) fn create(path: &Path, csv: &SweepCsv) -> Result<Self, Failure> {
        let mut file = File::create(path).map_err(|cause| Failure::file(path, cause))?;
        file.write_all(csv.header()?.as_bytes()).map_err(|cause| Failure::file(path, cause))?;
        Ok(Self::File(file))
    }

    /// A file that was begun with the first of these rows, and how many it has, each of which is shown to `see` with its number; a new one
    /// if there is none.
    pub(super) fn resume(
        path: &Path,
        csv: &SweepCsv,
        rows: Range<usize>,
        see: impl FnMut(usize, &str),
    ) -> Result<(Self, usize), Failure> {
        let mut file = match OpenOptions::new().read(true).write(true).open(path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok((Self::create(path, csv)?, 0)),
            other => other.map_err(|cause| Failure::file(path, cause))?,
        };
        let Begun { lines, bytes } = begun(&file, csv, &rows, see).map_err(|cause| Failure::file(path, cause))?;
        let Some(done) = lines else {
            return Err(Failure::usage(
                format!("{} holds something else than rows of this sweep, or of this part of it", path.display()),
                "without --resume it is begun anew, and what it holds is lost",
            ));
        };
        if bytes == 0 {
            return Ok((Self::create(path, csv)?, 0));
        }
        // half a line, if there is one, is made again
        let ready = file.set_len(bytes).and_then(|()| file.seek(SeekFrom::Start(bytes)));
        ready.map_err(|cause| Failure::file(path, cause))?;
        Ok((Self::File(file), done))
    }

    /// Adds a line.
    pub(super) fn write(&mut self, line: &str) -> io::Result<()> {
        match self {
            Self::File(file) => file.write_all(line.as_bytes()),
            Self::Stream(out) => out.write_all(line.as_bytes()),
        }
    }
}

/// What an interrupted sweep has left.
struct Begun {
    /// Whole lines below the header; `None` if some line is not that of the row that is to stand there.
    lines: Option<usize>,
    /// Bytes of all whole lines.
    bytes: u64,
}

fn begun(file: &File, csv: &SweepCsv, rows: &Range<usize>, mut see: impl FnMut(usize, &str)) -> io::Result<Begun> {
    let header = csv.header()?;
    let mut reader = BufReader::new(file);
    let mut line = Vec::new();
    let mut begun = Begun { lines: Some(0), bytes: 0 };
    while reader.read_until(b'\n', &mut line)? > 0 {
        if line.last() != Some(&b'\n') {
            // a header that was cut is no header of another sweep
            begun.lines = begun.lines.filter(|_| begun.bytes > 0 || header.as_bytes().starts_with(&line));
            break;
        }
        let row = rows.start + begun.lines.unwrap_or(0);
        let text = String::from_utf8_lossy(&line);
        let expected =
            if begun.bytes == 0 { text == header } else { rows.contains(&row) && csv.is_line_of(&text, row) };
        if !expected {
            begun.lines = None;
            break;
        }
        if begun.bytes > 0 {
            see(row, &text);
            begun.lines = begun.lines.map(|lines| lines + 1);
        }
        begun.bytes += line.len() as u64;
        line.clear();
    }
    Ok(begun)
}
