//! Lines that a grading prints: the points of each submission, and remarks about the class.

use std::process::ExitCode;

use anyhow::Result;

use super::Named;
use super::grader::Grader;
use crate::record::{self, Record, Status, scale};
use crate::roster::ClassFile;
use crate::submission::known_wrong;
use crate::timing::contest;
use lab_kit::escape::line;

/// Prints the points of the submissions. Returns failure if a submission could not be
/// graded, or if a known-wrong solution of the kit has unexpected marks.
pub(super) fn print_submissions(
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
        println!("{:<32} {points:>6} of {full:<5} {}", line(name), of_tasks(record));
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
pub(super) fn print_about_times(class: &ClassFile, submissions: &[Named]) {
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

/// Summarises the result of timing a submission in a few words.
pub(super) fn of_times(record: &Record) -> String {
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
pub(super) fn of_tasks(record: &Record) -> String {
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
