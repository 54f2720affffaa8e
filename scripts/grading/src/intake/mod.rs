//! Which submissions there are, and what is in them.

mod archive;
mod folder;
pub(crate) mod forbidden;
pub(crate) mod known_wrong;
pub(crate) mod names;
mod place;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};

use crate::escape::{cut, line};
use crate::record::LeftOut;
pub(crate) use folder::read;
use lab_kit::submission::{self, Collected, Sources, of_solution};
use lab_kit::{Kit, Lab};

/// Of the files that are not taken, so many are named.
pub(crate) const NAMED: usize = 100;

/// What was handed in.
#[derive(Debug, Default)]
pub(crate) struct HandedIn {
    /// By lab; a lab without any source is not there.
    pub(crate) labs: BTreeMap<Lab, Collected>,
    /// What belongs to no lab.
    pub(crate) left_out: Vec<(PathBuf, submission::LeftOut)>,
}

/// What of a submission is taken.
#[derive(Default)]
pub(crate) struct Intake {
    /// By path below the lab's folder.
    pub(crate) files: Sources,
    /// And what is not.
    pub(crate) left_out: Vec<LeftOut>,
}

/// Of the path of a file that is not taken, so many characters are shown.
const SHOWN: usize = 200;

/// What Gradescope puts into the folder of submissions that it exports.
const EXPORTED: &str = "submission_metadata.yml";

/// The submissions at a path: it is one, or a folder of many.
pub(crate) fn submissions(kit: &Kit, path: &Path) -> Result<Vec<PathBuf>> {
    ensure!(path.exists(), "there is no {}", path.display());
    if !path.is_dir() || own_solutions(kit, path) || path.join("labs").is_dir() {
        return Ok(vec![path.to_owned()]);
    }
    let (found, hidden) = listed(path)?;
    for path in hidden {
        eprintln!(
            "passed over, since its name begins with a dot: {}",
            line(&path.to_string_lossy())
        );
    }
    ensure!(!found.is_empty(), "{} holds no submissions", path.display());
    Ok(found)
}

/// What lies in a folder of submissions, and what of it is hidden.
fn listed(path: &Path) -> Result<(Vec<PathBuf>, Vec<PathBuf>)> {
    let entries = fs::read_dir(path).with_context(|| format!("cannot read {}", path.display()))?;
    let mut found = entries.map(|entry| Ok(entry?.path())).collect::<Result<Vec<_>>>()?;
    found.retain(|path| !path.ends_with(EXPORTED));
    found.sort();
    let hidden =
        |path: &PathBuf| path.file_name().is_some_and(|name| name.as_encoded_bytes()[0] == b'.');
    Ok(found.into_iter().partition(|path| !hidden(path)))
}

/// Takes in one submission.
///
/// # Errors
/// It is damaged, or no submission at all.
pub(crate) fn take(kit: &Kit, lab: Lab, path: &Path) -> Result<Intake> {
    if own_solutions(kit, path) {
        return Ok(Intake { files: of_solution(kit, lab)?, left_out: Vec::new() });
    }
    if let Some(wrong) = known_wrong::at(kit, lab, path)? {
        let files = wrong.in_solution(kit, lab)?;
        return Ok(Intake { files, left_out: Vec::new() });
    }
    let mut handed_in = read(path)?;
    let collected = handed_in.labs.remove(&lab).unwrap_or_default();
    let left_out = collected.left_out.into_iter().chain(handed_in.left_out);
    let left_out = left_out.map(|(path, why)| LeftOut {
        path: cut(&path.to_string_lossy(), SHOWN),
        reason: why.to_string(),
    });
    let is_folder_too = |path: &&String| {
        let mut folders =
            collected.files.keys().flat_map(|file| Path::new(file).ancestors().skip(1));
        folders.any(|folder| folder == Path::new(path))
    };
    if let Some(path) = collected.files.keys().find(is_folder_too) {
        bail!("{path} in it is a file and a folder");
    }
    Ok(Intake { files: collected.files, left_out: left_out.collect() })
}

/// Whether the path is the kit's own solutions. A link to them is not: it may lie in a class.
fn own_solutions(kit: &Kit, path: &Path) -> bool {
    let whole = |path: &Path| path.canonicalize().ok();
    !path.is_symlink()
        && whole(path).is_some_and(|path| Some(path) == whole(&kit.path("solutions")))
}

#[cfg(test)]
mod tests;
