//! A lab's submissions, several at a time, and where to go on after a stop.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;
use std::thread;
use std::time::Duration;

use anyhow::{Context, Result};
use indicatif::ProgressBar;

use super::grader::{Grader, hash};
use super::guard::Guard;
use super::record::{FORMAT, Record, Status};
use super::sandbox::Sandbox;
use super::workplace::Workplace;
use super::{Options, finish, intake};
use crate::kit::{Kit, Lab};

/// Grades the submissions of a lab, by name and path, and leaves their records in `into`. A record
/// is written whole or not at all: who is killed half-way goes on where it was.
pub(super) fn grade(
    kit: &Kit,
    lab: Lab,
    submissions: &[(String, PathBuf)],
    into: &Path,
    options: &Options,
) -> Result<ExitCode> {
    let limit = Duration::from_secs(options.limit);
    let sandbox = &Sandbox::find(kit, lab, options.trusted, limit)?;
    fs::create_dir_all(into).with_context(|| format!("cannot make {}", into.display()))?;
    let first = Workplace::lay(kit, lab, options, sandbox)?;
    let grader = Grader::new(kit, lab, options, sandbox, &first.tree)?;
    let place = |name: &str| into.join(format!("{name}.json"));
    let open =
        |(name, path): &&(String, PathBuf)| !is_done(&grader, path, &place(name), options.seed);
    let open: Vec<_> = submissions.iter().filter(open).collect();
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let jobs = options.jobs.unwrap_or(cores).min(open.len()).max(1);
    let _guard = Guard::set(jobs);
    let mut workplaces = first.copies(jobs - 1, sandbox)?;
    workplaces.push(first);

    let bar = ProgressBar::new(submissions.len() as u64);
    bar.inc((submissions.len() - open.len()) as u64);
    let programs = Mutex::new(BTreeMap::new());
    let next = Mutex::new(open.into_iter());
    let take = || next.lock().ok()?.next();
    let work = |workplace: &Workplace| -> Result<()> {
        while let Some((name, path)) = take() {
            let (record, program) = grader.grade(workplace, name, path)?;
            record.write(into)?;
            if let (Some(program), Ok(mut programs)) = (program, programs.lock()) {
                programs.insert(name.clone(), program);
            }
            bar.inc(1);
        }
        Ok(())
    };
    thread::scope(|scope| {
        let work = &work;
        let start = |workplace| scope.spawn(move || work(workplace));
        let workers: Vec<_> = workplaces.iter().map(start).collect();
        workers.into_iter().try_for_each(|worker| worker.join().expect("grading does not panic"))
    })?;
    bar.finish_and_clear();
    let programs = programs.into_inner().unwrap_or_default();
    let tree = &workplaces[0].tree;
    let ended = finish::finish(&grader, submissions, into, tree, programs, !options.no_timing)?;
    println!("Records: {}", into.display());
    Ok(ended)
}

/// Whether a record says what grading again would say.
fn is_done(grader: &Grader<'_>, path: &Path, place: &Path, seed: Option<u64>) -> bool {
    let record = fs::read(place).ok().and_then(|text| serde_json::from_slice::<Record>(&text).ok());
    let Some(record) = record else { return false };
    let same = match intake::take(grader.kit, grader.lab, path) {
        Err(error) => record.status == Status::Unreadable && record.message == format!("{error:#}"),
        Ok(intake) if intake.files.is_empty() => record.status == Status::Empty,
        Ok(intake) => record.hash == hash(&intake.files),
    };
    let asked = |task: &String| record.tasks.iter().any(|asked| asked.id == *task);
    same && record.format == FORMAT
        && grader.rubric.tasks.keys().all(asked)
        && record.grader == grader.hash
        && record.sandboxed == grader.sandbox.keeps()
        && (record.tests.is_some() || record.status != Status::Graded || !grader.tests)
        && seed.is_none_or(|seed| seed == record.seed)
}
