//! Files that are written whole or not at all.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::time::Duration;

use tempfile::Builder;

/// A file that was begun a moment ago may not be locked yet.
const A_MOMENT: Duration = Duration::from_secs(2);

/// Writes a file through `fill`. The file appears under its name only once it is complete; after
/// an error an older file of that name is still there, untouched.
///
/// Until then it is a hidden file beside it. A program that is killed leaves that behind, and the
/// next one that writes the same file clears it away.
///
/// A path that is no regular file, such as `/dev/stdout`, is written to directly.
///
/// # Errors
/// The folder or file cannot be written, or `fill` failed.
pub fn write_whole<T>(
    path: &Path,
    fill: impl FnOnce(&mut dyn Write) -> io::Result<T>,
) -> io::Result<T> {
    if fs::metadata(path).is_ok_and(|file| !file.is_file()) {
        let mut out = BufWriter::new(File::options().write(true).open(path)?);
        let value = fill(&mut out)?;
        out.flush()?;
        return Ok(value);
    }
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let mut prefix = OsString::from(".unfinished-");
    prefix.push(path.file_name().unwrap_or_default());
    prefix.push("-");
    clear_leftovers(folder, &prefix);
    let mut builder = Builder::new();
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let file = builder.prefix(&prefix).tempfile_in(folder)?;
    // The lock goes with the process, however that ends. Where files cannot be locked, leftovers
    // look used and stay.
    let _ = file.as_file().lock();
    let mut out = BufWriter::new(file);
    let value = fill(&mut out)?;
    out.flush()?;
    out.into_inner()?.persist(path)?;
    Ok(value)
}

/// Removes unfinished files that no process is writing any more. What cannot be removed stays.
fn clear_leftovers(folder: &Path, prefix: &OsString) {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    for entry in entries {
        let name = entry.file_name();
        if name.as_encoded_bytes().starts_with(prefix.as_encoded_bytes())
            && is_abandoned(&entry.path()).unwrap_or(false)
        {
            let _ = fs::remove_file(entry.path());
        }
    }
}

fn is_abandoned(path: &Path) -> io::Result<bool> {
    let file = File::options().write(true).open(path)?;
    let age = file.metadata()?.modified()?.elapsed().unwrap_or_default();
    Ok(age > A_MOMENT && file.try_lock().is_ok())
}

#[cfg(test)]
mod tests {
    use std::time::SystemTime;

    use super::*;

    #[test]
    fn a_killed_programs_leftover_goes_and_a_running_ones_stays() {
        let folder = tempfile::tempdir().unwrap();
        let file = |name: &str| {
            let file = File::create(folder.path().join(name)).unwrap();
            file.set_modified(SystemTime::now() - Duration::from_secs(60)).unwrap();
            file
        };
        drop(file(".unfinished-out.txt-killed"));
        drop(file(".unfinished-other.txt-killed"));
        let running = file(".unfinished-out.txt-running");
        running.lock().unwrap();
        write_whole(&folder.path().join("out.txt"), |out| out.write_all(b"text")).unwrap();
        let mut left: Vec<_> =
            fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        left.sort();
        let expected = [".unfinished-other.txt-killed", ".unfinished-out.txt-running", "out.txt"];
        assert_eq!(left, expected);
    }

    #[test]
    fn a_failure_leaves_the_older_file_alone() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("out.txt");
        write_whole(&path, |out| out.write_all(b"old")).unwrap();
        let failed = write_whole(&path, |out| {
            out.write_all(b"half of the n")?;
            Err::<(), _>(io::ErrorKind::StorageFull.into())
        });
        assert!(failed.is_err());
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "nothing else is left");
    }
}
