//! Where commands write: one rule for all of them.
//!
//! ```text
//!   regular file      replaced when complete, with the permissions that it had; links to it stay links
//!   pipe, device      written through, and still there
//!   input, other out  refused before anything is computed
//! ```
use std::fs::{self, File, OpenOptions};
use std::io::{BufRead, BufReader, Read, Write};
use std::os::unix::fs::{FileTypeExt, MetadataExt, PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use crate::support::{Run, recede};

const SCENE: &str = "examples/scenes/hertz.ron";

/// A command that writes a file, the name of which comes last, and the endings that the name may have.
struct Writer {
    arguments: &'static [&'static str],
    endings: &'static [&'static str],
    /// Whether it replaces a file that is there.
    replaces: bool,
}

const fn writer(arguments: &'static [&'static str], endings: &'static [&'static str]) -> Writer {
    Writer { arguments, endings, replaces: true }
}

/// Every command that writes a file.
const WRITERS: [Writer; 9] = [
    writer(&["solve", SCENE, "--out"], &["json", "csv", "txt"]),
    writer(&["convert", SCENE, "--out"], &["json", "ron"]),
    writer(&["field", SCENE, "--x=-1:1:5", "--depth=0:1:4", "--out"], &["csv", "json", "svg", "pdf", "png"]),
    writer(&["profile", SCENE, "--points", "10", "--out"], &["csv"]),
    writer(&["plot", SCENE, "--out"], &["svg", "pdf", "png"]),
    writer(&["sweep", SCENE, "--vary", "force=[0.001,0.002]", "--out"], &["csv", "parquet"]),
    writer(&["sweep", SCENE, "--vary", "force=0.001:0.002:3", "--plot"], &["svg", "pdf", "png"]),
    writer(&["merge", SCENE, "--vary", "force=[0.001,0.002]", "PART", "--out"], &["csv", "parquet"]),
    Writer { arguments: &["init"], endings: &["ron"], replaces: false },
];

/// A new folder.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("outputs").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

/// The command with this name of a file, and with the file of a part in `folder`.
fn arguments(writer: &Writer, folder: &Path, out: &Path) -> Vec<String> {
    let part = folder.join("part.csv");
    if writer.arguments[0] == "merge" && !part.exists() {
        let sweep = ["sweep", SCENE, "--vary", "force=[0.001,0.002]", "--out", text(&part)];
        assert_eq!(recede(&sweep, b"").status, Some(0));
    }
    let word = |word: &&str| if *word == "PART" { text(&part).to_owned() } else { (*word).to_owned() };
    writer.arguments.iter().map(word).chain([text(out).to_owned()]).collect()
}

fn run(writer: &Writer, folder: &Path, out: &Path) -> Run {
    let arguments = arguments(writer, folder, out);
    recede(&arguments.iter().map(String::as_str).collect::<Vec<_>>(), b"")
}

#[track_caller]
fn succeeds(writer: &Writer, folder: &Path, out: &Path) {
    let run = run(writer, folder, out);
    assert_eq!(run.status, Some(0), "{:?} {}: {}", writer.arguments, out.display(), run.stderr);
}

#[track_caller]
fn refused(writer: &Writer, folder: &Path, out: &Path) -> String {
    let run = run(writer, folder, out);
    assert_eq!((run.status, &run.stdout[..]), (Some(2), ""), "{:?} {}", writer.arguments, out.display());
    run.stderr
}

/// What is written but for the time that it took.
fn timeless(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes);
    let lines = text.lines().filter(|line| !line.contains("seconds") && !line.contains("Newton steps"));
    lines.collect::<Vec<_>>().join("\n")
}

/// All commands with all their kinds of files, and what each writes to a new regular file.
fn each(name: &str, mut with: impl FnMut(&Writer, &Path, &str, &str)) {
    for (number, writer) in WRITERS.iter().enumerate() {
        for ending in writer.endings {
            let folder = folder(name).join(format!("{number}_{ending}"));
            fs::create_dir_all(&folder).unwrap();
            let plain = folder.join(format!("plain.{ending}"));
            succeeds(writer, &folder, &plain);
            let expected = timeless(&fs::read(&plain).unwrap());
            assert!(!expected.is_empty());
            with(writer, &folder, ending, &expected);
        }
    }
}

#[test]
fn regular_files_are_replaced_with_their_permissions_and_links_stay() {
    each("regular", |writer, folder, ending, expected| {
        let [target, link, chain] = ["target", "link", "chain"].map(|name| folder.join(format!("{name}.{ending}")));
        let inner = folder.join("inner");
        fs::create_dir(&inner).unwrap();
        // a link to nothing yet is where the file is to be, and a relative one begins in its own folder
        symlink(format!("../target.{ending}"), inner.join("link")).unwrap();
        symlink("inner/link", &link).unwrap();
        symlink(&link, &chain).unwrap();
        for mode in [None, Some(0o600), Some(0o640)] {
            if let (Some(mode), true) = (mode, writer.replaces) {
                fs::write(&target, "old").unwrap();
                fs::set_permissions(&target, fs::Permissions::from_mode(mode)).unwrap();
            } else {
                let _ = fs::remove_file(&target);
            }
            succeeds(writer, folder, &chain);
            assert_eq!(timeless(&fs::read(&target).unwrap()), expected, "{:?}", writer.arguments);
            assert!([&link, &chain].iter().all(|link| fs::symlink_metadata(link).unwrap().is_symlink()));
            if writer.replaces {
                let found = fs::metadata(&target).unwrap().mode() & 0o777;
                assert!(mode.is_none_or(|mode| mode == found), "{:?}: {found:o}", writer.arguments);
            }
        }
        let left = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
        let left: Vec<String> = left.filter(|name| name.contains(".part") || name.ends_with(".parquet.csv")).collect();
        assert!(left.is_empty(), "{left:?}");
    });
}

#[test]
fn pipes_are_written_through() {
    each("pipes", |writer, folder, ending, expected| {
        let pipe = folder.join(format!("pipe.{ending}"));
        assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        let (read, at) = (
            thread::spawn({
                let pipe = pipe.clone();
                move || fs::read(pipe).unwrap()
            }),
            Instant::now(),
        );
        succeeds(writer, folder, &pipe);
        assert!(fs::symlink_metadata(&pipe).unwrap().file_type().is_fifo(), "{:?}", writer.arguments);
        assert_eq!(timeless(&read.join().unwrap()), expected, "{:?}", writer.arguments);
        assert!(at.elapsed() < Duration::from_secs(60));
    });
}

#[test]
fn standard_output_by_name_is_standard_output() {
    for (number, writer) in WRITERS.iter().enumerate() {
        let folder = folder("stdout").join(number.to_string());
        fs::create_dir_all(&folder).unwrap();
        // what goes to standard output without a name, or else to a file of the first kind
        let option = writer.arguments[writer.arguments.len() - 1];
        let expected = if ["plot", "merge", "init"].contains(&writer.arguments[0]) || option == "--plot" {
            let plain = folder.join(format!("plain.{}", writer.endings[0]));
            succeeds(writer, &folder, &plain);
            fs::read(plain).unwrap()
        } else {
            let without = &writer.arguments[..writer.arguments.len() - 1];
            recede(without, b"").stdout.into_bytes()
        };
        let expected = timeless(&expected);
        let stdout = Path::new("/dev/stdout");
        let arguments = arguments(writer, &folder, stdout);
        let command = || {
            let mut command = Command::new(env!("CARGO_BIN_EXE_recede"));
            command.args(&arguments).stderr(Stdio::null());
            command
        };
        if option == "--plot" {
            // there are the rows
            let run = run(writer, &folder, stdout);
            assert!(run.status == Some(2) && run.stderr.contains("are the same file"), "{}", run.stderr);
            continue;
        }
        let piped = command().output().unwrap();
        assert_eq!((piped.status.code(), timeless(&piped.stdout)), (Some(0), expected.clone()), "{arguments:?}");
        // behind what stands in a file already
        for number in [1, 3] {
            let file = folder.join(format!("all_{number}"));
            fs::write(&file, "before\n").unwrap();
            let opened = OpenOptions::new().append(true).open(&file).unwrap();
            let status = if number == 1 {
                command().stdout(opened).status().unwrap()
            } else {
                let script = format!("exec \"$0\" \"$@\" 3>> '{}'", file.display());
                let mut words = arguments.clone();
                *words.last_mut().unwrap() = "/dev/fd/3".to_owned();
                Command::new("sh").args(["-c", &script, env!("CARGO_BIN_EXE_recede")]).args(words).status().unwrap()
            };
            assert!(status.success(), "{arguments:?}");
            let all = timeless(&fs::read(&file).unwrap());
            assert_eq!(all, format!("before\n{expected}"), "{arguments:?}");
        }
    }
}

#[test]
fn devices_stay_devices() {
    for writer in &WRITERS {
        let folder = folder("devices");
        let device = folder.join("null");
        // only an administrator makes devices, and only those of one can be replaced
        let made = Command::new("mknod").arg(&device).args(["c", "1", "3"]).stderr(Stdio::null()).status();
        if !made.is_ok_and(|made| made.success()) {
            return;
        }
        succeeds(writer, &folder, &device);
        let found = fs::symlink_metadata(&device).unwrap();
        assert!(found.file_type().is_char_device(), "{:?}", writer.arguments);
        assert_eq!(found.rdev(), fs::metadata("/dev/null").unwrap().rdev());
    }
}

#[test]
fn a_reader_that_has_enough_is_no_error() {
    let pipe = folder("enough").join("pipe.csv");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let read = thread::spawn({
        let pipe = pipe.clone();
        move || File::open(pipe).unwrap().read_exact(&mut [0; 10]).unwrap()
    });
    // more than a pipe holds
    let run = recede(&["profile", SCENE, "--points", "20000", "--out", text(&pipe)], b"");
    assert_eq!((run.status, &run.stderr[..]), (Some(0), ""));
    read.join().unwrap();
}

#[test]
fn a_folder_that_is_not_there_is_told_with_the_file_that_was_asked_for() {
    for writer in &WRITERS {
        for ending in writer.endings {
            let folder = folder("nowhere");
            let out = folder.join(format!("no/such/file.{ending}"));
            let said = refused(writer, &folder, &out);
            assert!(said.contains(&format!("{}", out.display())), "{said}");
            assert!(said.starts_with("error: ") && !said.contains(&format!("file.{ending}.")), "{said}");
            refused(writer, &folder, &folder);
        }
    }
}

#[test]
fn names_of_other_kinds_of_files_are_refused_before_the_scene_is_read() {
    let none = "no/such/scene.ron";
    for (arguments, ending) in [
        (&["solve", none, "--out"][..], "png"),
        (&["solve", none, "--out"], "parquet"),
        (&["solve", none, "--format", "json", "--out"], "csv"),
        (&["solve", none, "--format", "csv", "--out"], "JSON"),
        (&["convert", none, "--out"], "csv"),
        (&["convert", none, "--to", "ron", "--out"], "json"),
        (&["field", none, "--out"], "parquet"),
        (&["profile", none, "--out"], "png"),
        (&["profile", none, "--out"], "ron"),
        (&["plot", none, "--out"], "csv"),
        (&["sweep", none, "--vary", "force=[1]", "--out"], "svg"),
        (&["sweep", none, "--vary", "force=[1]", "--out"], "json"),
        (&["sweep", none, "--vary", "force=[1]", "--plot"], "csv"),
        (&["merge", none, "--vary", "force=[1]", "part.csv", "--out"], "pdf"),
        (&["init"], "json"),
    ] {
        let out = folder("kinds").join(format!("file.{ending}"));
        let run = recede(&[arguments, &[text(&out)]].concat(), b"");
        assert_eq!((run.status, &run.stdout[..]), (Some(2), ""), "{arguments:?}");
        assert!(!run.stderr.contains("scene.ron") && !run.stderr.contains("part.csv"), "{arguments:?}: {}", run.stderr);
        assert!(!out.exists());
    }
}

/// One file by several names.
fn names(file: &Path) -> Vec<PathBuf> {
    let (folder, name) = (file.parent().unwrap(), file.file_name().unwrap());
    let ending = file.extension().unwrap().to_str().unwrap();
    let [link, hard] = ["soft", "hard"].map(|kind| folder.join(format!("{kind}_{}.{ending}", name.to_str().unwrap())));
    symlink(name, &link).unwrap();
    fs::hard_link(file, &hard).unwrap();
    fs::create_dir_all(folder.join("aside")).unwrap();
    vec![file.to_owned(), folder.join("aside/..").join(name), link, hard]
}

#[test]
fn what_a_command_reads_is_not_written() {
    for writer in WRITERS.iter().filter(|writer| writer.replaces) {
        for ending in writer.endings {
            let folder = folder("inputs");
            // what a scene is called does not matter
            let scene = folder.join(format!("scene.{ending}"));
            fs::copy(SCENE, &scene).unwrap();
            let before = fs::read(&scene).unwrap();
            for out in names(&scene) {
                let words = arguments(writer, &folder, &out);
                let words: Vec<&str> =
                    words.iter().map(|word| if word == SCENE { text(&scene) } else { &word[..] }).collect();
                // a merge begins with something else than rows
                let run = recede(&words, b"");
                assert_eq!((run.status, &run.stdout[..]), (Some(2), ""), "{words:?}");
                let said = ["is what this command reads", "is no sweep"].iter().any(|said| run.stderr.contains(said));
                assert!(said, "{words:?}: {}", run.stderr);
                assert_eq!(fs::read(&scene).unwrap(), before, "{words:?}");
                assert_eq!(fs::metadata(&scene).unwrap().nlink(), 2);
                if words[0] == "convert" {
                    let input = File::open(&scene).unwrap();
                    let mut command = Command::new(env!("CARGO_BIN_EXE_recede"));
                    command.args(["convert", "-", "--out", text(&out)]).stdin(input).stderr(Stdio::null());
                    assert_eq!(command.status().unwrap().code(), Some(2));
                }
            }
            for file in ["soft_scene", "hard_scene"] {
                let _ = fs::remove_file(folder.join(format!("{file}.{ending}.{ending}")));
            }
        }
    }
}

#[test]
fn the_scene_of_a_sweep_and_the_parts_of_a_merge_are_not_written() {
    let folder = folder("parts");
    let [sweep, scene, part] = ["sweep.ron", "scene.csv", "part.csv"].map(|name| folder.join(name));
    fs::copy(SCENE, &scene).unwrap();
    fs::write(&sweep, "Sweep(scene: \"scene.csv\", vary: [List(path: \"force\", values: [0.001, 0.002])])").unwrap();
    assert_eq!(recede(&["sweep", text(&sweep), "--out", text(&part)], b"").status, Some(0));
    for file in [&scene, &part] {
        let before = fs::read(file).unwrap();
        for out in names(file) {
            let merge = recede(&["merge", text(&sweep), text(&part), "--out", text(&out)], b"");
            let sweep = recede(&["sweep", text(&sweep), "--out", text(&out)], b"");
            assert!(merge.status == Some(2) && merge.stderr.contains("is what this command reads"), "{}", merge.stderr);
            // a sweep does not read the file of a part
            assert!(file == &part || sweep.status == Some(2), "{}", sweep.stderr);
            assert_eq!(fs::read(file).unwrap(), before);
        }
    }
}

#[test]
fn rows_and_their_picture_are_two_files() {
    let folder = folder("both");
    let picture = folder.join("picture.svg");
    fs::write(&picture, "old").unwrap();
    let [soft, hard, pipe] = ["soft.csv", "hard.csv", "pipe"].map(|name| folder.join(name));
    symlink("picture.svg", &soft).unwrap();
    fs::hard_link(&picture, &hard).unwrap();
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let none = folder.join("none.csv");
    symlink("aside.svg", &none).unwrap();
    let aside = folder.join("aside.svg");
    for (out, plot) in [(&soft, &picture), (&hard, &picture), (&pipe, &pipe), (&none, &aside)] {
        let vary = ["sweep", SCENE, "--vary", "force=0.001:0.002:3"];
        let run = recede(&[&vary[..], &["--out", text(out), "--plot", text(plot)]].concat(), b"");
        assert_eq!((run.status, &run.stdout[..]), (Some(2), ""), "{}", run.stderr);
        assert!(run.stderr.contains("are the same file"), "{}", run.stderr);
        assert_eq!(fs::read(&picture).unwrap(), b"old");
    }
}

/// The arguments of a sweep that does not end by itself, but for the file.
const ENDLESS: [&str; 7] =
    ["sweep", SCENE, "--vary", "punch.radius=500:501:1000", "--vary", "force=0.001:0.002:10000", "--out"];

/// The sweep, as soon as some rows are there.
fn endless(out: &Path) -> Child {
    let mut child = Command::new(env!("CARGO_BIN_EXE_recede"))
        .args([&ENDLESS[..], &[text(out)]].concat())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    while fs::read_to_string(out).unwrap_or_default().lines().count() < 5 {
        assert!(child.try_wait().unwrap().is_none());
        thread::sleep(Duration::from_millis(1));
    }
    child
}

#[test]
fn two_sweeps_do_not_write_one_file() {
    let folder = folder("locked");
    let [rows, link] = ["rows.csv", "link.csv"].map(|name| folder.join(name));
    symlink("rows.csv", &link).unwrap();
    let mut first = endless(&rows);
    for (out, more) in [(&rows, &[][..]), (&rows, &["--resume"]), (&link, &[]), (&link, &["--resume"])] {
        let run = recede(&[&ENDLESS[..], &[text(out)], more].concat(), b"");
        assert_eq!((run.status, &run.stdout[..]), (Some(2), ""), "{}", run.stderr);
        assert!(run.stderr.contains("is being written by another sweep"), "{}", run.stderr);
    }
    let whole = recede(&["profile", SCENE, "--out", text(&rows)], b"");
    assert!(
        whole.status == Some(2) && whole.stderr.contains("is being written by another process"),
        "{}",
        whole.stderr
    );
    assert!(first.try_wait().unwrap().is_none());
    first.kill().unwrap();
    first.wait().unwrap();
    // nothing is left behind that would keep others from it
    let mut next = endless(&rows);
    next.kill().unwrap();
    next.wait().unwrap();
    let file = BufReader::new(File::open(&rows).unwrap());
    let forces = file.lines().skip(1).map(|line| line.unwrap()).filter(|line| line.contains("solved"));
    let forces: Vec<f64> = forces.map(|line| line.split(',').nth(1).unwrap().parse().unwrap()).collect();
    assert!(forces.is_sorted());
}

#[test]
fn a_new_scene_is_printed() {
    let Run { status, stdout, stderr } = recede(&["init", "-"], b"");
    assert_eq!((status, &stderr[..]), (Some(0), ""));
    let mut file = File::create(folder("init").join("scene.ron")).unwrap();
    file.write_all(stdout.as_bytes()).unwrap();
    assert_eq!(recede(&["check", "-"], stdout.as_bytes()).status, Some(0));
    assert!(!Path::new("-").exists());
    // another one is left alone
    let taken = folder("init").join("taken.ron");
    fs::write(&taken, "mine").unwrap();
    assert_eq!(recede(&["init", text(&taken)], b"").status, Some(2));
    assert_eq!(fs::read(&taken).unwrap(), b"mine");
}
