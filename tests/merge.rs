//! A sweep in parts: together they are the whole, byte for byte, and nothing else is put together.
use std::fs;
use std::path::{Path, PathBuf};

use proptest::prelude::*;
use recede::Part;

use crate::support::{Run, recede};

const SWEEP: [&str; 5] =
    ["examples/scenes/strip_fgm_half_plane.ron", "--vary", "punch.radius=[250,500]", "--vary", "force=0.001:0.004:5"];

fn file(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("merge");
    fs::create_dir_all(&folder).unwrap();
    folder.join(name)
}

fn run(command: &str, files: &[&Path], options: &[&str]) -> Run {
    let files: Vec<&str> = files.iter().map(|file| file.to_str().unwrap()).collect();
    recede(&[&[command], &SWEEP[..], &files[..], options].concat(), b"")
}

/// The file of a part, and what is in it.
fn part(name: &str, part: &str, options: &[&str]) -> (PathBuf, String) {
    let path = file(name);
    let run = run("sweep", &[], &[&["--part", part, "--out", path.to_str().unwrap()], options].concat());
    assert_eq!((run.status, &run.stdout[..]), (Some(0), ""), "{}", run.stderr);
    let text = fs::read_to_string(&path).unwrap();
    (path, text)
}

fn whole() -> String {
    let run = run("sweep", &[], &[]);
    assert_eq!((run.status, &run.stderr[..]), (Some(0), ""));
    run.stdout
}

#[track_caller]
fn refused(name: &str, parts: &[&Path], reason: &str) {
    let out = file(name);
    let _ = fs::remove_file(&out);
    let run = run("merge", parts, &["--out", out.to_str().unwrap()]);
    assert_eq!((run.status, &run.stdout[..]), (Some(2), ""), "{}", run.stderr);
    assert!(run.stderr.contains(reason), "{}", run.stderr);
    assert!(!out.exists());
}

proptest! {
    #[test]
    fn parts_are_all_rows_once(len in 0usize..2000, of in 1usize..300) {
        let parts: Vec<_> = (1..=of).map(|number| Part::new(number, of).unwrap().rows(len)).collect();
        prop_assert!(parts.iter().cloned().flatten().eq(0..len));
        let (least, most) = (parts.iter().map(ExactSizeIterator::len).min(), parts.iter().map(ExactSizeIterator::len).max());
        prop_assert!(most.unwrap() - least.unwrap() <= 1);
    }

    #[test]
    fn ends_of_parts_meet_at_any_size(len: usize, of in 1..=usize::MAX, at: usize) {
        let number = at % of + 1;
        let rows = Part::new(number, of).unwrap().rows(len);
        let next = if number < of { Part::new(number + 1, of).unwrap().rows(len).start } else { len };
        prop_assert_eq!(rows.end, next);
        prop_assert!(rows.len() == len / of || rows.len() == len.div_ceil(of));
    }
}

#[test]
fn parts_in_any_order_are_the_whole() {
    let whole = whole();
    for of in [1, 3, 4, 13] {
        let parts: Vec<PathBuf> =
            (1..=of).map(|number| part(&format!("{number}_of_{of}.csv"), &format!("{number}/{of}"), &[]).0).collect();
        let orders = [parts.iter().rev().collect::<Vec<_>>(), parts.iter().cycle().skip(of / 2).take(of).collect()];
        for order in orders {
            let out = file(&format!("merged_{of}.csv"));
            let order: Vec<&Path> = order.into_iter().map(PathBuf::as_path).collect();
            let run = run("merge", &order, &["--out", out.to_str().unwrap()]);
            assert_eq!((run.status, &run.stdout[..], &run.stderr[..]), (Some(0), "", ""));
            assert_eq!(fs::read_to_string(out).unwrap(), whole, "{of} parts");
        }
    }
}

#[test]
fn an_interrupted_part_is_continued_and_no_other() {
    let (path, text) = part("interrupted.csv", "2/3", &[]);
    assert_eq!(text.lines().count(), 4);
    for end in [0, 7, text.len() / 2, text.len() - 3, text.len()] {
        fs::write(&path, &text[..end]).unwrap();
        assert_eq!(part("interrupted.csv", "2/3", &["--resume"]).1, text, "cut after {end} bytes");
    }
    for other in ["1/3", "3/3", "2/4", "2/5"] {
        let run = run("sweep", &[], &["--resume", "--part", other, "--out", path.to_str().unwrap()]);
        assert_eq!(run.status, Some(2), "{other}: {}", run.stderr);
        assert!(run.stderr.contains("holds something else than rows of this sweep, or of this part of it"));
    }
    assert_eq!(fs::read_to_string(path).unwrap(), text);
}

#[test]
fn what_is_not_the_whole_is_refused() {
    let [first, second, third] =
        [1, 2, 3].map(|number| part(&format!("good_{number}.csv"), &format!("{number}/3"), &[]));
    let files = [&first.0, &second.0, &third.0].map(PathBuf::as_path);
    refused("missing.csv", &[files[0], files[2]], "missing: rows 4 to 6 of 10, between the rows of");
    refused("no_first.csv", &[files[1], files[2]], "missing: rows 1 to 3 of 10, before the rows of");
    refused("no_last.csv", &files[..2], "missing: rows 7 to 10 of 10, behind the rows of");
    refused("double.csv", &[files[0], files[1], files[1], files[2]], "rows 4 to 6 of 10: in");
    let with = |name: &str, text: &str| {
        fs::write(file(name), text).unwrap();
        file(name)
    };
    let cut = with("cut.csv", &second.1[..second.1.len() - 5]);
    refused("from_cut.csv", &[files[0], &cut, files[2]], "cut.csv: the last line is cut off");
    let short = with("short.csv", second.1.split_inclusive('\n').take(3).collect::<String>().as_str());
    refused("from_short.csv", &[files[0], &short, files[2]], "missing: row 6 of 10");
    let lines: Vec<&str> = second.1.split_inclusive('\n').collect();
    let holed = with("holed.csv", &[lines[0], lines[1], lines[3]].concat());
    refused("from_holed.csv", &[files[0], &holed, files[2]], "holed.csv, line 3: the row that belongs here is missing");
    let foreign = part("foreign.csv", "2/3", &["--tolerance", "1e-8"]).0;
    refused("from_foreign.csv", &[files[0], &foreign, files[2]], "foreign.csv is of another sweep: its lines end with");
    let columns = part("columns.csv", "2/3", &["--approach"]).0;
    refused(
        "from_columns.csv",
        &[files[0], &columns, files[2]],
        "columns.csv does not begin with the names of the columns",
    );
    let forgotten = recede(&["merge", "part_1.csv", "part_2.csv", "--out", "whole.csv"], b"");
    assert!(forgotten.stderr.contains("part_1.csv is no sweep") && forgotten.status == Some(2), "{}", forgotten.stderr);
}

#[test]
fn what_is_no_part_is_told() {
    for (part, reason) in [
        ("0/3", "found part 0 of 3, allowed are parts 1 to 3"),
        ("4/3", "found part 4 of 3, allowed are parts 1 to 3"),
        ("1/0", "found 0 parts, allowed are 1 or more"),
        ("-1/3", "K/N is expected, two whole numbers with 1 <= K <= N"),
        ("half", "K/N is expected, two whole numbers with 1 <= K <= N"),
    ] {
        let run = run("sweep", &[], &[&format!("--part={part}")]);
        assert!(run.status == Some(2) && run.stderr.contains(reason), "{part}: {}", run.stderr);
    }
    let run = run("sweep", &[], &["--part", "1/2", "--plot", "part.svg"]);
    assert_eq!(run.status, Some(2));
    assert!(run.stderr.contains("some of the rows as if they were all"), "{}", run.stderr);
}
