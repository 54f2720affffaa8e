//! What a lab depends on, compiled once and kept for the next grading.
//!
//! It is kept before anybody's submission comes near it, in a folder that no sandbox shows. Cargo
//! itself sees what of it is still up to date: packages from a registry are, those of the kit are
//! compiled again.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};

use lab_kit::Kit;
use lab_kit::files::{digest, read_bytes};

/// Where that is. The last lab's is kept, for it is some hundred megabytes.
pub(crate) fn of(kit: &Kit) -> PathBuf {
    kit.memory().join("compiled/probe")
}

/// Puts what is kept into a new tree, if it was built from the same versions.
pub(crate) fn put_into(kept: &Path, tree: &Path) -> Result<()> {
    if is_of(kept, tree) {
        copy(&kept.join("target"), &tree.join("target")).context("cannot copy a build")?;
    }
    Ok(())
}

/// Keeps what is built in a tree, unless the same is kept already. A program that is killed
/// half-way leaves what nobody takes.
pub(crate) fn keep(kept: &Path, tree: &Path) -> Result<()> {
    if is_of(kept, tree) {
        return Ok(());
    }
    let unkept = || format!("cannot write {}", kept.display());
    let folder = kept.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder).with_context(unkept)?;
    let new = tempfile::tempdir_in(folder).with_context(unkept)?;
    copy(&tree.join("target"), &new.path().join("target")).with_context(unkept)?;
    fs::write(new.path().join("versions"), versions(tree)?).with_context(unkept)?;
    let old = tempfile::tempdir_in(folder).with_context(unkept)?;
    // Somebody else may do the same at this moment; then theirs is as good.
    let _ = fs::rename(kept, old.path().join("old"));
    let _ = fs::rename(new.path(), kept);
    Ok(())
}

/// Whether what is kept was built from the versions of this tree.
fn is_of(kept: &Path, tree: &Path) -> bool {
    let built_from = fs::read_to_string(kept.join("versions"));
    built_from.is_ok_and(|kept| versions(tree).is_ok_and(|own| kept == own))
}

/// Copies a folder with the times of its files, from which cargo sees what is up to date. No file is
/// shared: what is built in one tree reaches no other.
pub(crate) fn copy(from: &Path, to: &Path) -> Result<()> {
    let output = Command::new("cp").arg("-a").arg(from.join(".")).arg(to).output()?;
    ensure!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr).trim());
    Ok(())
}

/// What the packages from registries depend on.
fn versions(tree: &Path) -> Result<String> {
    let mut all = Vec::new();
    for file in ["Cargo.lock", "Cargo.toml", "rust-toolchain.toml"] {
        all.extend(read_bytes(&tree.join(file))?);
    }
    Ok(digest(&all))
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::{keep, put_into};

    #[test]
    fn what_was_built_comes_back_as_long_as_versions_are_the_same() {
        let folder = tempfile::tempdir().unwrap();
        let kept = folder.path().join("kept/probe");
        let tree = |name: &str, lock: &str| {
            let tree = folder.path().join(name);
            fs::create_dir_all(&tree).unwrap();
            for (file, text) in
                [("Cargo.lock", lock), ("Cargo.toml", "t"), ("rust-toolchain.toml", "r")]
            {
                fs::write(tree.join(file), text).unwrap();
            }
            tree
        };
        let built = tree("built", "1");
        fs::create_dir_all(built.join("target")).unwrap();
        fs::write(built.join("target/x"), "rlib").unwrap();
        keep(&kept, &built).unwrap();
        let same = tree("same", "1");
        put_into(&kept, &same).unwrap();
        assert_eq!(fs::read_to_string(same.join("target/x")).unwrap(), "rlib");
        let other = tree("other", "2");
        put_into(&kept, &other).unwrap();
        assert!(!other.join("target").exists());
    }
}
