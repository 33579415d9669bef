//! `recede merge`: the files of the parts of a sweep put together.
use std::fs::File;
use std::ops::Range;
use std::path::{Path, PathBuf};

use recede::report::SweepCsv;

use super::grid::GridArguments;
use super::rows_file;
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
        rows_file::is_parquet(&self.out)?;
        let sweep = self.grid.sweep()?;
        let read: Vec<&Path> =
            self.grid.files(&sweep).into_iter().chain(self.parts.iter().map(PathBuf::as_path)).collect();
        outputs::check(&read, &[&self.out])?;
        let csv = SweepCsv::new(&sweep);
        let mut parts: Vec<(&Path, Range<usize>)> = Vec::new();
        for path in &self.parts {
            parts.push((path, rows_of(path, &csv)?));
        }
        parts.retain(|(_, rows)| !rows.is_empty());
        parts.sort_by_key(|(_, rows)| rows.start);
        complete(&parts, sweep.len())?;
        rows_file::copy(&self.out, &csv, parts.iter().map(|(path, _)| *path))
    }
}

/// The rows of a part, each line of which has to be the line of the row behind the last; none if there is nothing but a header.
fn rows_of(path: &Path, csv: &SweepCsv) -> Result<Range<usize>, Failure> {
    let name = path.display();
    let file = File::open(path).map_err(|cause| Failure::file(path, cause))?;
    let rows = |first: &str| Ok(row(path, csv, first)?..csv.sweep().len());
    let begun = rows_file::begun(path, &file, csv, rows, |_, _| ())?;
    match begun.wrong {
        Some(1) => Err(Failure::usage(
            format!("{name} does not begin with the names of the columns of this sweep"),
            "the sweep comes first, then the files of its parts; --vary, --approach and --extremes have to be the same as for the parts",
        )),
        _ if begun.is_cut || begun.bytes == 0 => Err(Failure::usage(
            format!("{name}: the last line is cut off"),
            "the command that made this part completes it if it is run again with --resume",
        )),
        Some(line) => Err(Failure::usage(
            format!("{name}, line {line}: the row that belongs here is missing, or was changed"),
            "remove the file, and compute this part again",
        )),
        None => Ok(begun.rows),
    }
}

/// The number of the row of the first line of a part.
fn row(path: &Path, csv: &SweepCsv, line: &str) -> Result<usize, Failure> {
    let name = path.display();
    let (found, own) = (line.trim_end().rsplit(',').next().unwrap_or_default(), csv.fingerprint());
    let is_fingerprint = found.len() == own.len() && found.bytes().all(|byte| byte.is_ascii_hexdigit());
    if is_fingerprint && found != own {
        return Err(Failure::usage(
            format!("{name} is of another sweep: its lines end with `{found}`, the lines of this sweep with `{own}`"),
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

/// Whether these parts, in the order of their first rows, have each row once.
fn complete(parts: &[(&Path, Range<usize>)], count: usize) -> Result<(), Failure> {
    let mut missing = Vec::new();
    for k in 0..=parts.len() {
        let (before, after) = (k.checked_sub(1).map(|k| &parts[k]), parts.get(k));
        let end = before.map_or(0, |(_, rows)| rows.end);
        let next = after.map_or(count, |(_, rows)| rows.start);
        let [before, here] = [before, after].map(|part| part.map(|(path, _)| path.display()));
        let place = match (before, here) {
            (Some(before), Some(here)) if next < end => {
                let both = named(next, end.min(after.map_or(count, |(_, rows)| rows.end)), count);
                return Err(Failure::usage(
                    format!("{both}: in {before} and in {here}"),
                    "name each part once, and parts of one division of the sweep only",
                ));
            }
            (Some(before), Some(here)) => format!(", between the rows of {before} and {here}"),
            (None, Some(here)) => format!(", before the rows of {here}"),
            (Some(before), None) => format!(", behind the rows of {before}"),
            (None, None) => String::new(),
        };
        if end < next {
            missing.push(named(end, next, count) + &place);
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
