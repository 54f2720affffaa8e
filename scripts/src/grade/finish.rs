//! When everybody's tasks are judged: times, points, pages.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::Result;
use indicatif::ProgressBar;
use tempfile::TempDir;

use super::award::award;
use super::grader::Grader;
use super::record::{Record, Status};
use super::report::escape::line;
use super::tree::{Built, Tree};
use super::{intake, known, record, report, timing};

/// Times one submission after another, gives points, and writes the pages. Of whoever was graded
/// just now `programs` has the programs; those of others are built again in `tree` if they are to be timed.
/// It is a failure if one of the kit's known-wrong solutions has other marks than its manifest says.
///
/// # Errors
/// A record cannot be read or written, or the solution cannot be timed.
pub(super) fn finish(
    grader: &Grader<'_>,
    submissions: &[(String, PathBuf)],
    into: &Path,
    tree: &Tree,
    mut programs: BTreeMap<String, TempDir>,
    timed: bool,
) -> Result<ExitCode> {
    let timed = timed && grader.rubric.times_anything();
    let bar = ProgressBar::new(submissions.len() as u64);
    for (name, path) in submissions {
        let mut record = record::read(&into.join(format!("{name}.json")))?;
        if timed && !timing::is_done(&record, &grader.rubric) {
            let program = match programs.remove(name) {
                None if record.status == Status::Graded => build(grader, tree, path)?,
                program => program,
            };
            record.timed = true;
            if let Some(own) = program {
                let programs =
                    timing::Programs { own: own.path(), solution: grader.solution.path() };
                timing::time(grader.sandbox, &programs, &mut record, &grader.rubric)?;
            }
        }
        award(&mut record, &grader.rubric)?;
        record.write(into)?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    report::write(grader.kit, grader.lab, &record::read_all(into)?, into)?;
    let mut ended = ExitCode::SUCCESS;
    for (name, path) in submissions {
        let record = record::read(&into.join(format!("{name}.json")))?;
        let (points, out_of) = (record.points, record.out_of);
        println!("{:<32} {points:>6} of {out_of:<5} {}", line(name), summary(&record));
        let wrong = known::at(grader.kit, grader.lab, path)?;
        if let Some(complaint) = wrong.and_then(|wrong| known::complaint(&wrong, &record)) {
            println!("    {complaint}");
            ended = ExitCode::FAILURE;
        }
    }
    println!("The class: {}", into.join("index.html").display());
    Ok(ended)
}

/// The programs of a submission that was graded before.
fn build(grader: &Grader<'_>, tree: &Tree, path: &Path) -> Result<Option<TempDir>> {
    let Ok(intake) = intake::take(grader.kit, grader.lab, path) else { return Ok(None) };
    Ok(match tree.build(grader.sandbox, &intake.files)? {
        Built::Program(folder) => Some(folder),
        Built::Failed(_) => None,
    })
}

fn summary(record: &Record) -> String {
    match record.status {
        Status::Graded => {
            let lost = record.tasks.iter().filter(|task| !task.passed).map(|task| task.id.as_str());
            let lost: Vec<&str> = lost.collect();
            let open = record.measures.iter().filter(|measure| !measure.counts());
            let open: Vec<&str> = open.map(|measure| measure.kind.name()).collect();
            let mut said = Vec::new();
            if !lost.is_empty() {
                said.push(format!("lost {}", lost.join(", ")));
            }
            if !open.is_empty() {
                said.push(format!("not graded: {}", open.join(", ")));
            }
            said.join("; ")
        }
        Status::NotBuilt => "it does not compile".into(),
        Status::Unreadable | Status::Empty => line(record.message.lines().next().unwrap_or("")),
    }
}
