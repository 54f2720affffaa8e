//! `cargo lab regrade`: marks anew from records, without building or running anything.

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::{Result, ensure};
use clap::Args;

use crate::roll::Roll;
use crate::score::score;
use crate::{grade_diff, record, report};
use lab_kit::Kit;
use lab_kit::rubric;

/// Mark records anew with the present rubric (for instructors)
///
/// Whether a task was right and what was timed is in the records; what it is worth is in
/// tests/rubric.toml, and what you decided in class.toml beside the records. Writes the records and the reports, and says whose marks changed and why.
/// Builds and runs nothing.
#[derive(Args)]
pub(crate) struct Options {
    /// The folder of records that 'cargo lab grade' named
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
    /// Only say what would change
    #[arg(long)]
    dry_run: bool,
}

/// Marks, writes, and says what changed.
pub(crate) fn run(kit: &Kit, options: &Options) -> Result<ExitCode> {
    let Options { folder, dry_run } = options;
    let before = record::read_all(folder)?;
    ensure!(!before.is_empty(), "{} holds no records", folder.display());
    let lab = before[0].lab;
    ensure!(before.iter().all(|r| r.lab == lab), "the records are of several labs");
    let lab = lab.to_string().parse().map_err(anyhow::Error::msg)?;
    let rubric = rubric::read(kit, lab)?;
    rubric.warn(lab);
    let mut after = before.clone();
    let roll = Roll::read(folder, &rubric)?;
    let attendance = roll.tell(&mut after);
    after.iter_mut().try_for_each(|record| score(record, &rubric))?;
    let mut changed = 0;
    for (before, after) in before.iter().zip(&after) {
        if let Some(words) = grade_diff::words(before, after) {
            println!("{words}");
            changed += 1;
        }
    }
    println!("{changed} of {} changed.", after.len());
    if !dry_run {
        after.iter().try_for_each(|record| record.write(folder))?;
        report::write(kit, lab, &after, (&roll, &attendance), folder)?;
        attendance.say(&after);
        println!("The class: {}", folder.join("index.html").display());
    }
    Ok(ExitCode::SUCCESS)
}
