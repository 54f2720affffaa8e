//! Finishes a class whose tasks are judged: times, points, pages.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::ExitCode;

use anyhow::{Result, anyhow};
use tempfile::TempDir;

use super::Named;
use super::batch::{bar, done};
use super::grader::{Grader, Reference};
use crate::build::Tree;
use crate::escape::line;
use crate::intake::known_wrong;
use crate::record::{self, Record, Status, scale};
use crate::roll::Roll;
use crate::roll::late::file_time;
use crate::score::score;
use crate::{report, timing};

/// Times one submission after another. Returns whether all could be timed.
///
/// `programs` has the programs of submissions that were judged just now. The programs of other
/// submissions are built again in `tree`.
pub(crate) fn time(
    grader: &Grader<'_>,
    reference: &Reference,
    tree: &Tree,
    untimed: &[&Named],
    into: &Path,
    mut programs: BTreeMap<String, TempDir>,
) -> Result<bool> {
    let bar = bar("times", untimed.len(), 0);
    let mut all = true;
    for (name, path) in untimed {
        let mut record = record::read(&into.join(format!("{name}.json")))?;
        let mut take = || -> Result<()> {
            let program = match programs.remove(name) {
                None if record.status == Status::Graded => Some(build(grader, tree, path)?),
                program => program,
            };
            record.timed = true;
            let Some(own) = program else { return Ok(()) };
            let folders = (own.path(), reference.programs.path());
            timing::time(grader.sandbox, folders, &mut record, &grader.rubric)
        };
        let taken = take();
        if taken.is_err() {
            // The times are open, and the next grading takes them.
            (record.timed, record.runs) = (false, Vec::new());
            all = false;
        }
        score(&mut record, &grader.rubric)?;
        record.write(into)?;
        done(&bar, name, taken.map_or_else(|error| format!("{error:#}"), |()| times(&record)));
    }
    bar.finish_and_clear();
    Ok(all)
}

/// Computes points and writes the pages.
///
/// Returns failure if a submission could not be graded, or if the marks of one of the kit's
/// known-wrong solutions differ from its manifest.
pub(crate) fn finish(grader: &Grader<'_>, submissions: &[Named], into: &Path) -> Result<ExitCode> {
    let mut records = record::read_all(into)?;
    for (name, path) in submissions {
        let own = records.iter_mut().find(|record| record.name == *name);
        own.into_iter().for_each(|record| record.handed_in = file_time(path, grader.lab));
    }
    let roll = Roll::read(into, &grader.rubric)?;
    let rubric = roll.rubric(&grader.rubric);
    roll.tell(&mut records);
    records.iter_mut().try_for_each(|record| score(record, &rubric))?;
    let attendance = roll.attendance(&mut records);
    records.iter().try_for_each(|record| record.write(into))?;
    report::write(grader.kit, grader.lab, &records, (&roll, &attendance), into)?;
    let full = scale(&records);
    let mut ended = ExitCode::SUCCESS;
    for (name, path) in submissions {
        let Some(record) = records.iter().find(|record| record.name == *name) else { continue };
        let points = if record.has_mark() { record::points(record.points) } else { "-".to_owned() };
        println!("{:<32} {points:>6} of {full:<5} {}", line(name), summary(record));
        if record.status == Status::Failed {
            ended = ExitCode::FAILURE;
        }
        let wrong = known_wrong::at(grader.kit, grader.lab, path)?;
        if let Some(complaint) = wrong.and_then(|wrong| known_wrong::complaint(&wrong, record)) {
            println!("    {complaint}");
            ended = ExitCode::FAILURE;
        }
    }
    attendance.say(&records);
    if let Some(deadline) = roll.deadline() {
        println!("The deadline was {}.", line(&deadline));
    }
    let unpacked = submissions.iter().filter(|(_, path)| path.is_dir());
    let unpacked: Vec<&str> = unpacked.map(|(name, _)| name.as_str()).collect();
    if !unpacked.is_empty() && roll.trusts_files() {
        println!(
            "The hand-in time of a folder is the time of its files, and a student can change it: \
             name a file of times in class.toml. Folders: {}",
            line(&unpacked.join("; "))
        );
    }
    if let Some(ungraded) = &grader.rubric.ungraded {
        println!("Not graded: {ungraded}");
    }
    println!("The class: {}", into.join("index.html").display());
    Ok(ended)
}

/// Builds the programs of a submission that was graded before.
fn build(grader: &Grader<'_>, tree: &Tree, path: &Path) -> Result<TempDir> {
    let intake = grader.take(path)?;
    let built = tree.build(grader.sandbox, &intake.files)?;
    built.map_err(|why| anyhow!("it was graded, and cannot be built now: {why}"))
}

/// Summarises the result of timing a submission in a few words.
fn times(record: &Record) -> String {
    let measures = record.measures.iter().map(|measure| {
        let kind = measure.kind.name();
        measure.grade.map_or(format!("{kind} not graded"), |grade| format!("{kind} {grade:.0}"))
    });
    match record.status {
        Status::Graded => measures.collect::<Vec<_>>().join(", "),
        _ => "there is no program to time".into(),
    }
}

/// Summarises a submission's tasks, open measures and lateness in a few words.
pub(crate) fn summary(record: &Record) -> String {
    match record.status {
        Status::Graded => {
            let lost = record.tasks.iter().filter(|task| !task.passed).map(|task| task.id.as_str());
            let lost: Vec<&str> = lost.collect();
            let open = record.measures.iter().filter(|measure| !measure.counts());
            let open: Vec<&str> = open.map(|measure| measure.kind.name()).collect();
            let mut parts = Vec::new();
            if !lost.is_empty() {
                parts.push(format!("lost {}", lost.join(", ")));
            }
            if !open.is_empty() {
                parts.push(format!("open: {}", open.join(", ")));
            }
            if parts.is_empty() {
                parts.push("all right".into());
            }
            parts.extend(record.late.as_ref().map(|late| format!("{} late", late.days())));
            parts.join("; ")
        }
        Status::NotBuilt => "it does not compile".into(),
        _ => line(record.message.lines().next().unwrap_or("")),
    }
}
