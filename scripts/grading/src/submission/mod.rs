//! Finds submissions and reads their sources.

mod archive;
mod folder;
pub(crate) mod forbidden;
pub(crate) mod known_wrong;
mod loose;
pub(crate) mod names;

use std::collections::BTreeMap;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};

use crate::record::LeftOut;
use crate::roster;
pub(crate) use folder::read;
use folder::{entries, unpacker};
use lab_kit::escape::{cut, line};
use lab_kit::sources::{COUNT_LIMIT, FILE_LIMIT, NOT_PLAIN, Sources, TOO_LARGE, of_solution};
use lab_kit::{Given, Kit, Lab};
use loose::Loose;
use names::{ELSEWHERE, is_called_archive, is_macos, resolve};

/// Beginning of the reason for omitting a file that has a task but is in the wrong folder.
const MISPLACED: &str = "it is not in";

/// Maximal number of omitted files whose names are shown.
pub(crate) const NAMED: usize = 100;

/// Contents of a submission.
#[derive(Debug, Default)]
pub(crate) struct HandedIn {
    /// Sources by lab. Labs without any source are missing.
    pub(crate) labs: BTreeMap<Lab, Sources>,
    /// Files that are left out, with the reasons.
    pub(crate) left_out: Vec<(PathBuf, &'static str)>,
    /// Files in other folders that may be sources. They are left out too, unless they are the lab's
    /// only files.
    loose: Vec<Loose>,
    /// Archives inside this archive.
    archives: Vec<Vec<u8>>,
}

impl HandedIn {
    /// Adds a file if it is a source of a lab. Returns the number of bytes read.
    fn add<R: Read>(
        &mut self,
        path: &Path,
        plain: bool,
        size: u64,
        open: impl FnOnce() -> io::Result<R>,
    ) -> Result<u64> {
        if is_macos(path) {
            return Ok(0);
        }
        let source = if plain { resolve(path) } else { Err(NOT_PLAIN) };
        let source =
            source.and_then(|found| if size > FILE_LIMIT { Err(TOO_LARGE) } else { Ok(found) });
        let may_count = source == Err(ELSEWHERE) && size <= FILE_LIMIT;
        let is_loose = may_count && loose::may_be(path);
        let is_archive = may_count && is_called_archive(path);
        if let Err(why) = source {
            self.leave_out(path, why);
        }
        let kept = self.loose.len() + self.archives.len();
        if source.is_err() && (!(is_loose || is_archive) || kept >= COUNT_LIMIT) {
            return Ok(0);
        }
        let mut bytes = Vec::new();
        // The size in an archive may be wrong, so the file itself is limited.
        open()?.take(FILE_LIMIT + 1).read_to_end(&mut bytes)?;
        let read = bytes.len() as u64;
        if read > FILE_LIMIT {
            self.leave_out(path, TOO_LARGE);
            return Ok(read);
        }
        let Ok((lab, below)) = source else {
            if is_archive {
                self.archives.push(bytes);
            } else {
                self.loose.push((path.to_owned(), bytes));
            }
            return Ok(read);
        };
        let files = self.labs.entry(lab).or_default();
        ensure!(files.len() < COUNT_LIMIT, "there are more than {COUNT_LIMIT} files in it");
        let twice = files.insert(below, bytes).is_some();
        ensure!(!twice, "{} is in it twice", path.display());
        Ok(read)
    }

    fn leave_out(&mut self, path: &Path, why: &'static str) {
        if self.left_out.len() < NAMED {
            self.left_out.push((path.to_owned(), why));
        }
    }
}

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
    roster::FILES.iter().any(|name| path.ends_with(name))
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
