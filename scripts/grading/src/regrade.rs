//! `cargo lab regrade`: recomputes marks from records, without building or running anything.

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::{Result, bail, ensure};
use clap::Args;

use crate::record::{self, Record};
use crate::report;
use crate::roster::ClassFile;
use lab_kit::Kit;
use lab_kit::escape::line;
use lab_kit::rubric;

/// Mark records again with the present rubric (for instructors)
///
/// The records contain whether a task was right, and its times. The points of a task are in
/// solutions/labN/lab.toml, and your own decisions in class.toml in the folder of records. The
/// command writes the records and the reports, and lists the marks that changed, with reasons. It
/// builds and runs nothing.
#[derive(Args)]
pub(crate) struct Options {
    /// The folder of records that 'cargo lab grade' wrote
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
    /// Only show what would change
    #[arg(long)]
    dry_run: bool,
    /// Show what changed since the records in this folder, which are of an earlier grading
    #[arg(long, value_name = "FOLDER")]
    since: Option<PathBuf>,
}

/// Computes the marks, writes them, and prints the changes.
pub(crate) fn run(kit: &Kit, options: &Options) -> Result<ExitCode> {
    let Options { folder, dry_run, since } = options;
    let mut before = record::read_all(folder)?;
    ensure!(!before.is_empty(), "{} holds no records", folder.display());
    let first = &before[0].found;
    let lab = first.lab;
    if let Some(record) = before.iter().find(|record| record.found.lab != lab) {
        let other = &record.found;
        bail!(
            "the records are of several labs: {}.json of lab {lab}, {}.json of lab {}",
            line(&first.name),
            line(&other.name),
            other.lab
        );
    }
    let rubric = rubric::read(kit, lab)?;
    rubric.warn(lab);
    let mut after = before.clone();
    let class = ClassFile::read(folder, &rubric)?;
    let attendance = class.mark(&mut after, &rubric)?;
    if let Some(folder) = since {
        before = record::read_all(folder)?;
    }
    let verb = if *dry_run && since.is_none() { "would change" } else { "changed" };
    say_changes(&before, &after, verb);
    if !dry_run {
        after.iter().try_for_each(|record| record.write(folder))?;
        report::write(kit, lab, &after, (&class, &attendance), folder)?;
        attendance.say(&after);
        println!("The class: {}", folder.join("index.html").display());
        report::publish_contest(kit, &after, folder)?;
    }
    Ok(ExitCode::SUCCESS)
}

/// Finds the record of this name.
fn find<'a>(records: &'a [Record], name: &str) -> Option<&'a Record> {
    records.iter().find(|record| record.found.name == name)
}

/// Prints a paragraph for each submission that has changed, and the number of changes.
fn say_changes(before: &[Record], after: &[Record], verb: &str) {
    let mut changed = 0;
    for record in after {
        let Some(earlier) = find(before, &record.found.name) else {
            println!("{}: it was not there", line(&record.found.name));
            continue;
        };
        if let Some(words) = report::changes(earlier, record) {
            println!("{words}");
            changed += 1;
        }
    }
    for gone in before.iter().filter(|record| find(after, &record.found.name).is_none()) {
        println!("{}: it is no longer there", line(&gone.found.name));
    }
    println!("{changed} of {} {verb}.", after.len());
}
