//! Copies of a tree in which something was built, for further workers.
//!
//! Nobody shares a file with another: what is built in one tree reaches no other.

use std::fs::{self, File};
use std::io;
use std::path::Path;

/// Copies a folder with the times of its files, from which cargo sees what is up to date. Where the
/// file system can share blocks until one is written, that is what happens.
pub(crate) fn copy(from: &Path, to: &Path) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let (path, copied) = (entry.path(), to.join(entry.file_name()));
        let kind = entry.file_type()?;
        if kind.is_dir() {
            copy(&path, &copied)?;
        } else if kind.is_file() {
            fs::copy(&path, &copied)?;
            File::options()
                .write(true)
                .open(&copied)?
                .set_modified(entry.metadata()?.modified()?)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::time::{Duration, SystemTime};

    use super::copy;

    #[test]
    fn times_are_kept_and_nothing_is_shared() {
        let folder = tempfile::tempdir().unwrap();
        let (from, to) = (folder.path().join("a"), folder.path().join("b"));
        fs::create_dir_all(from.join("deep")).unwrap();
        fs::write(from.join("deep/x"), "one").unwrap();
        let then = SystemTime::now() - Duration::from_secs(5000);
        let file = fs::File::options().write(true).open(from.join("deep/x")).unwrap();
        file.set_modified(then).unwrap();
        copy(&from, &to).unwrap();
        assert_eq!(fs::metadata(to.join("deep/x")).unwrap().modified().unwrap(), then);
        fs::write(to.join("deep/x"), "two").unwrap();
        assert_eq!(fs::read_to_string(from.join("deep/x")).unwrap(), "one");
    }
}
