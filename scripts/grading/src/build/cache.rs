//! Cache of a lab's compiled dependencies, kept for the next grading run.
//!
//! The cache is written before any submission is built, in a folder that no sandbox shows. Cargo
//! compares the modification times of files to see whether the cache is up to date. Therefore the
//! kit's files get an old modification time.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;

use anyhow::{Context, Result, ensure};

use lab_kit::files::{digest, read_bytes};
use lab_kit::{Kit, files_below};

/// Returns the folder of the cache. The cache contains only the lab that was graded last, because
/// each lab takes hundreds of megabytes.
pub(crate) fn of(kit: &Kit) -> PathBuf {
    kit.memory().join("compiled/probe")
}

/// Copies the cache into a new tree if both have the same sources.
pub(crate) fn put_into(kept: &Path, tree: &Path) -> Result<()> {
    if fs::read_to_string(kept.join("sources")).is_ok_and(|kept| Some(kept) == sources(tree).ok()) {
        copy(&kept.join("target"), &tree.join("target")).context("cannot copy a build")?;
        for path in given(tree)? {
            File::options().write(true).open(path)?.set_modified(SystemTime::UNIX_EPOCH)?;
        }
    }
    Ok(())
}

/// Copies the build of a tree into the cache, unless the cache has it already.
///
/// If the grader is killed during the copy, an incomplete folder remains, which is never used.
pub(crate) fn keep(kept: &Path, tree: &Path) -> Result<()> {
    let sources = sources(tree)?;
    if fs::read_to_string(kept.join("sources")).is_ok_and(|kept| kept == sources) {
        return Ok(());
    }
    write(kept, tree, &sources).with_context(|| format!("cannot write {}", kept.display()))
}

fn write(kept: &Path, tree: &Path, sources: &str) -> Result<()> {
    let folder = kept.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder)?;
    let new = tempfile::tempdir_in(folder)?;
    copy(&tree.join("target"), &new.path().join("target"))?;
    fs::write(new.path().join("sources"), sources)?;
    let old = tempfile::tempdir_in(folder)?;
    // Another grading run may write the cache at the same time. Either copy can be kept.
    let _ = fs::rename(kept, old.path().join("old"));
    let _ = fs::rename(new.path(), kept);
    Ok(())
}

/// Copies a folder and keeps the modification times of its files, because Cargo compares these
/// times.
///
/// The copies share no file, so a build in one tree cannot change another tree.
pub(crate) fn copy(from: &Path, to: &Path) -> Result<()> {
    let output = Command::new("cp").arg("-a").arg(from.join(".")).arg(to).output()?;
    ensure!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr).trim());
    Ok(())
}

/// Returns the SHA-256 of the sources that the cache depends on: manifests and provided code.
fn sources(tree: &Path) -> Result<String> {
    let files = ["Cargo.lock", "Cargo.toml", "rust-toolchain.toml"].map(|file| tree.join(file));
    let mut all = Vec::new();
    for path in files.into_iter().chain(given(tree)?) {
        all.extend(path.strip_prefix(tree)?.as_os_str().as_encoded_bytes());
        all.extend(read_bytes(&path)?);
    }
    Ok(digest(&all))
}

/// Returns the files of a tree that belong neither to a submission nor to a lab's questions.
///
/// These are the provided code, earlier solutions, and the oracle.
fn given(tree: &Path) -> Result<Vec<PathBuf>> {
    let labs = tree.join("labs");
    let mut files = files_below(&labs)?;
    files.retain(|path| {
        let name = path.strip_prefix(&labs).unwrap_or(path).to_string_lossy();
        !name.starts_with("lab") && !name.starts_with("probe")
    });
    files.extend(files_below(&tree.join("solutions"))?);
    files.extend(files_below(&tree.join("tests"))?);
    Ok(files)
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::{Path, PathBuf};
    use std::time::SystemTime;

    use super::{keep, put_into};

    /// Makes a tree with the files that the cache depends on.
    fn tree(tree: PathBuf, lock: &str, given: &str) -> PathBuf {
        fs::create_dir_all(tree.join("labs/common")).unwrap();
        for (file, text) in [
            ("Cargo.lock", lock),
            ("Cargo.toml", "t"),
            ("rust-toolchain.toml", "r"),
            ("labs/common/lib.rs", given),
        ] {
            fs::write(tree.join(file), text).unwrap();
        }
        tree
    }

    fn is_old(tree: &Path) -> bool {
        let file = fs::metadata(tree.join("labs/common/lib.rs")).unwrap();
        file.modified().unwrap() == SystemTime::UNIX_EPOCH
    }

    #[test]
    fn what_was_built_comes_back_as_long_as_it_is_made_of_the_same() {
        let folder = tempfile::tempdir().unwrap();
        let kept = folder.path().join("kept/probe");
        let built = tree(folder.path().join("built"), "1", "g");
        fs::create_dir_all(built.join("target")).unwrap();
        fs::write(built.join("target/x"), "rlib").unwrap();
        keep(&kept, &built).unwrap();
        for (name, lock, given) in [("same", "1", "g"), ("changed", "1", "h"), ("other", "2", "g")]
        {
            let new = tree(folder.path().join(name), lock, given);
            put_into(&kept, &new).unwrap();
            let there = fs::read_to_string(new.join("target/x")).is_ok_and(|built| built == "rlib");
            assert_eq!((there, is_old(&new)), (name == "same", name == "same"), "{name}");
        }
    }
}
