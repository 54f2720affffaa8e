//! Files that are written whole or not at all.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;

use tempfile::Builder;

/// Writes a file through `fill`. The file appears under its name only once it is complete; after
/// an error an older file of that name is still there, untouched.
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
    let mut builder = Builder::new();
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut out = BufWriter::new(builder.prefix(".unfinished-").tempfile_in(folder)?);
    let value = fill(&mut out)?;
    out.flush()?;
    out.into_inner()?.persist(path)?;
    Ok(value)
}
