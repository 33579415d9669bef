//! A file with all rows of a sweep, or of a part of it, made from files of lines: comma-separated values, or Parquet.
use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};

use recede::files;
use recede::report::SweepCsv;

use super::{Failure, outputs};

/// The kind of a file of rows, by its ending.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum RowsKind {
    Csv,
    Parquet,
}

impl RowsKind {
    /// The kind of a file with this name: comma-separated values unless it ends with `.parquet`, which not every program can write.
    pub(super) fn of(path: &Path) -> Result<Self, Failure> {
        outputs::fits(path, &["csv", "parquet"])?;
        if outputs::ending(path) != "parquet" {
            return Ok(Self::Csv);
        }
        if cfg!(feature = "parquet") {
            return Ok(Self::Parquet);
        }
        Err(Failure::usage(
            format!("{}: this program was built without Parquet", path.display()),
            "build it with `--features parquet`, name a file that ends with .csv, or use `to_parquet` of the Python package",
        ))
    }
}

/// Copies the lines of files whose lines were compared with the rows of the sweep to a file that appears when it is complete.
pub(super) fn write<'a>(
    path: &Path,
    csv: &SweepCsv,
    parts: impl IntoIterator<Item = &'a PathBuf>,
) -> Result<(), Failure> {
    let kind = RowsKind::of(path)?;
    let mut parts = parts.into_iter();
    let mut copy = |write: &mut dyn FnMut(&str) -> io::Result<()>| {
        parts.try_for_each(|part| {
            let mut lines = BufReader::new(File::open(part)?).lines().skip(1);
            lines.try_for_each(|line| write(&(line? + "\n")))
        })
    };
    let written = files::replace(path, |out| match kind {
        #[cfg(feature = "parquet")]
        RowsKind::Parquet => {
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
