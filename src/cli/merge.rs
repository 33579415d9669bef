//! `recede merge`: the files of the parts of a sweep put together.
use std::path::{Path, PathBuf};

use recede::report::SweepCsv;

use super::grid::GridArguments;
use super::part_file::PartFile;
use super::rows_file::{self, RowsKind};
use super::{Failure, outputs};

/// Gaps that are listed; the gaps of many lost parts would fill the screen.
const LISTED: usize = 5;

/// Put the files of all parts of a sweep together, in the order of rows
#[derive(Debug, clap::Args)]
#[command(after_help = "\
The sweep is named as for `recede sweep`: that tells the place of each line, and whether all are there. The files may be in any \
order, and the result is the file that the sweep would have written in one go.

Examples:
  recede sweep sweep.ron --part 1/2 --out part_1.csv
  recede sweep sweep.ron --part 2/2 --out part_2.csv
  recede merge sweep.ron part_1.csv part_2.csv --out all.csv
  recede merge scene.ron --vary force=0.001:0.004:4000 part_*.csv --out all.csv

Exit status: 0 all rows are in the file, 2 bad input, and nothing is written.")]
pub struct MergeArguments {
    #[command(flatten)]
    grid: GridArguments,
    /// Files of the parts, in any order
    #[arg(value_name = "PART.csv", required = true)]
    parts: Vec<PathBuf>,
    /// Write the rows of all parts to this file
    #[arg(long, value_name = "FILE.csv|parquet")]
    out: PathBuf,
}

impl MergeArguments {
    pub fn run(&self) -> Result<(), Failure> {
        if self.grid.file.extension().is_some_and(|ending| ending == "csv") {
            return Err(Failure::usage(
                format!("{} is no sweep", self.grid.file.display()),
                "the sweep comes first, as for `recede sweep`, then the files of its parts",
            ));
        }
        RowsKind::of(&self.out)?;
        let sweep = self.grid.sweep()?;
        let read: Vec<&Path> =
            self.grid.files(&sweep).into_iter().chain(self.parts.iter().map(PathBuf::as_path)).collect();
        outputs::check(&read, &[&self.out])?;
        let csv = SweepCsv::new(&sweep);
        let mut parts = Vec::new();
        for path in &self.parts {
            parts.extend(PartFile::open(path, &csv)?);
        }
        parts.sort_by_key(|part| part.rows.start);
        complete(&parts, sweep.len())?;
        rows_file::copy(&self.out, &csv, parts.iter().map(|part| &part.path))
    }
}

/// Whether these parts, in the order of their first rows, have each row once.
fn complete(parts: &[PartFile], rows: usize) -> Result<(), Failure> {
    let mut missing = Vec::new();
    for k in 0..=parts.len() {
        let (before, after) = (k.checked_sub(1).map(|k| &parts[k]), parts.get(k));
        let end = before.map_or(0, |part| part.rows.end);
        let next = after.map_or(rows, |part| part.rows.start);
        let [before, here] = [before, after].map(|part| part.map(|part| part.path.display()));
        let place = match (before, here) {
            (Some(before), Some(here)) if next < end => {
                let both = named(next, end.min(after.map_or(rows, |part| part.rows.end)), rows);
                return Err(Failure::usage(
                    format!("{both}: in {before} and in {here}"),
                    "name each part once, and parts of one division of the sweep only",
                ));
            }
            (Some(before), Some(here)) => format!(", between those of {before} and {here}"),
            (None, Some(here)) => format!(", before those of {here}"),
            (Some(before), None) => format!(", behind those of {before}"),
            (None, None) => String::new(),
        };
        if end < next {
            missing.push(named(end, next, rows) + &place);
        }
    }
    if missing.is_empty() {
        return Ok(());
    }
    let more = missing.len().saturating_sub(LISTED);
    missing.truncate(LISTED);
    let more = if more > 0 { format!("; and {more} more gaps") } else { String::new() };
    Err(Failure::usage(
        format!("missing: {}{more}", missing.join("; ")),
        "name the files of all parts; the command of a part that was interrupted completes it with --resume",
    ))
}

/// Rows counted from 1, as a user does.
fn named(first: usize, end: usize, rows: usize) -> String {
    match end - first {
        1 => format!("row {end} of {rows}"),
        _ => format!("rows {} to {end} of {rows}", first + 1),
    }
}
