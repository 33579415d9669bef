//! Sweeps as Parquet files: the values of the comma-separated ones, and what they are of.
use std::fs::{self, File};
use std::path::{Path, PathBuf};

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;

use crate::support::recede;

const SWEEP: [&str; 7] = [
    "examples/scenes/strip_fgm_half_plane.ron",
    "--vary",
    "punch.radius=[250,500,250]",
    "--vary",
    "force=[0.001,0.002,1e9]",
    "--tolerance",
    "1e-8",
];

fn file(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("parquet");
    fs::create_dir_all(&folder).unwrap();
    folder.join(name)
}

fn run(command: &str, files: &[&Path], out: &Path, options: &[&str]) {
    let files: Vec<&str> = files.iter().map(|file| file.to_str().unwrap()).collect();
    let out = ["--out", out.to_str().unwrap()];
    let run = recede(&[&[command], &SWEEP[..], &files[..], &out, options].concat(), b"");
    assert_eq!((run.status, &run.stdout[..]), (Some(0), ""), "{}", run.stderr);
}

/// The fields of all rows as comma-separated values write them, with names of columns first.
fn read(path: &Path) -> Vec<Vec<String>> {
    let reader = SerializedFileReader::new(File::open(path).unwrap()).unwrap();
    let columns = reader.metadata().file_metadata().schema_descr().columns().to_vec();
    let names = columns.iter().map(|column| column.name().to_owned()).collect();
    let field = |field: &Field| match field {
        Field::Double(value) if value.is_nan() => String::new(),
        Field::Double(value) => format!("{value:?}"),
        Field::Str(text) => text.clone(),
        other => panic!("{other:?}"),
    };
    let rows = reader.get_row_iter(None).unwrap();
    let rows = rows.map(|row| row.unwrap().get_column_iter().map(|(_, value)| field(value)).collect());
    [names].into_iter().chain(rows).collect()
}

fn read_csv(path: &Path) -> Vec<Vec<String>> {
    let text = fs::read_to_string(path).unwrap();
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
    reader.records().map(|record| record.unwrap().iter().map(str::to_owned).collect()).collect()
}

#[test]
fn values_are_those_of_lines_bit_by_bit() {
    let [lines, whole, part] = ["whole.csv", "whole.parquet", "part.parquet"].map(file);
    run("sweep", &[], &lines, &[]);
    run("sweep", &[], &whole, &[]);
    run("sweep", &[], &part, &["--part", "2/3"]);
    let expected = read_csv(&lines);
    assert_eq!(expected.len(), 10);
    assert_eq!(read(&whole), expected);
    assert_eq!(read(&part), [&expected[..1], &expected[4..7]].concat());
    assert!(!file("whole.parquet.csv").exists());
}

#[test]
fn metadata_name_scene_version_and_tolerance() {
    let path = file("metadata.parquet");
    run("sweep", &[], &path, &[]);
    let reader = SerializedFileReader::new(File::open(path).unwrap()).unwrap();
    let of = |key: &str| {
        let all = reader.metadata().file_metadata().key_value_metadata().unwrap();
        all.iter().find(|pair| pair.key == key).and_then(|pair| pair.value.clone()).unwrap()
    };
    let scene = recede::Scene::read(SWEEP[0]).unwrap();
    assert_eq!(of("scene"), scene.to_ron());
    assert_eq!((&of("version")[..], &of("tolerance")[..]), (env!("CARGO_PKG_VERSION"), "1e-8"));
}

#[test]
fn an_interrupted_sweep_is_resumed_from_its_lines() {
    let [path, lines, whole] = ["resumed.parquet", "resumed.parquet.csv", "uninterrupted.csv"].map(file);
    run("sweep", &[], &whole, &[]);
    let text = fs::read_to_string(&whole).unwrap();
    fs::write(&lines, &text[..2 * text.len() / 3]).unwrap();
    run("sweep", &[], &path, &["--resume"]);
    assert_eq!(read(&path), read_csv(&whole));
}

#[test]
fn parts_are_merged_to_one() {
    let vary = ["sweep", SWEEP[0], "--vary", "force=0.001:0.004:5"];
    let [first, second, merged, whole] = ["first.csv", "second.csv", "merged.parquet", "merged.csv"].map(file);
    let texts = [&first, &second, &merged, &whole].map(|path| path.to_str().unwrap());
    for options in
        [&["--part", "1/2", "--out", texts[0]][..], &["--part", "2/2", "--out", texts[1]], &["--out", texts[3]]]
    {
        assert_eq!(recede(&[&vary, options].concat(), b"").status, Some(0));
    }
    let merge = [&["merge"], &vary[1..], &[texts[1], texts[0], "--out", texts[2]]].concat();
    assert_eq!(recede(&merge, b"").status, Some(0));
    assert_eq!(read(&merged), read_csv(&whole));
}
