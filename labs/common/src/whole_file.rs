//! Writes files completely or not at all.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
#[cfg(target_os = "linux")]
use std::os::fd::AsRawFd;
use std::path::Path;

#[cfg(target_os = "linux")]
use rustix::fs::{AtFlags, CWD, Mode, OFlags, linkat};
use tempfile::Builder;

/// Writes a file through `fill`, so that an incomplete file never appears under its name.
///
/// On Linux the file has no name until it is complete, so a program that is killed leaves nothing
/// behind. On other systems the incomplete file is a hidden file in the same folder. After an
/// error, an older file of that name is unchanged. A path that is not a regular file, such as
/// `/dev/stdout`, is written to directly.
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
    let mut builder = Builder::new();
    builder.prefix(&prefix);
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    #[cfg(target_os = "linux")]
    if let Ok(file) = without_name(folder) {
        let mut out = BufWriter::new(file);
        let value = fill(&mut out)?;
        out.flush()?;
        let file = out.into_inner()?;
        builder.make_in(folder, |path| give_name(&file, path))?.persist(path)?;
        return Ok(value);
    }
    let mut out = BufWriter::new(builder.tempfile_in(folder)?);
    let value = fill(&mut out)?;
    out.flush()?;
    out.into_inner()?.persist(path)?;
    Ok(value)
}

/// Returns a file in `folder` that has no name yet. The system removes it if the program ends
/// before the file gets a name.
#[cfg(target_os = "linux")]
fn without_name(folder: &Path) -> io::Result<File> {
    let flags = OFlags::TMPFILE | OFlags::WRONLY | OFlags::CLOEXEC;
    Ok(rustix::fs::open(folder, flags, Mode::from_raw_mode(0o666))?.into())
}

#[cfg(target_os = "linux")]
fn give_name(file: &File, path: &Path) -> io::Result<()> {
    let own = format!("/proc/self/fd/{}", file.as_raw_fd());
    Ok(linkat(CWD, own, CWD, path, AtFlags::SYMLINK_FOLLOW)?)
}

#[cfg(test)]
mod tests {
    use super::*;

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

    #[test]
    #[cfg(target_os = "linux")]
    fn a_killed_program_would_leave_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("out.txt");
        let seen = write_whole(&path, |out| {
            out.write_all(b"half")?;
            out.flush()?;
            Ok(fs::read_dir(folder.path())?.count())
        });
        assert_eq!(seen.unwrap(), 0, "the file has no name while it is written");
        assert_eq!(fs::read(&path).unwrap(), b"half");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}
