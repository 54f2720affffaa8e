//! Grades one submission: asks its questions and writes its record.

use std::hash::{BuildHasher, RandomState};
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};
use tempfile::TempDir;

use super::{Named, Options};
use crate::asking::{Questions, TaskResult};
use crate::build::{Tree, graded_by};
use crate::record::{FORMAT, Findings, Marked, Record, Status, Task};
use crate::sandbox::Sandbox;
use crate::submission::{self, Submission, forbidden};
use crate::timing::{Compared, whole_program};
use lab_kit::Facts;
use lab_kit::escape::{cut, plain};
use lab_kit::files::{digest, write_file};
use lab_kit::machine::machine;
use lab_kit::rubric;
use lab_kit::sources::Sources;
use lab_kit::{Given, Kit, Lab};

/// Maximal number of characters that are kept of a message about a submission or a task.
const MESSAGE_LENGTH: usize = 4000;

/// Maximal number of characters that are kept of a task's output.
const PRINTED: usize = 1 << 16;

/// Settings and files for grading all submissions of a lab.
pub(crate) struct Grader<'a> {
    pub(crate) kit: &'a Kit,
    pub(crate) lab: Lab,
    pub(crate) rubric: Facts,
    pub(crate) sandbox: &'a Sandbox,
    /// Common seed of all submissions; `None` if each submission gets a random seed.
    seed: Option<u64>,
    given: Given,
    /// Folder that keeps the output of programs for the staff.
    printed: PathBuf,
    /// SHA-256 of questions and solution.
    pub(crate) hash: String,
    toolchain: String,
}

impl<'a> Grader<'a> {
    /// Reads the files that grading needs. Nothing is built.
    pub(crate) fn new(
        kit: &'a Kit,
        lab: Lab,
        options: &Options,
        sandbox: &'a Sandbox,
        into: &Path,
    ) -> Result<Self> {
        let rubric = rubric::read(kit, lab)?;
        rubric.warn(lab);
        let hash = hash(&graded_by(kit, lab)?);
        let version = Command::new("rustc").arg("--version").current_dir(kit.root()).output()?;
        let toolchain = String::from_utf8_lossy(&version.stdout).trim().to_owned();
        let given = Given::of(kit, lab)?;
        let printed = into.join("printed");
        let seed = options.seed;
        Ok(Self { kit, lab, rubric, sandbox, seed, given, printed, hash, toolchain })
    }

    /// Reads one submission.
    pub(crate) fn take(&self, path: &Path) -> Result<Submission> {
        submission::take(self.kit, self.lab, &self.given, path)
    }

    /// Returns a random seed, so that one student's questions do not help another student.
    fn seed(&self) -> u64 {
        self.seed.unwrap_or_else(|| RandomState::new().hash_one(()))
    }

    /// Asks the solution in `folder` all questions.
    pub(crate) fn questions(&self, folder: &Path) -> Result<Questions> {
        Questions::of(self.kit, self.lab, self.sandbox, folder, self.seed())
    }

    /// Shortens a message about the submission at `path`, and removes the names of this machine's
    /// folders, because students will read it.
    pub(crate) fn message(&self, text: &str, path: &Path) -> String {
        let class = path.parent().unwrap_or(path);
        let own = self.sandbox.folders().into_iter().chain([self.kit.root(), class]);
        // The longest folder comes first, because a folder may be inside another.
        let mut folders: Vec<String> = own.map(|folder| folder.display().to_string()).collect();
        folders.sort_by_key(|folder| std::cmp::Reverse(folder.len()));
        folders.retain(|folder| folder.len() > 1 && folder.starts_with('/'));
        let text = folders.iter().fold(text.to_owned(), |text, folder| {
            text.replace(&format!("{folder}/"), "").replace(folder, "")
        });
        cut(&text, MESSAGE_LENGTH)
    }

    /// Makes the record of a submission that has not been read yet.
    fn blank(&self, name: &str) -> Record {
        let found = Findings {
            format: FORMAT,
            name: name.to_owned(),
            lab: self.lab,
            grader: self.hash.clone(),
            seed: self.seed(),
            toolchain: self.toolchain.clone(),
            machine: machine(),
            sandboxed: self.sandbox.keeps,
            ..Findings::default()
        };
        let ids = self.rubric.tasks.keys().cloned();
        let tasks = ids.map(|id| Task { id, ..Task::default() }).collect();
        let out_of = self.rubric.tasks.values().map(|task| task.points).sum();
        Record { found, tasks, marked: Marked { out_of, ..Marked::default() } }
    }

    /// Grades a submission without timing it. Returns its record, and its programs if they were
    /// built.
    ///
    /// Every failure is written into the record, so the other submissions are still graded.
    pub(crate) fn grade(
        &self,
        tree: &Tree,
        reference: &Reference,
        (name, path): &Named,
    ) -> (Record, Option<TempDir>) {
        let mut record = self.blank(name);
        let end = match self.try_to_grade(&mut record, tree, reference, path) {
            Ok(Ok(folder)) => return (record, Some(folder)),
            Ok(Err(end)) => end,
            Err(error) => {
                record = self.blank(name);
                EarlyEnd { status: Status::Failed, message: format!("{error:#}") }
            }
        };
        record.found.status = end.status;
        record.found.message = self.message(&end.message, path);
        (record, None)
    }

    /// Grades a submission as [`Grader::grade`] does, and returns its programs. `record` is filled
    /// as far as grading got.
    ///
    /// # Errors
    /// If grading failed. The submission is not the cause.
    fn try_to_grade(
        &self,
        record: &mut Record,
        tree: &Tree,
        reference: &Reference,
        path: &Path,
    ) -> Result<Result<TempDir, EarlyEnd>> {
        let submission = match self.take(path) {
            Ok(submission) => submission,
            // If the system cannot read a submission, its contents may still be right.
            Err(error) if is_of_the_system(&error) => return Err(error),
            Err(error) => {
                let message = format!("{error:#}");
                return Ok(Err(EarlyEnd { status: Status::Unreadable, message }));
            }
        };
        let Record { found, tasks, .. } = record;
        found.left_out = submission.left_out;
        found.changed = submission.changed;
        if submission.files.is_empty() {
            let message = submission::nothing(self.lab, &found.left_out);
            return Ok(Err(EarlyEnd { status: Status::Empty, message }));
        }
        found.hash = hash(&submission.files);
        found.files =
            submission.files.iter().map(|(path, bytes)| (path.clone(), digest(bytes))).collect();
        if let Some(message) = forbidden::find(&submission.files) {
            return Ok(Err(EarlyEnd { status: Status::Refused, message }));
        }
        let folder = match tree.build(self.sandbox, &submission.files)? {
            Ok(folder) => folder,
            Err(message) => return Ok(Err(EarlyEnd { status: Status::NotBuilt, message })),
        };
        let questions = reference.questions.as_ref().context("the solution was not asked")?;
        let ids = tasks.iter().map(|task| task.id.as_str());
        let results = questions.ask(self.sandbox, folder.path(), ids, found.seed)?;
        self.write_results(results, tasks, &found.name, path)?;
        let compared = reference.compared_with(self.sandbox, &folder);
        whole_program::check(compared, &self.rubric, found.seed, tasks)?;
        Ok(Ok(folder))
    }

    /// Writes the results of asking into the tasks of submission `name`, and the output into files.
    fn write_results(
        &self,
        results: Vec<TaskResult>,
        tasks: &mut [Task],
        name: &str,
        path: &Path,
    ) -> Result<()> {
        for (task, result) in tasks.iter_mut().zip(results) {
            task.passed = result.wrong.is_none();
            task.share = result.share;
            task.message = self.message(&result.wrong.unwrap_or_default(), path);
            if !result.printed.trim().is_empty() {
                let path = self.printed.join(name).join(format!("{}.txt", task.id));
                write_file(&path, cut(&plain(&result.printed), PRINTED))?;
            }
        }
        Ok(())
    }
}

/// Reason why a submission has no programs that can be graded.
struct EarlyEnd {
    /// Stage that grading reached.
    status: Status,
    message: String,
}

/// The solution's programs, and the questions that the solution has answered.
pub(crate) struct Reference {
    pub(crate) programs: TempDir,
    /// The lab's questions; `None` if no answers are judged.
    pub(crate) questions: Option<Questions>,
}

impl Reference {
    /// Returns a submission's programs beside the solution's.
    pub(crate) fn compared_with<'a>(
        &'a self,
        sandbox: &'a Sandbox,
        own: &'a TempDir,
    ) -> Compared<'a> {
        Compared { sandbox, own: own.path(), solution: self.programs.path() }
    }
}

/// Whether the system refused an operation, such as reading a file.
fn is_of_the_system(error: &anyhow::Error) -> bool {
    let mut causes = error.chain().filter_map(|cause| cause.downcast_ref::<std::io::Error>());
    causes.any(|cause| cause.raw_os_error().is_some())
}

/// Returns the SHA-256 of sources and their paths.
pub(crate) fn hash(files: &Sources) -> String {
    let lines = files.iter().map(|(path, bytes)| format!("{} {path}\n", digest(bytes)));
    digest(lines.collect::<String>().as_bytes())
}
