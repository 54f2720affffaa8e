//! `cargo lab stress`: scenes that are hard for a program.
//!
//! The energy is not enough to judge a program, because a correct program also gains energy if its
//! step is too long. So each step of a program is compared with the oracle's step ([`method`]). If
//! a program follows its method, a bad figure is a limit of the method, and the chapter has a
//! section about it. All other bad figures are failures.

mod cells;
mod engine;
mod inputs;
mod judge;
mod method;
#[cfg(test)]
mod mistakes;
mod observed;
mod scenes;
mod trials;

use std::process::ExitCode;
use std::time::Duration;

use anyhow::Result;
use clap::Args;
use lab_kit::Kit;

use crate::chart::Sheet;
use crate::experiment::one_by_one;
use crate::numbers::Files;
use crate::subject::SoftPrograms;
use engine::Lab;
use judge::{Pairs, Row};

/// Longest time of a run.
const LIMIT: Duration = Duration::from_secs(120);

/// Test programs on hard scenes: close, fast, crowded, far out, absurd
///
/// Tests every variant of every soft-disc lab, or the programs that you name, such as lab2 or
/// lab4:queues. A cell passes, or shows a limit of the method that the chapter 'Accurate' explains,
/// or fails. The exit code is 1 if any cell fails.
#[derive(Args)]
pub struct Options {
    #[command(flatten)]
    programs: SoftPrograms,
    /// Use fewer phases, steps and particles, and no labs with ranks
    #[arg(long)]
    quick: bool,
    #[command(flatten)]
    pub(super) files: Files,
}

impl Options {
    pub(super) fn draw(&self, rows: Vec<Pairs>) -> Result<Sheet> {
        Ok(vec![vec![cells::chart(&rows)]])
    }
}

pub(super) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let (mut runner, variants) = options.programs.build(kit, options.quick)?;
    runner.limit = LIMIT;
    let runner = &runner;
    let labs = variants.into_iter().map(|(program, known)| Lab { program, known, runner });
    let labs: Vec<Lab> = labs.collect();
    let trials = trials::all(options.quick);
    let rows = one_by_one(&labs, Lab::name, |lab| Row::of(lab, &trials))?;
    print!("{}", cells::tables(&trials, &rows));
    options.files.write(&rows, |shown| options.draw(shown))?;
    Ok(if rows.iter().all(Row::holds) { ExitCode::SUCCESS } else { ExitCode::from(1) })
}
