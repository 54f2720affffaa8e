//! Which submissions there are, and what is in them.

mod archive;
mod folder;
pub(crate) mod known_wrong;
pub(crate) mod names;
mod place;
pub(crate) mod solution;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};

use crate::record::LeftOut;
pub(crate) use folder::read;
use lab_kit::submission::{self, Collected, Sources};
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

/// What Gradescope puts into the folder of submissions that it exports.
const EXPORTED: &str = "submission_metadata.yml";

/// The submissions at a path: it is one, or a folder of many.
pub(crate) fn submissions(kit: &Kit, path: &Path) -> Result<Vec<PathBuf>> {
    ensure!(path.exists(), "there is no {}", path.display());
    if !path.is_dir() || own_solutions(kit, path) || path.join("labs").is_dir() {
        return Ok(vec![path.to_owned()]);
    }
    let entries = fs::read_dir(path).with_context(|| format!("cannot read {}", path.display()))?;
    let mut found = entries.map(|entry| Ok(entry?.path())).collect::<Result<Vec<_>>>()?;
    found.retain(|path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        !name.starts_with('.') && name != EXPORTED
    });
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
        return Ok(Intake { files: solution::solution(kit, lab)?, left_out: Vec::new() });
    }
    if let Some(wrong) = known_wrong::at(kit, lab, path)? {
        let files = known_wrong::sources(kit, lab, &wrong)?;
        return Ok(Intake { files, left_out: Vec::new() });
    }
    let mut handed_in = read(path)?;
    let collected = handed_in.labs.remove(&lab).unwrap_or_default();
    let left_out = collected.left_out.into_iter().chain(handed_in.left_out);
    let left_out = left_out
        .map(|(path, why)| LeftOut { path: path.display().to_string(), reason: why.to_string() });
    Ok(Intake { files: collected.files, left_out: left_out.collect() })
}

fn own_solutions(kit: &Kit, path: &Path) -> bool {
    let whole = |path: &Path| path.canonicalize().ok();
    whole(path).is_some_and(|path| Some(path) == whole(&kit.path("solutions")))
}
