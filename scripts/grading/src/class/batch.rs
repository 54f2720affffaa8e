//! Judges a lab's submissions, several at a time, then times them while nothing else runs.
//!
//! After an interruption, only the submissions that are left are judged and timed.

use std::collections::BTreeMap;
use std::fmt::Display;
use std::io::{Write, stderr};
use std::path::Path;
use std::sync::Mutex;
use std::time::Duration;

use anyhow::{Result, anyhow};
use indicatif::{ProgressBar, ProgressStyle};
use tempfile::TempDir;

use super::grader::{Grader, Reference, hash};
use super::{Named, Options, summary};
use crate::build::Tree;
use crate::record::{self, Findings, Status};
use crate::sandbox::memory_guard::Guard;
use crate::sandbox::{BUILD_QUOTA, Sandbox, room};
use crate::score::score;
use crate::timing;
use crate::timing::contest::ClassContest;
use lab_kit::escape::line;
use lab_kit::machine::{cores, on_all_cores};
use lab_kit::progress::progress;

/// Submissions that are not finished yet.
pub(super) struct Left<'a> {
    /// Submissions whose tasks must be judged.
    pub(super) open: Vec<&'a Named>,
    /// Submissions that must be timed.
    untimed: Vec<&'a Named>,
}

impl<'a> Left<'a> {
    pub(super) fn of(
        grader: &Grader<'_>,
        all: &'a [Named],
        into: &Path,
        options: &Options,
    ) -> Self {
        let rubric = &grader.rubric;
        let has_times = rubric.timed().next().is_some() || rubric.has_contest();
        let times = !options.no_timing && has_times;
        let mut left = Self { open: Vec::new(), untimed: Vec::new() };
        for submission in all {
            let (name, path) = submission;
            let record = record::path(into, name);
            let judged = !options.again && is_judged(grader, path, &record, options.seed);
            if !judged {
                left.open.push(submission);
            }
            if times && !(judged && is_timed(grader, &record)) {
                left.untimed.push(submission);
            }
        }
        left
    }

    /// Whether every submission is finished.
    pub(super) fn is_empty(&self) -> bool {
        self.open.is_empty() && self.untimed.is_empty()
    }
}

/// Builds, judges and times the remaining submissions. Returns whether all could be timed.
pub(super) fn work(grader: &Grader<'_>, left: &Left<'_>, all: usize, into: &Path) -> Result<bool> {
    let mut jobs = cores().min(left.open.len()).max(1);
    let _guard = Guard::set(jobs);
    eprintln!("Building the solution of lab {}, to compare with", grader.lab);
    // Shows the seconds that pass while the solution is built.
    let clock = progress(0).with_style(ProgressStyle::with_template("{spinner} {elapsed}")?);
    clock.enable_steady_tick(Duration::from_secs(1));
    let first = Tree::lay(grader.kit, grader.lab, grader.sandbox)?;
    let programs = first.reference(grader.kit, grader.sandbox)?;
    let mut questions = None;
    if !left.open.is_empty() {
        questions = Some(grader.questions(programs.path())?);
    }
    let reference = Reference { programs, questions };
    clock.finish_and_clear();
    jobs = jobs.min(fitting(grader.sandbox, &first)?);
    let mut trees = vec![first];
    for _ in 1..jobs {
        trees.push(trees[0].copy(grader.sandbox)?);
    }
    let bar = bar("tasks", all, all - left.open.len());
    let trees = Mutex::new(trees);
    let programs = judge(grader, &reference, &trees, &left.open, into, &bar)?;
    bar.finish_and_clear();
    let tree = taken(&trees);
    time(grader, &reference, &tree, &left.untimed, into, programs)
}

/// Returns the number of trees that fit on the disk, including `first`.
///
/// # Errors
/// If there is no space for a build.
fn fitting(sandbox: &Sandbox, first: &Tree) -> Result<usize> {
    room::expect(sandbox.scratch(), BUILD_QUOTA)?;
    let each = first.room()?;
    Ok(1 + ((room::free(sandbox.scratch())? - BUILD_QUOTA) / each) as usize)
}

/// Judges the tasks of submissions, in all trees at once. Returns the built programs by submission
/// name.
fn judge(
    grader: &Grader<'_>,
    reference: &Reference,
    trees: &Mutex<Vec<Tree>>,
    open: &[&Named],
    into: &Path,
    bar: &ProgressBar,
) -> Result<BTreeMap<String, TempDir>> {
    let programs = on_all_cores(open, |submission| {
        let tree = taken(trees);
        let (record, program) = grader.grade(&tree, reference, submission);
        trees.lock().expect("pushing does not panic").push(tree);
        record.write(into)?;
        done(bar, &record.found.name, summary::of_tasks(&record));
        Ok(program.map(|program| (record.found.name, program)))
    });
    programs.into_iter().filter_map(Result::transpose).collect()
}

/// Takes one of the trees. A tree is always free, because there are as many trees as workers.
fn taken(trees: &Mutex<Vec<Tree>>) -> Tree {
    trees.lock().expect("popping does not panic").pop().expect("a tree for each worker")
}

/// Times one submission after another. Returns whether all could be timed.
///
/// `programs` contains the programs of submissions that were judged just now. The programs of other
/// submissions are built again in `tree`.
fn time(
    grader: &Grader<'_>,
    reference: &Reference,
    tree: &Tree,
    untimed: &[&Named],
    into: &Path,
    mut programs: BTreeMap<String, TempDir>,
) -> Result<bool> {
    let mut contest = None;
    let bar = bar("times", untimed.len(), 0);
    let mut all = true;
    for (name, path) in untimed {
        let mut record = record::read(&record::path(into, name))?;
        let program = programs.remove(name);
        let program = match program {
            None if record.found.status == Status::Graded => build(grader, tree, path).map(Some),
            program => Ok(program),
        };
        let taken = program.and_then(|program| {
            time_one(grader, reference, &mut contest, program, &mut record.found)
        });
        if taken.is_err() {
            // The next grading run times this submission again.
            (record.found.timed, record.found.contest) = (false, None);
            record.found.runs.clear();
            all = false;
        }
        score(&mut record, &grader.rubric)?;
        record.write(into)?;
        done(
            &bar,
            name,
            taken.map_or_else(|error| format!("{error:#}"), |()| summary::of_times(&record)),
        );
    }
    bar.finish_and_clear();
    Ok(all)
}

/// Times the programs of a submission; `None` if it has no programs. If the submission is the class's
/// first entry in a contest, the function also draws the scenes of the `contest`.
fn time_one(
    grader: &Grader<'_>,
    reference: &Reference,
    contest: &mut Option<ClassContest>,
    program: Option<TempDir>,
    found: &mut Findings,
) -> Result<()> {
    found.timed = true;
    let Some(own) = program else { return Ok(()) };
    let compared = reference.compared_with(grader.sandbox, &own);
    if !grader.rubric.has_contest() {
        return timing::time(compared, found, &grader.rubric);
    }
    let contest = match contest.take() {
        Some(drawn) => contest.insert(drawn),
        None => contest.insert(ClassContest::draw()?),
    };
    contest.enter(compared, found)
}

/// Builds the programs of a submission that was graded in an earlier run.
fn build(grader: &Grader<'_>, tree: &Tree, path: &Path) -> Result<TempDir> {
    let submission = grader.take(path)?;
    let built = tree.build(grader.sandbox, &submission.files)?;
    built.map_err(|why| anyhow!("it was graded, and cannot be built now: {why}"))
}

/// Makes a progress bar for `of` submissions. The first `done` of them are finished already.
fn bar(what: &'static str, of: usize, done: usize) -> ProgressBar {
    let bar = progress(of as u64).with_position(done as u64).with_message(what);
    bar.tick();
    bar
}

/// Advances the bar by one submission. Without a terminal, it prints a line with the result
/// instead.
fn done(bar: &ProgressBar, name: &str, outcome: impl Display) {
    // The lock is held while the line is written, so lines appear in the order of their numbers.
    let mut lines = stderr().lock();
    bar.inc(1);
    if bar.is_hidden() {
        let at = bar.position();
        let of = bar.length().unwrap_or_default();
        // If stderr is closed, grading continues.
        let _ = writeln!(lines, "{}, {at} of {of}: {}: {outcome}", bar.message(), line(name));
    }
}

/// Whether nothing is left to be timed.
fn is_timed(grader: &Grader<'_>, record: &Path) -> bool {
    let record = record::read(record);
    record.is_ok_and(|record| timing::is_done_on(cores(), &record.found, &grader.rubric))
}

/// Whether judging this submission again would give the same record.
fn is_judged(grader: &Grader<'_>, path: &Path, record: &Path, seed: Option<u64>) -> bool {
    let Ok(record) = record::read(record) else { return false };
    let same = match grader.take(path) {
        Err(error) => {
            record.found.status == Status::Unreadable
                && record.found.message == grader.message(&format!("{error:#}"), path)
        }
        Ok(submission) if submission.files.is_empty() => record.found.status == Status::Empty,
        Ok(submission) => record.found.hash == hash(&submission.files),
    };
    same && record.found.status != Status::Failed
        && grader.rubric.tasks.keys().all(|id| record.tasks.iter().any(|task| task.id == *id))
        && record.found.grader == grader.hash
        && record.found.sandboxed == grader.sandbox.keeps
        && seed.is_none_or(|seed| seed == record.found.seed)
}
