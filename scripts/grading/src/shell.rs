//! `cargo lab shell`: opens a shell on a submission inside the sandbox.

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

use anyhow::{Result, anyhow};
use clap::Args;

use crate::build::Tree;
use crate::sandbox::{Limits, Sandbox};
use crate::submission;
use lab_kit::files::write_file;
use lab_kit::process::kill_all_on_interrupt;
use lab_kit::{Given, Kit, Lab, Workers};

/// Open a shell in the sandbox on a submission (for instructors)
///
/// Builds the submission as 'cargo lab grade' does. In the shell you can ask it again, with the
/// seed of its record. It can do no harm there.
#[derive(Args)]
pub(crate) struct Options {
    /// The submission
    path: PathBuf,
    /// The lab
    #[arg(long, value_name = "N")]
    lab: Lab,
}

/// Builds the submission, prints the possible commands, and starts the shell.
pub(crate) fn run(kit: &Kit, options: &Options) -> Result<ExitCode> {
    let lab = options.lab;
    let limit = Duration::from_secs(900);
    let loopback = kit.facts(lab)?.workers == Workers::Ranks;
    let sandbox = Sandbox::find(kit, false, Limits { run: limit, build: limit, loopback })?;
    let sources = submission::buildable(kit, lab, &Given::of(kit, lab)?, &options.path)?;
    kill_all_on_interrupt();
    eprintln!("Building it");
    let tree = Tree::lay(kit, lab, &sandbox)?;
    let folder = tree.build(&sandbox, &sources)?.map_err(|why| anyhow!("{why}"))?;
    for (path, bytes) in &sources {
        write_file(&folder.path().join(path), bytes)?;
    }
    println!(
        "It is in /kit, and its sources in src. This asks a question of task {lab}.1 with seed 7 and shows what it\n\
         prints. tests/lab{lab}.rs lists the questions.\n\
         ./answer task_{lab}_1::QUESTION 7 0> /tmp/answers"
    );
    let status = sandbox.shell(folder.path()).status()?;
    Ok(if status.success() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
