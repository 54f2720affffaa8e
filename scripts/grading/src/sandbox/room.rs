//! Free space on disks, which the grader checks before it builds.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use rustix::fs::statvfs;

/// Bytes that the records, letters and pages of a class need.
const RECORDS: u64 = 64 << 20;

/// Returns the bytes that this user may still write in a folder.
pub(crate) fn free(folder: &Path) -> Result<u64> {
    let disk = statvfs(folder).with_context(|| format!("cannot read {}", folder.display()))?;
    Ok(disk.f_bavail.saturating_mul(disk.f_frsize))
}

/// Makes a folder for records.
///
/// # Errors
/// If the folder cannot be written or has too little space.
pub(crate) fn make_for_records(folder: &Path) -> Result<()> {
    let written = fs::create_dir_all(folder).and_then(|()| tempfile::tempfile_in(folder));
    written.with_context(|| format!("cannot write in {}", folder.display()))?;
    expect(folder, RECORDS)
}

/// Checks that a folder has `bytes` bytes of free space.
///
/// # Errors
/// If the folder has less space. The message names the folder.
pub(crate) fn expect(folder: &Path, bytes: u64) -> Result<()> {
    let left = free(folder)?;
    ensure!(
        left >= bytes,
        "{} MiB are free in {}, and grading needs {} MiB there: make room, or set TMPDIR to a folder on another disk",
        left >> 20,
        folder.display(),
        bytes >> 20
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{expect, free, make_for_records};

    #[test]
    fn too_little_room_is_said_with_the_place() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        expect(folder, 0).unwrap();
        assert!(free(folder).unwrap() < 1 << 62);
        let error = expect(folder, 1 << 62).unwrap_err().to_string();
        assert!(error.contains(&folder.display().to_string()), "{error}");
        let file = folder.join("file");
        std::fs::write(&file, "").unwrap();
        let error = make_for_records(&file).unwrap_err().to_string();
        assert!(error.starts_with("cannot write in "), "{error}");
        assert!(free(&folder.join("none")).is_err());
    }
}
