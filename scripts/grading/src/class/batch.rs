//! A lab's submissions, several at a time, and where to go on after a stop.

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
use crate::escape::line;
use crate::record::{self, FORMAT, Record, Status};
use crate::roll::Roll;
use crate::sandbox::memory::Guard;
use crate::sandbox::{BUILD_QUOTA, Limits, Sandbox, room};
use crate::timing;
use lab_kit::machine::{cores, on_all_cores};
use lab_kit::progress::progress;
use lab_kit::{Kit, Lab, Workers};

/// Grades the submissions of a lab and leaves their records in `into`. A record is written whole or
/// not at all: who is killed half-way goes on where it was. Where nothing is left to be asked or
/// timed, nothing is built.
pub(crate) fn grade(
    kit: &Kit,
    lab: Lab,
    submissions: &[Named],
    into: &Path,
    options: &Options,
) -> Result<ExitCode> {
    let [run, build] = [options.limit, options.build_limit].map(Duration::from_secs);
    let loopback = kit.facts(lab)?.workers == Workers::Ranks;
    let limits = Limits { run, build, loopback };
    let sandbox = &Sandbox::find(kit, options.trusted, limits)?;
    room::make_for_records(into)?;
    let grader = Grader::new(kit, lab, options, sandbox, into)?;
    // What is wrong with it is better said now than when all are graded.
    Roll::read(into, &grader.rubric)?;
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

/// What is left to do.
struct Left<'a> {
    /// Submissions whose tasks are to be asked.
    open: Vec<&'a Named>,
    /// Submissions of which times are to be taken.
    untimed: Vec<&'a Named>,
}

impl<'a> Left<'a> {
    fn of(grader: &Grader<'_>, all: &'a [Named], into: &Path, options: &Options) -> Self {
        let times = !options.no_timing && grader.rubric.timed().next().is_some();
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

/// Where somebody's record is.
fn record_of(into: &Path, name: &str) -> PathBuf {
    into.join(format!("{name}.json"))
}

/// Builds and asks what is open and takes times, and returns whether all times could be taken.
fn work(grader: &Grader<'_>, left: &Left<'_>, all: usize, into: &Path) -> Result<bool> {
    let mut jobs = cores().min(left.open.len()).max(1);
    let _guard = Guard::set(jobs);
    eprintln!("Building the solution of lab {}, to compare with", grader.lab);
    // Seconds that go by until the solution is built.
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

/// How many trees there is room for on the disk that has the `first`.
///
/// # Errors
/// There is no room for a build.
fn fitting(sandbox: &Sandbox, first: &Tree) -> Result<usize> {
    room::expect(sandbox.scratch(), BUILD_QUOTA)?;
    let each = first.room()?;
    Ok(1 + ((room::free(sandbox.scratch())? - BUILD_QUOTA) / each) as usize)
}

/// Asks submissions about their tasks, in all trees at once, and returns the programs that
/// were built, by the submissions' names.
fn judge(
    grader: &Grader<'_>,
    reference: &Reference,
    trees: &Mutex<Vec<Tree>>,
    open: &[&Named],
    into: &Path,
    bar: &ProgressBar,
) -> Result<BTreeMap<String, TempDir>> {
    let work = |(name, path): &&Named| -> Result<Option<(String, TempDir)>> {
        let tree = taken(trees);
        let (record, program) = grader.grade(&tree, reference, name, path);
        trees.lock().expect("pushing does not panic").push(tree);
        record.write(into)?;
        done(bar, name, finish::summary(&record));
        Ok(program.map(|program| (name.clone(), program)))
    };
    on_all_cores(open, work).into_iter().filter_map(Result::transpose).collect()
}

/// One of the trees: there are as many as workers.
fn taken(trees: &Mutex<Vec<Tree>>) -> Tree {
    trees.lock().expect("popping does not panic").pop().expect("a tree for each worker")
}

/// A bar on a terminal for `of` submissions, of which nothing is left to do for `done`.
pub(crate) fn bar(what: &'static str, of: usize, done: usize) -> ProgressBar {
    let bar = progress(of as u64).with_position(done as u64).with_message(what);
    bar.tick();
    bar
}

/// One more submission is done, and this came of it: a line where there is no terminal.
pub(crate) fn done(bar: &ProgressBar, name: &str, said: impl Display) {
    // Held while it is written: lines come in the order of their numbers.
    let mut lines = stderr().lock();
    bar.inc(1);
    if bar.is_hidden() {
        let (at, of) = (bar.position(), bar.length().unwrap_or_default());
        // Where nobody can read it, grading goes on.
        let _ = writeln!(lines, "{}, {at} of {of}: {}: {said}", bar.message(), line(name));
    }
}

/// Whether nothing is left to be timed.
fn is_timed(grader: &Grader<'_>, record: &Path) -> bool {
    let record = record::read(record);
    record.is_ok_and(|record| timing::is_done_on(cores(), &record, &grader.rubric))
}

/// Whether a new judgement of this submission would be equal to its record.
fn is_judged(grader: &Grader<'_>, path: &Path, record: &Path, seed: Option<u64>) -> bool {
    let record =
        fs::read(record).ok().and_then(|text| serde_json::from_slice::<Record>(&text).ok());
    let Some(record) = record else { return false };
    let same = match grader.take(path) {
        Err(error) => {
            record.status == Status::Unreadable && record.message == grader.said(&error, path)
        }
        Ok(intake) if intake.files.is_empty() => record.status == Status::Empty,
        Ok(intake) => record.hash == hash(&intake.files),
    };
    let asked = |task: &String| record.tasks.iter().any(|asked| asked.id == *task);
    same && record.format == FORMAT
        && record.status != Status::Failed
        && grader.rubric.tasks.keys().all(asked)
        && record.grader == grader.hash
        && record.sandboxed == grader.sandbox.keeps
        && seed.is_none_or(|seed| seed == record.seed)
}
