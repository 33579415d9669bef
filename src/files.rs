//! Files that appear when they are complete.
use std::fs::{self, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};

/// Number of the next unfinished file of this process.
static NEXT: AtomicU64 = AtomicU64::new(0);

/// Writes a file completely or not at all: what was there before stays until the new file is complete.
///
/// The unfinished file stands beside it under a name with the number of the process and a count, so that neither two
/// processes nor two threads that write the same file disturb each other, and it is created, never overwritten.
///
/// ```
/// # let file = std::env::temp_dir().join(format!("recede-replace-{}", std::process::id()));
/// recede::files::replace(&file, |out| out.write_all(b"complete"))?;
/// assert_eq!(std::fs::read(&file)?, b"complete");
/// # std::fs::remove_file(&file)?;
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// # Errors
/// Those of `write` and of the file system; the unfinished file is then removed.
pub fn replace(path: &Path, write: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>) -> io::Result<()> {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!(".{}-{}.part", std::process::id(), NEXT.fetch_add(1, Ordering::Relaxed)));
    let part = path.with_file_name(name);
    let file = OpenOptions::new().write(true).create_new(true).open(&part)?;
    let mut out = BufWriter::new(file);
    let written = write(&mut out).and_then(|()| out.into_inner()?.sync_all()).and_then(|()| fs::rename(&part, path));
    if written.is_err() {
        // the error of writing is the one to report
        let _ = fs::remove_file(&part);
    }
    written
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_cannot_be_written_leaves_the_old_one_and_nothing_else() {
        let folder = std::env::temp_dir().join(format!("recede-files-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let file = folder.join("numbers.csv");
        replace(&file, |out| out.write_all(b"old")).unwrap();
        let failed = replace(&file, |out| out.write_all(b"half").and(Err(io::Error::other("no more room"))));
        assert_eq!(failed.unwrap_err().to_string(), "no more room");
        assert_eq!(fs::read(&file).unwrap(), b"old");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        fs::remove_dir_all(&folder).unwrap();
    }
}
