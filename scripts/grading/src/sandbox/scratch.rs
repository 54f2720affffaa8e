//! Temporary folders that are removed when grading ends. If a grading run is killed, the next run
//! removes its folders.
//!
//! All these folders are in one folder, which is locked. The system releases a lock when its
//! process ends, for whatever reason. So a folder that can be locked belongs to no running process,
//! unless it was just made and is empty.

use std::fs::{self, File, Permissions};
use std::io;
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::path::Path;

use anyhow::{Context, Result};
use rustix::process::getuid;
use tempfile::{Builder, TempDir};

const PREFIX: &str = "cutoff-grade-";

/// A folder for temporary folders.
#[derive(Debug)]
pub(crate) struct Scratch {
    folder: TempDir,
    /// Lock that is held as long as this value exists.
    _lock: File,
}

impl Scratch {
    /// Makes a folder in `parent` and removes the folders of ended processes there.
    pub(crate) fn below(parent: &Path) -> Result<Self> {
        remove_left(parent);
        Self::make(parent).with_context(|| format!("cannot make a folder in {}", parent.display()))
    }

    fn make(parent: &Path) -> io::Result<Self> {
        // Programs run as nobody and must reach their own folder.
        let folder = open_folder(PREFIX, parent, 0o711)?;
        let lock = File::open(folder.path())?;
        lock.lock()?;
        Ok(Self { folder, _lock: lock })
    }

    /// Returns the path of the folder.
    pub(crate) fn path(&self) -> &Path {
        self.folder.path()
    }

    /// Makes a folder that every user can read, inside this folder.
    pub(crate) fn folder(&self) -> Result<TempDir> {
        open_folder(".tmp", self.path(), 0o755)
            .with_context(|| format!("cannot make a folder in {}", self.path().display()))
    }
}

/// Makes a folder with these permissions, whatever the user's umask is.
fn open_folder(prefix: &str, parent: &Path, permissions: u32) -> io::Result<TempDir> {
    let folder = Builder::new().prefix(prefix).tempdir_in(parent)?;
    fs::set_permissions(folder.path(), Permissions::from_mode(permissions))?;
    Ok(folder)
}

/// Removes folders in `parent` that killed grading runs of this user left behind. A folder that
/// cannot be removed does not prevent grading.
fn remove_left(parent: &Path) {
    for entry in fs::read_dir(parent).into_iter().flatten().flatten() {
        let path = entry.path();
        let own = fs::symlink_metadata(&path)
            .is_ok_and(|found| found.is_dir() && found.uid() == getuid().as_raw());
        let ours = entry.file_name().to_string_lossy().starts_with(PREFIX) && own;
        let Some(lock) = ours.then(|| File::open(&path).ok()).flatten() else { continue };
        let is_free = lock.try_lock().is_ok();
        let is_new = fs::read_dir(&path).is_ok_and(|mut all| all.next().is_none());
        if is_free && !is_new {
            let _ = fs::remove_dir_all(path);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::{PREFIX, Scratch};

    #[test]
    fn only_what_nobody_holds_is_removed() {
        let parent = tempfile::tempdir().unwrap();
        let left = parent.path().join(format!("{PREFIX}left"));
        let other = parent.path().join("other");
        for folder in [&left, &other] {
            fs::create_dir_all(folder.join("deep")).unwrap();
        }
        let first = Scratch::below(parent.path()).unwrap();
        let inside = first.folder().unwrap();
        assert!(!left.exists() && other.exists());
        let second = Scratch::below(parent.path()).unwrap();
        assert!(inside.path().is_dir(), "it is in use");
        let kept = second.folder.path().to_owned();
        drop((first, second));
        assert!(!kept.exists());
    }
}
