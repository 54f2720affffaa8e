//! Finds submissions and reads their sources.

mod archive;
mod folder;
pub(crate) mod forbidden;
mod handed_in;
pub(crate) mod known_wrong;
mod loose;
pub(crate) mod names;

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};

use crate::record::LeftOut;
pub(crate) use folder::read;
use folder::{entries, unpacker};
use lab_kit::escape::{cut, line};
use lab_kit::sources::{Sources, of_solution};
use lab_kit::{Given, Kit, Lab};
use names::{ELSEWHERE, is_macos};

/// Beginning of the reason for omitting a file that has a task but is in the wrong folder.
const MISPLACED: &str = "it is not in";

/// The part of a submission that the grader uses.
#[derive(Default)]
pub(crate) struct Submission {
    /// Sources by path below the lab's folder; empty if there is no file with a task.
    ///
    /// The sources include the kit's provided files.
    pub(crate) files: Sources,
    /// Files that are left out.
    pub(crate) left_out: Vec<LeftOut>,
    /// Provided files that the student changed.
    pub(crate) changed: Vec<String>,
}

/// Maximal number of characters that are shown of an omitted file's path.
const SHOWN: usize = 200;

/// Lists the submissions at several paths.
pub(crate) fn list_all(kit: &Kit, paths: &[PathBuf]) -> Result<Vec<PathBuf>> {
    let lists = paths.iter().map(|path| list(kit, path));
    Ok(lists.collect::<Result<Vec<_>>>()?.concat())
}

/// Lists the submissions at a path, which is a submission or a folder of submissions.
fn list(kit: &Kit, path: &Path) -> Result<Vec<PathBuf>> {
    ensure!(path.exists(), "there is no {}", path.display());
    let known_wrong = known_wrong::on_page(kit, path)?;
    if !known_wrong.is_empty() {
        return Ok(known_wrong);
    }
    if !path.is_dir() {
        let unlike = "is neither a folder nor an archive (.tar.gz, .tar.xz, .tar.bz2, .tar, .zip)";
        ensure!(unpacker(path).is_some(), "{} {unlike}", path.display());
        return Ok(vec![path.to_owned()]);
    }
    if own_solutions(kit, path) {
        return Ok(vec![path.to_owned()]);
    }
    let (found, hidden) = listed(path)?;
    if path.join("labs").is_dir() {
        let archives = found.iter().filter(|path| unpacker(path).is_some()).count();
        ensure!(
            archives == 0,
            "{} has labs/ in it, as a submission has, and beside it {archives} with an archive's name. If it is \
             a class, put labs/ into a folder of its own; if it is a submission, name one archive or take them out",
            path.display()
        );
        return Ok(vec![path.to_owned()]);
    }
    for path in hidden {
        let why = if is_macos(&path) { "macOS made it" } else { "its name begins with a dot" };
        eprintln!("passed over, since {why}: {}", line(&path.to_string_lossy()));
    }
    ensure!(!found.is_empty(), "{} holds no submissions", path.display());
    Ok(found)
}

/// Lists the entries of a folder of submissions: the submissions, and hidden entries.
fn listed(path: &Path) -> Result<(Vec<PathBuf>, Vec<PathBuf>)> {
    let found = entries(path).with_context(|| format!("cannot read {}", path.display()));
    let mut found = found?;
    found.retain(|path| !is_about_the_class(path));
    Ok(found.into_iter().partition(|path| !is_dotted(path) && !is_macos(path)))
}

/// Whether a file contains information about the class, and is not a submission.
fn is_about_the_class(path: &Path) -> bool {
    path.ends_with(names::CLASS)
        || path.ends_with(names::METADATA)
        || path.extension().is_some_and(|end| end == "csv")
}

/// Whether the name of a file begins with a dot.
fn is_dotted(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name.as_encoded_bytes()[0] == b'.')
}

/// Reads a submission.
///
/// # Errors
/// If it is damaged or is not a submission.
pub(crate) fn take(kit: &Kit, lab: Lab, given: &Given, path: &Path) -> Result<Submission> {
    if own_solutions(kit, path) {
        return Ok(Submission { files: of_solution(kit, lab)?, ..Submission::default() });
    }
    if let Some(wrong) = known_wrong::at(kit, lab, path)? {
        return Ok(Submission { files: wrong.in_solution(kit, lab)?, ..Submission::default() });
    }
    let mut handed_in = read(path)?;
    let mut files = handed_in.labs.remove(&lab).unwrap_or_default();
    if !given.tasks.iter().any(|task| files.contains_key(task)) {
        let (placed, from) = loose::place(lab, &given.tasks, &handed_in.loose);
        files = placed;
        handed_in.left_out.retain(|(path, _)| !from.contains(path));
    }
    let left_out = handed_in.left_out.into_iter().map(|(path, why)| LeftOut {
        path: cut(&path.to_string_lossy(), SHOWN),
        reason: if why == ELSEWHERE && is_misplaced(given, &path) {
            format!("{MISPLACED} labs/lab{lab}/src")
        } else {
            why.to_owned()
        },
    });
    let left_out = left_out.collect();
    if !given.tasks.iter().any(|task| files.contains_key(task)) {
        return Ok(Submission { left_out, ..Submission::default() });
    }
    let changed = given.put(&mut files);
    for file in files.keys() {
        let mut folders = Path::new(file).ancestors().skip(1).filter_map(Path::to_str);
        if let Some(path) = folders.find(|folder| files.contains_key(*folder)) {
            bail!("{path} in it is a file and a folder");
        }
    }
    Ok(Submission { files, left_out, changed })
}

/// Reads the sources of a submission that is to be built outside a grading.
///
/// # Errors
/// If it has no file with a task, or contains forbidden code.
pub(crate) fn buildable(kit: &Kit, lab: Lab, given: &Given, path: &Path) -> Result<Sources> {
    let submission = take(kit, lab, given, path)?;
    ensure!(!submission.files.is_empty(), "{}", nothing(lab, &submission.left_out));
    match forbidden::find(&submission.files) {
        Some(why) => bail!("{why}"),
        None => Ok(submission.files),
    }
}

/// Whether a file outside labs/ has the name of a file with a task.
fn is_misplaced(given: &Given, path: &Path) -> bool {
    let name = path.file_name();
    let is_task = given.tasks.iter().any(|task| Path::new(task).file_name() == name);
    is_task && !path.iter().any(|part| part == "labs")
}

/// Whether a submission has sources of a lab.
pub(crate) fn holds(kit: &Kit, lab: Lab, path: &Path) -> Result<bool> {
    if own_solutions(kit, path) || known_wrong::at(kit, lab, path)?.is_some() {
        return Ok(true);
    }
    Ok(read(path)?.labs.contains_key(&lab))
}

/// Returns the message about a submission that has no file with a task. The message names a similar
/// file if there is one.
pub(crate) fn nothing(lab: Lab, left_out: &[LeftOut]) -> String {
    let other = left_out
        .iter()
        .find(|left| is_similar(lab, left))
        .map(|left| format!(", but {}", left.path));
    format!(
        "there is no task's file in a folder labs/lab{lab}/src in it{}. 'cargo lab submit {lab}' packs it as it \
         must be; or put the lab's folder into one called labs, and pack that",
        other.unwrap_or_default()
    )
}

/// Whether a file that is left out may be a source of the lab.
fn is_similar(lab: Lab, left: &LeftOut) -> bool {
    let mut parts = left.path.split(['/', '\\']);
    let leads = parts.any(|part| part == "src" || part == format!("lab{lab}"));
    leads || left.reason.starts_with(MISPLACED)
}

/// Whether the path leads to the kit's own solutions.
///
/// A symbolic link to the solutions is not followed, because a student may have submitted the link.
fn own_solutions(kit: &Kit, path: &Path) -> bool {
    let solutions = kit.path("solutions").canonicalize().ok();
    !path.is_symlink() && solutions.is_some() && path.canonicalize().ok() == solutions
}

#[cfg(test)]
mod archive_tests;
#[cfg(test)]
mod packed;
