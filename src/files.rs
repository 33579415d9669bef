//! Where output goes: regular files, which appear when they are complete, and pipes and devices, which are written through.
use std::fs::{self, File, Metadata, OpenOptions, TryLockError};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU64, Ordering};

/// Number of the next unfinished file of this process.
static NEXT: AtomicU64 = AtomicU64::new(0);

/// Symbolic links that are followed one after the other, as many as Linux follows.
const MOST_LINKS: usize = 40;

/// Where a path leads, all symbolic links followed.
enum Destination {
    /// A regular file, which need not exist.
    File(PathBuf),
    /// A descriptor of this process: standard output, or standard error.
    Standard(Box<dyn Write + Send>),
    /// A pipe, a device, a folder, or another descriptor.
    Other(PathBuf),
}

impl Destination {
    fn of(path: &Path) -> io::Result<Self> {
        let mut path = path.to_owned();
        for _ in 0..MOST_LINKS {
            if let Some(place) = descriptor(&path) {
                return Ok(place);
            }
            match fs::symlink_metadata(&path) {
                Ok(found) if found.is_symlink() => path = folder(&path).join(fs::read_link(&path)?),
                Ok(found) if !found.is_file() => return Ok(Self::Other(path)),
                Err(error) if error.kind() != ErrorKind::NotFound => return Err(error),
                _ => return Ok(Self::File(path)),
            }
        }
        Err(io::Error::other("too many symbolic links follow each other"))
    }

    /// The pipe, device or descriptor, opened for writing; `None` for a regular file.
    fn stream(self) -> io::Result<Option<Box<dyn Write + Send>>> {
        Ok(match self {
            Self::File(_) => None,
            Self::Standard(stream) => Some(stream),
            // a descriptor may belong to a file in which something stands already
            Self::Other(path) => Some(Box::new(OpenOptions::new().append(true).open(path)?)),
        })
    }
}

/// The open file that a path such as `/dev/fd/1` stands for, whatever it is; `None` for other paths.
fn descriptor(path: &Path) -> Option<Destination> {
    let folder = folder(path).canonicalize().ok()?;
    let own = Path::new("/proc").join(process::id().to_string());
    if !(folder == Path::new("/dev/fd") || folder.starts_with("/proc") && folder.ends_with("fd")) {
        return None;
    }
    let is_own = folder.starts_with("/dev") || folder.starts_with(own);
    Some(match path.file_name()?.to_str()? {
        "1" if is_own => Destination::Standard(Box::new(io::stdout())),
        "2" if is_own => Destination::Standard(Box::new(io::stderr())),
        _ => Destination::Other(path.to_owned()),
    })
}

/// The folder in which a path ends.
pub fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Writes all of a file. Symbolic links are followed, and stay.
///
/// A regular file is written completely or not at all: what was there before stays until the new file is complete, which
/// then has the same permissions. The unfinished file stands beside it under a name with the number of the process and a
/// count, so that neither two processes nor two threads that write the same file disturb each other, and it is created,
/// never overwritten. Anything else, such as a pipe, a device or `/dev/stdout`, is not replaced but written through.
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
    let path = match Destination::of(path)? {
        Destination::File(path) => path,
        other => {
            let Some(stream) = other.stream()? else { return Ok(()) };
            let mut out = BufWriter::new(stream);
            return write(&mut out).and_then(|()| out.flush());
        }
    };
    // a file that must not be written is not replaced either
    let old = match OpenOptions::new().write(true).open(&path) {
        // nor one that grows by lines, as a sweep writes it
        Ok(old) if matches!(old.try_lock_shared(), Err(TryLockError::WouldBlock)) => {
            return Err(io::Error::other("it is being written by another process"));
        }
        Ok(old) => Some(old.metadata()?),
        Err(error) if error.kind() == ErrorKind::NotFound => None,
        Err(error) => return Err(error),
    };
    let (part, file) = unfinished(folder(&path))?;
    let mut out = BufWriter::new(file);
    let written = old
        .map_or(Ok(()), |old| inherit(out.get_ref(), &old))
        .and_then(|()| write(&mut out))
        .and_then(|()| out.into_inner()?.sync_all())
        .and_then(|()| fs::rename(&part, &path));
    if written.is_err() {
        // the error of writing is the one to report
        let _ = fs::remove_file(&part);
    }
    written
}

/// A new file in a folder, and its name.
fn unfinished(folder: &Path) -> io::Result<(PathBuf, File)> {
    loop {
        // short, so that it is legal wherever the name of the finished file is
        let name = format!(".recede-{}-{}.part", process::id(), NEXT.fetch_add(1, Ordering::Relaxed));
        let part = folder.join(name);
        match OpenOptions::new().write(true).create_new(true).open(&part) {
            // left by a process that had the same number
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            other => return other.map(|file| (part, file)),
        }
    }
}

/// Gives a new file the owner, as far as that is allowed, and the permissions of an old one.
fn inherit(file: &File, old: &Metadata) -> io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::{MetadataExt, fchown};
        // only an administrator may give files away
        let _ = fchown(file, Some(old.uid()), Some(old.gid()));
    }
    file.set_permissions(old.permissions())
}

/// Writes a file that is not there yet; anything but a regular file is written through as in [`replace`].
///
/// # Errors
/// Those of the file system, [`ErrorKind::AlreadyExists`] if there is such a file.
pub fn create(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if let Destination::File(path) = Destination::of(path)? {
        return OpenOptions::new().write(true).create_new(true).open(path)?.write_all(bytes);
    }
    replace(path, |out| out.write_all(bytes))
}

/// Whether a path leads to something else than a regular file, such as a pipe, a device or `/dev/stdout`: its name says
/// nothing about what is written to it.
pub fn is_stream(path: &Path) -> bool {
    Destination::of(path).is_ok_and(|place| !matches!(place, Destination::File(_)))
}

/// A path that [`is_stream`], opened for writing; `None` for a regular file. A named pipe waits for its reader.
///
/// # Errors
/// Those of the file system.
pub fn stream(path: &Path) -> io::Result<Option<Box<dyn Write + Send>>> {
    Destination::of(path)?.stream()
}

/// Whether two paths lead to the same file, there or yet to be made, however they are written: through links, by several
/// names of one file, or through other folders. What is written to a device is not kept there, so that only regular files
/// and named pipes are ever the same.
///
/// ```
/// use recede::files::same;
/// assert!(same("Cargo.toml".as_ref(), "src/../Cargo.toml".as_ref()));
/// assert!(same("src/none".as_ref(), "./src/../src/none".as_ref()));
/// assert!(!same("Cargo.toml".as_ref(), "Cargo.lock".as_ref()));
/// ```
pub fn same(a: &Path, b: &Path) -> bool {
    match (fs::metadata(a), fs::metadata(b)) {
        (Ok(one), Ok(other)) => is_same_file((a, &one), (b, &other)),
        (Err(_), Err(_)) => planned(a).is_some_and(|a| planned(b) == Some(a)),
        _ => false,
    }
}

#[cfg(unix)]
fn is_same_file((_, one): (&Path, &Metadata), (_, other): (&Path, &Metadata)) -> bool {
    use std::os::unix::fs::{FileTypeExt, MetadataExt};
    let kind = one.file_type();
    (kind.is_file() || kind.is_fifo()) && (one.dev(), one.ino()) == (other.dev(), other.ino())
}

#[cfg(not(unix))]
fn is_same_file((one, found): (&Path, &Metadata), (other, _): (&Path, &Metadata)) -> bool {
    found.is_file() && one.canonicalize().is_ok_and(|one| other.canonicalize().is_ok_and(|other| one == other))
}

/// Where a file that does not exist will be.
fn planned(path: &Path) -> Option<PathBuf> {
    let Destination::File(path) = Destination::of(path).ok()? else { return None };
    Some(folder(&path).canonicalize().ok()?.join(path.file_name()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_cannot_be_written_leaves_the_old_one_and_nothing_else() {
        let folder = std::env::temp_dir().join(format!("recede-files-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        // as long as a name may be
        let file = folder.join("n".repeat(255));
        replace(&file, |out| out.write_all(b"old")).unwrap();
        let failed = replace(&file, |out| out.write_all(b"half").and(Err(io::Error::other("no more room"))));
        assert_eq!(failed.unwrap_err().to_string(), "no more room");
        assert_eq!(fs::read(&file).unwrap(), b"old");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        fs::remove_dir_all(&folder).unwrap();
    }
}
