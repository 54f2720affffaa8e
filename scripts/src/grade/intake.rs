//! Which submissions there are, and what is in them.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};

use super::record::LeftOut;
use super::tree;
use crate::kit::{Kit, Lab};
use crate::submission::{self, Sources};

/// What of a submission is taken.
#[derive(Default)]
pub(crate) struct Intake {
    /// By path below the lab's folder.
    pub(crate) files: Sources,
    /// And what is not.
    pub(crate) left_out: Vec<LeftOut>,
}

/// The submissions at a path: it is one, or a folder of many.
pub(crate) fn submissions(kit: &Kit, path: &Path) -> Result<Vec<PathBuf>> {
    ensure!(path.exists(), "there is no {}", path.display());
    if !path.is_dir() || own_solutions(kit, path) || path.join("labs").is_dir() {
        return Ok(vec![path.to_owned()]);
    }
    let entries = fs::read_dir(path).with_context(|| format!("cannot read {}", path.display()))?;
    let mut found = entries.map(|entry| Ok(entry?.path())).collect::<Result<Vec<_>>>()?;
    found.retain(|path| !path.file_name().unwrap_or_default().to_string_lossy().starts_with('.'));
    found.sort();
    ensure!(!found.is_empty(), "{} holds no submissions", path.display());
    Ok(found)
}

/// Takes in one submission.
///
/// # Errors
/// It is damaged, or no submission at all.
pub(crate) fn take(kit: &Kit, lab: Lab, path: &Path) -> Result<Intake> {
    if own_solutions(kit, path) {
        return Ok(Intake { files: tree::solution(kit, lab)?, left_out: Vec::new() });
    }
    let link = fs::symlink_metadata(path).is_ok_and(|metadata| metadata.is_symlink());
    ensure!(!link, "it is a symbolic link");
    let folder = path.join(format!("labs/lab{lab}"));
    let linked = |path: &Path| fs::symlink_metadata(path).is_ok_and(|m| m.is_symlink());
    let above = [path.join("labs"), folder.clone(), folder.join("src")];
    ensure!(!above.iter().any(|path| linked(path)), "a folder in it is a symbolic link");
    if folder.is_dir() {
        let collected = submission::collect(&folder)?;
        let left_out = collected.left_out.into_iter().map(|(path, why)| LeftOut {
            path: path.display().to_string(),
            reason: why.to_string(),
        });
        return Ok(Intake { files: collected.files, left_out: left_out.collect() });
    }
    let files = submission::read(path)?.remove(&lab).unwrap_or_default();
    Ok(Intake { files, left_out: Vec::new() })
}

fn own_solutions(kit: &Kit, path: &Path) -> bool {
    let whole = |path: &Path| path.canonicalize().ok();
    whole(path).is_some_and(|path| Some(path) == whole(&kit.path("solutions")))
}
