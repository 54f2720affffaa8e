//! A lab's submissions, several at a time, and where to go on after a stop.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::ExitCode;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use anyhow::Result;
use tempfile::TempDir;

use super::grader::{Grader, Reference, hash, said};
use super::progress::{Progress, clock};
use super::{Named, Options, finish};
use crate::build::Tree;
use crate::record::{FORMAT, Record, Status};
use crate::roll::Roll;
use crate::sandbox::memory::Guard;
use crate::sandbox::{Limits, Sandbox};
use lab_kit::machine::cores;
use lab_kit::{Kit, Lab};

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
    let sandbox = &Sandbox::find(kit, options.trusted, Limits { run, build })?;
    let grader = Grader::new(kit, lab, options, sandbox, into)?;
    // What is wrong with it is better said now than when all are graded.
    Roll::read(into, &grader.rubric)?;
    let record_of = |name: &str| into.join(format!("{name}.json"));
    let times = !options.no_timing && grader.rubric.timed().next().is_some();
    let (mut open, mut untimed) = (Vec::new(), Vec::new());
    for submission in submissions {
        let (name, path) = submission;
        let judged = !options.again && is_judged(&grader, path, &record_of(name), options.seed);
        if !judged {
            open.push(submission);
        }
        if times && (!judged || finish::is_untimed(&grader, &record_of(name))) {
            untimed.push(submission);
        }
    }
    let is_new = |(name, _): &&Named| !record_of(name).exists();
    if options.seed.is_some() && open.iter().copied().any(|submission| is_new(&submission)) {
        eprintln!(
            "--seed: letters name it, so who has read one knows what is asked. Leave it out for a first grading"
        );
    }
    if !open.is_empty() || !untimed.is_empty() {
        let jobs = options.jobs.unwrap_or_else(cores).min(open.len()).max(1);
        let _guard = Guard::set(jobs);
        eprintln!("Building the solution of lab {lab}, to compare with");
        let clock = clock();
        let mut trees = vec![Tree::lay(kit, lab, sandbox)?];
        let reference = Reference::build(&grader, &trees[0], !open.is_empty())?;
        clock.finish_and_clear();
        for _ in 1..jobs {
            trees.push(trees[0].copy(sandbox)?);
        }
        let progress = Progress::begin("tasks", submissions.len(), submissions.len() - open.len());
        let programs = judge(&grader, &reference, &trees, &open, into, &progress)?;
        progress.end();
        finish::time(&grader, &reference, &trees[0], &untimed, into, programs)?;
    }
    let ended = finish::finish(&grader, submissions, into)?;
    println!("Records: {}", into.display());
    Ok(ended)
}

/// Asks submissions about their tasks, in all trees at once, and returns the programs that
/// were built, by the submissions' names.
fn judge(
    grader: &Grader<'_>,
    reference: &Reference,
    trees: &[Tree],
    open: &[&Named],
    into: &Path,
    progress: &Progress,
) -> Result<BTreeMap<String, TempDir>> {
    let next = AtomicUsize::new(0);
    let work = |tree: &Tree| -> Result<Vec<(String, TempDir)>> {
        let mut programs = Vec::new();
        while let Some((name, path)) = open.get(next.fetch_add(1, Ordering::Relaxed)) {
            let (record, program) = grader.grade(tree, reference, name, path);
            record.write(into)?;
            programs.extend(program.map(|program| (name.clone(), program)));
            progress.done(name, finish::summary(&record));
        }
        Ok(programs)
    };
    thread::scope(|scope| {
        let work = &work;
        let workers: Vec<_> = trees.iter().map(|tree| scope.spawn(move || work(tree))).collect();
        let mut programs = BTreeMap::new();
        for worker in workers {
            programs.extend(worker.join().expect("grading does not panic")?);
        }
        Ok(programs)
    })
}

/// Whether a new judgement of this submission would be equal to its record.
fn is_judged(grader: &Grader<'_>, path: &Path, record: &Path, seed: Option<u64>) -> bool {
    let record =
        fs::read(record).ok().and_then(|text| serde_json::from_slice::<Record>(&text).ok());
    let Some(record) = record else { return false };
    let same = match grader.take(path) {
        Err(error) => record.status == Status::Unreadable && record.message == said(&error),
        Ok(intake) if intake.files.is_empty() => record.status == Status::Empty,
        Ok(intake) => record.hash == hash(&intake.files),
    };
    let asked = |task: &String| record.tasks.iter().any(|asked| asked.id == *task);
    same && record.format == FORMAT
        && record.status != Status::Failed
        && grader.rubric.tasks.keys().all(asked)
        && record.grader == grader.hash
        && record.sandboxed == grader.sandbox.keeps()
        && seed.is_none_or(|seed| seed == record.seed)
}
