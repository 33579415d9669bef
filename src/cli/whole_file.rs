//! A file with all rows of a sweep, or of a part of it, made from files of lines: comma-separated values, or Parquet.
use std::io;
use std::path::Path;

use recede::files;
use recede::report::SweepCsv;

use super::part_file::PartFile;
use super::{Failure, outputs};

/// What a file of rows holds, by its ending.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum RowsKind {
    Csv,
    Parquet,
}

impl RowsKind {
    /// Of a file with this name; comma-separated values unless it ends with `.parquet`, which not every program can write.
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

/// Copies the lines of all parts to a file that appears when it is complete.
pub(super) fn write(path: &Path, csv: &SweepCsv, parts: &[PartFile]) -> Result<(), Failure> {
    let kind = RowsKind::of(path)?;
    let mut wrong = None;
    let mut copy = |write: &mut dyn FnMut(&str) -> io::Result<()>| {
        for part in parts {
            match part.copy(csv, write) {
                Err(Failure::Output(cause)) => return Err(cause),
                Err(failure) => {
                    wrong = Some(failure);
                    return Err(io::ErrorKind::InvalidData.into());
                }
                Ok(()) => {}
            }
        }
        Ok(())
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
    // a part that is wrong says more than that the file was given up
    wrong.map_or_else(|| written.map_err(|cause| Failure::file(path, cause)), Err)
}
