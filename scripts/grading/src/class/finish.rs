//! Finishes a class after its tasks have been judged: takes times, computes points and writes
//! pages.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::ExitCode;

use anyhow::{Result, anyhow};
use tempfile::TempDir;

use super::Named;
use super::batch::{bar, done};
use super::grader::{Grader, Reference};
use crate::build::Tree;
use crate::record::{self, Findings, Record, Status, scale};
use crate::roster::ClassFile;
use crate::roster::late::file_time;
use crate::score::score;
use crate::submission::known_wrong;
use crate::timing::contest::{self, ClassContest};
use crate::{report, timing};
use lab_kit::escape::line;

/// Times one submission after another. Returns whether all could be timed.
///
/// `programs` contains the programs of submissions that were judged just now. The programs of other
/// submissions are built again in `tree`.
pub(crate) fn time(
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
        let mut record = record::read(&into.join(format!("{name}.json")))?;
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
        done(&bar, name, taken.map_or_else(|error| format!("{error:#}"), |()| times(&record)));
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
    let folders = (own.path(), reference.programs.path());
    if !grader.rubric.has_contest() {
        return timing::time(grader.sandbox, folders, found, &grader.rubric);
    }
    let contest = match contest.take() {
        Some(drawn) => contest.insert(drawn),
        None => contest.insert(ClassContest::draw()?),
    };
    contest.enter(grader.sandbox, folders, found)
}

/// Computes points, writes the pages, and prints a line for each submission.
///
/// Returns failure if a submission could not be graded, or if a known-wrong solution of the kit has
/// unexpected marks.
pub(crate) fn finish(grader: &Grader<'_>, submissions: &[Named], into: &Path) -> Result<ExitCode> {
    let mut records = record::read_all(into)?;
    for (name, path) in submissions {
        if let Some(record) = records.iter_mut().find(|record| record.found.name == *name) {
            record.marked.handed_in = file_time(path, grader.lab);
        }
    }
    let class = ClassFile::read(into, &grader.rubric)?;
    let attendance = class.mark(&mut records, &grader.rubric)?;
    records.iter().try_for_each(|record| record.write(into))?;
    let pages = report::write(grader.kit, grader.lab, &records, (&class, &attendance), into)?;
    let ended = print_submissions(grader, submissions, &records)?;
    attendance.say(&records);
    print_about_times(&class, submissions);
    if let Some(ungraded) = &grader.rubric.ungraded {
        println!("Not graded: {ungraded}");
    }
    pages.iter().for_each(|page| println!("{page}"));
    Ok(ended)
}

/// Prints the points of the submissions. Returns failure as [`finish`] does.
fn print_submissions(
    grader: &Grader<'_>,
    submissions: &[Named],
    records: &[Record],
) -> Result<ExitCode> {
    let full = scale(records);
    let mut ended = ExitCode::SUCCESS;
    for (name, path) in submissions {
        let Some(record) = records.iter().find(|record| record.found.name == *name) else {
            continue;
        };
        let points = match record.has_mark() {
            true => record::points(record.marked.points),
            false => "-".to_owned(),
        };
        println!("{:<32} {points:>6} of {full:<5} {}", line(name), summary(record));
        if record.found.status == Status::Failed {
            ended = ExitCode::FAILURE;
        }
        let wrong = known_wrong::at(grader.kit, grader.lab, path)?;
        if let Some(complaint) = wrong.and_then(|wrong| known_wrong::complaint(&wrong, record)) {
            println!("    {complaint}");
            ended = ExitCode::FAILURE;
        }
    }
    Ok(ended)
}

/// Prints the deadline. Also prints the submissions whose hand-in times the students could have set
/// themselves.
fn print_about_times(class: &ClassFile, submissions: &[Named]) {
    if let Some(deadline) = class.deadline() {
        println!("The deadline was {}.", line(&deadline));
    }
    let mut unpacked = Vec::new();
    for (name, path) in submissions {
        if path.is_dir() {
            unpacked.push(name.as_str());
        }
    }
    if !unpacked.is_empty() && class.trusts_files() {
        println!(
            "The hand-in time of a folder is the time of its files, and a student can change it: \
             name a file of times in class.toml. Folders: {}",
            line(&unpacked.join("; "))
        );
    }
}

/// Builds the programs of a submission that was graded in an earlier run.
fn build(grader: &Grader<'_>, tree: &Tree, path: &Path) -> Result<TempDir> {
    let submission = grader.take(path)?;
    let built = tree.build(grader.sandbox, &submission.files)?;
    built.map_err(|why| anyhow!("it was graded, and cannot be built now: {why}"))
}

/// Summarises the result of timing a submission in a few words.
fn times(record: &Record) -> String {
    let measures = record.marked.measures.iter().map(|measure| {
        let kind = measure.kind.name();
        measure.grade.map_or(format!("{kind} not graded"), |grade| format!("{kind} {grade:.0}"))
    });
    match (record.found.status, &record.found.contest) {
        (Status::Graded, Some(entry)) => contest::summary(entry),
        (Status::Graded, None) => measures.collect::<Vec<_>>().join(", "),
        _ => "there is no program to time".into(),
    }
}

/// Summarises a submission's tasks, open measures and lateness in a few words.
pub(crate) fn summary(record: &Record) -> String {
    match record.found.status {
        Status::Graded => {
            let lost = record.tasks.iter().filter(|task| !task.passed).map(|task| task.id.as_str());
            let lost: Vec<&str> = lost.collect();
            let open = record.marked.measures.iter().filter(|measure| !measure.counts());
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
            parts.extend(record.marked.late.as_ref().map(|late| format!("{} late", late.days())));
            parts.join("; ")
        }
        Status::NotBuilt => "it does not compile".into(),
        _ => line(record.found.message.lines().next().unwrap_or("")),
    }
}
