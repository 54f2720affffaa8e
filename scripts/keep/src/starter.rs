//! `cargo lab starter`: makes labs/ from solutions/.
//!
//! A lab is written once, as its solution. [`generate`] makes its starter, and [`Record`]
//! determines which files may be overwritten.

use std::collections::BTreeSet;
use std::process::ExitCode;

use anyhow::{Result, bail};
use clap::Args;

use lab_kit::starter::{Record, generate, own_files};
use lab_kit::{Kit, Lab, answers, task_list};

/// Write the labs' starters from their solutions (for those who maintain the kit)
///
/// Every answer becomes a `todo!`. A file that somebody has edited is never overwritten.
#[derive(Args)]
pub struct Options {
    /// Write nothing; fail if a starter differs from the result of its solution
    #[arg(long)]
    check: bool,
    /// Only this lab [default: all]
    #[arg(long, value_name = "N")]
    lab: Option<Lab>,
}

/// Writes or checks the starters.
pub fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let mut all_well = true;
    for lab in kit.chosen_solutions(options.lab)? {
        if options.check {
            let drift = drift(kit, lab)?;
            all_well &= drift.is_empty();
            for line in drift {
                println!("lab {lab}: {line}");
            }
        } else {
            write(kit, lab)?;
        }
    }
    if options.check && all_well {
        println!("Every starter agrees with its solution.");
    }
    Ok(if all_well { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn write(kit: &Kit, lab: Lab) -> Result<()> {
    let folder = kit.starter(lab);
    let files = generate(kit, lab)?;
    let record = Record::read(&folder)?;
    let plan = record.plan(&folder, &files);
    if let Some(edited) = plan.edited.first() {
        let others = match plan.edited.len() - 1 {
            0 => String::new(),
            n => format!(" and {n} more"),
        };
        bail!(
            "somebody has edited labs/lab{lab}/{}{others}, so lab {lab} and later labs were not written \
             ('cargo lab reset {lab}' sets the work aside; with --lab only one lab is written)",
            edited.display()
        );
    }
    plan.carry_out(&folder, &files)?;
    let new = Record::of(&files);
    if new != record {
        new.write(&folder)?;
    }
    for path in record.paths().filter(|path| !files.contains_key(*path)) {
        if folder.join(path).exists() {
            let path = path.display();
            println!("lab {lab}: {path} is no longer part of the starter, but edited: it stays");
        }
    }
    println!("lab {lab}: {} files written, {} removed", plan.write.len(), plan.remove.len());
    Ok(())
}

/// Lists the differences between a starter and the starter that its solution gives.
fn drift(kit: &Kit, lab: Lab) -> Result<Vec<String>> {
    let folder = kit.starter(lab);
    let files = generate(kit, lab)?;
    let there = own_files(&folder)?;
    let mut drift = Vec::new();
    for (path, _) in files.iter().filter(|(path, bytes)| there.get(*path) != Some(bytes)) {
        drift.push(format!("{} differs from the result of its solution", path.display()));
    }
    for path in there.keys().filter(|path| !files.contains_key(*path)) {
        drift.push(format!("{} has nothing to do with the solution", path.display()));
    }
    if drift.is_empty() && Record::read(&folder)? != Record::of(&files) {
        drift.push(".starter is out of date".into());
    }
    if !drift.is_empty() {
        drift.push("'cargo lab starter' writes the starters again".into());
    }
    drift.extend(task_drift(kit, lab)?);
    Ok(drift)
}

/// Lists the tasks that only the solution or only its facts have. A solution without regions is its
/// own starter, and only its facts name the tasks.
fn task_drift(kit: &Kit, lab: Lab) -> Result<Vec<String>> {
    let asked = answers::tasks(kit, lab)?;
    if asked.is_empty() {
        return Ok(Vec::new());
    }
    let hinted: BTreeSet<_> =
        task_list::read(kit, lab)?.into_iter().map(|(task, _)| task).collect();
    let without = asked.difference(&hinted).map(|task| format!("lab.toml has no task {task}"));
    let unasked = hinted
        .difference(&asked)
        .map(|task| format!("lab.toml has task {task}, which has no region"));
    Ok(without.chain(unasked).collect())
}
