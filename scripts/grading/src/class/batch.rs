//! Grades a lab's submissions, several at a time, and continues after an interruption.

use std::collections::BTreeMap;
use std::fmt::Display;
use std::fs;
use std::io::{Write, stderr};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;
use std::time::Duration;

use anyhow::Result;
use indicatif::{ProgressBar, ProgressStyle};
use tempfile::TempDir;

use super::grader::{Grader, Reference, hash};
use super::{Named, Options, finish};
use crate::build::Tree;
use crate::record::{self, FORMAT, Record, Status};
use crate::roster::ClassFile;
use crate::sandbox::memory_guard::Guard;
use crate::sandbox::{BUILD_QUOTA, Limits, Sandbox, room};
use crate::timing;
use lab_kit::escape::line;
use lab_kit::machine::{cores, on_all_cores};
use lab_kit::progress::progress;
use lab_kit::{Kit, Lab, Workers};

/// Grades the submissions of a lab and writes their records into `into`.
///
/// A record is written completely or not at all, so a grading run that was interrupted can resume
/// where it stopped. If every submission has already been judged and timed, nothing is built.
pub(crate) fn grade(
    kit: &Kit,
    lab: Lab,
    submissions: &[Named],
    into: &Path,
    options: &Options,
) -> Result<ExitCode> {
    let limits = Limits {
        run: Duration::from_secs(options.limit),
        build: Duration::from_secs(options.build_limit),
        loopback: kit.facts(lab)?.workers == Workers::Ranks,
    };
    let sandbox = &Sandbox::find(kit, options.trusted, limits)?;
    room::make_for_records(into)?;
    let grader = Grader::new(kit, lab, options, sandbox, into)?;
    // Report a mistake in `class.toml` before grading, not after it.
    ClassFile::read(into, &grader.rubric)?;
    let left = Left::of(&grader, submissions, into, options);
    if options.seed.is_some() && left.open.iter().any(|(name, _)| !record_of(into, name).exists()) {
        eprintln!(
            "--seed: letters name it, so who has read one knows what is asked. Leave it out for a first grading"
        );
    }
    let mut all_timed = true;
    if !left.open.is_empty() || !left.untimed.is_empty() {
        all_timed = work(&grader, &left, submissions.len(), into)?;
    }
    let ended = finish::finish(&grader, submissions, into)?;
    println!("Records: {}", into.display());
    Ok(if all_timed { ended } else { ExitCode::FAILURE })
}

/// Submissions that are not finished yet.
struct Left<'a> {
    /// Submissions whose tasks must be judged.
    open: Vec<&'a Named>,
    /// Submissions that must be timed.
    untimed: Vec<&'a Named>,
}

impl<'a> Left<'a> {
    fn of(grader: &Grader<'_>, all: &'a [Named], into: &Path, options: &Options) -> Self {
        let rubric = &grader.rubric;
        let has_times = rubric.timed().next().is_some() || rubric.has_contest();
        let times = !options.no_timing && has_times;
        let mut left = Self { open: Vec::new(), untimed: Vec::new() };
        for submission in all {
            let (name, path) = submission;
            let record = record_of(into, name);
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
}

/// Returns the path of a submission's record.
fn record_of(into: &Path, name: &str) -> PathBuf {
    into.join(format!("{name}.json"))
}

/// Builds, judges and times the remaining submissions. Returns whether all could be timed.
fn work(grader: &Grader<'_>, left: &Left<'_>, all: usize, into: &Path) -> Result<bool> {
    let mut jobs = cores().min(left.open.len()).max(1);
    let _guard = Guard::set(jobs);
    eprintln!("Building the solution of lab {}, to compare with", grader.lab);
    // Shows the seconds that pass while the solution is built.
    let clock = progress(0).with_style(ProgressStyle::with_template("{spinner} {elapsed}")?);
    clock.enable_steady_tick(Duration::from_secs(1));
    let first = Tree::lay(grader.kit, grader.lab, grader.sandbox)?;
    let reference = Reference::build(grader, &first, !left.open.is_empty())?;
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
    finish::time(grader, &reference, &tree, &left.untimed, into, programs)
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
    let programs = on_all_cores(open, |(name, path)| {
        let tree = taken(trees);
        let (record, program) = grader.grade(&tree, reference, name, path);
        trees.lock().expect("pushing does not panic").push(tree);
        record.write(into)?;
        done(bar, name, finish::summary(&record));
        Ok(program.map(|program| (name.clone(), program)))
    });
    programs.into_iter().filter_map(Result::transpose).collect()
}

/// Takes one of the trees. A tree is always free, because there are as many trees as workers.
fn taken(trees: &Mutex<Vec<Tree>>) -> Tree {
    trees.lock().expect("popping does not panic").pop().expect("a tree for each worker")
}

/// Makes a progress bar for `of` submissions. The first `done` of them are finished already.
pub(crate) fn bar(what: &'static str, of: usize, done: usize) -> ProgressBar {
    let bar = progress(of as u64).with_position(done as u64).with_message(what);
    bar.tick();
    bar
}

/// Advances the bar by one submission. Without a terminal, it prints a line with the result
/// instead.
pub(crate) fn done(bar: &ProgressBar, name: &str, outcome: impl Display) {
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
    let record =
        fs::read(record).ok().and_then(|text| serde_json::from_slice::<Record>(&text).ok());
    let Some(record) = record else { return false };
    let same = match grader.take(path) {
        Err(error) => {
            record.found.status == Status::Unreadable
                && record.found.message == grader.message_of(&error, path)
        }
        Ok(submission) if submission.files.is_empty() => record.found.status == Status::Empty,
        Ok(submission) => record.found.hash == hash(&submission.files),
    };
    same && record.found.format == FORMAT
        && record.found.status != Status::Failed
        && grader.rubric.tasks.keys().all(|id| record.tasks.iter().any(|task| task.id == *id))
        && record.found.grader == grader.hash
        && record.found.sandboxed == grader.sandbox.keeps
        && seed.is_none_or(|seed| seed == record.found.seed)
}
