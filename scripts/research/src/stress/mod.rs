//! `cargo lab stress`: scenes that are hard on a program, and what becomes of it.
//!
//! Energy alone says little: a step that is too long gains energy in a correct program too. So each
//! step of a program is compared with what the oracle says of it, see [`method`]. A bad figure of a
//! program that follows its method is a limit of the method, and the chapter has a section about it;
//! everything else is a failure.

mod engine;
mod inputs;
mod method;
mod scenes;
mod show;
mod trials;
mod verdict;

use std::process::ExitCode;
use std::time::Duration;

use anyhow::Result;
use clap::Args;
use serde::{Deserialize, Serialize};

use crate::chosen::Chosen;
use engine::Lab;
use lab_kit::Kit;
use lab_kit::process;
use lab_kit::program::Program;
use lab_measure::chart::Sheet;
use lab_measure::experiment::in_turns;
use lab_measure::files::Files;
use lab_measure::runner::Runner;
use trials::Trial;
use verdict::{Cell, Met, Verdict};

/// The limit of a run.
const LIMIT: Duration = Duration::from_secs(120);

/// Set programs to scenes that are hard on them: close, fast, crowded, far out, absurd
///
/// Every variant of every soft-disc lab, or of the programs named, such as lab2 or lab4:queues. A
/// cell passes, or shows a limit of the method that the chapter 'Accurate' explains, or fails. The
/// exit code is 1 if any fails.
#[derive(Args)]
pub(crate) struct Options {
    #[command(flatten)]
    chosen: Chosen,
    /// Fewer phases, steps and particles, and no labs with ranks
    #[arg(long)]
    quick: bool,
    #[command(flatten)]
    pub(crate) files: Files,
}

/// What was found about a program.
#[derive(Serialize)]
struct Row {
    program: Program,
    /// A cell for each column of each trial, in their order.
    cells: Vec<Cell>,
    #[serde(rename = "head_on")]
    met: Vec<Met>,
    inputs: Vec<Input>,
}

/// What it said to bad input, or what was wrong with that.
#[derive(Serialize)]
struct Input {
    input: &'static str,
    refused: bool,
    said: String,
}

/// What the figure shows of a row.
#[derive(Deserialize)]
pub(crate) struct Pairs {
    program: Program,
    #[serde(rename = "head_on")]
    met: Vec<Met>,
}

impl Options {
    pub(crate) fn draw(&self, rows: Vec<Pairs>) -> Result<Sheet> {
        Ok(vec![vec![show::chart(&rows)]])
    }
}

pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    process::kill_all_on_interrupt();
    let packages = options.chosen.packages(kit, options.quick)?;
    let mut runner = Runner::build(kit, &packages)?;
    runner.limit = Some(LIMIT);
    let mut labs = Vec::new();
    for package in &packages {
        let lab = |(program, known)| Lab { program, known, runner: &runner };
        labs.extend(runner.binaries.variants(package)?.into_iter().map(lab));
    }
    let trials = trials::all(options.quick);
    let name = |lab: &Lab| lab.program.to_string();
    let rows = in_turns(&labs, 1, name, |lab| Row::of(lab, &trials))?;
    let rows: Vec<Row> = rows.into_iter().flatten().collect();
    print!("{}", show::tables(&trials, &rows));
    options.files.write(&rows, |shown| options.draw(shown))?;
    Ok(if rows.iter().all(Row::holds) { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

impl Row {
    fn of(lab: &Lab, trials: &[Trial]) -> Result<Self> {
        let (cells, met): (Vec<_>, Vec<_>) = trials
            .iter()
            .map(|trial| verdict::judge(lab.method(), |asked| lab.run(asked), trial))
            .unzip();
        let input = |bad: &inputs::Bad| -> Result<Input> {
            let answer = inputs::refuse(lab, bad)?;
            let refused = answer.is_ok();
            Ok(Input { input: bad.0, refused, said: answer.unwrap_or_else(|why| why) })
        };
        let inputs = inputs::BAD.iter().map(input).collect::<Result<_>>()?;
        Ok(Self { program: lab.program.clone(), cells: cells.concat(), met: met.concat(), inputs })
    }

    fn holds(&self) -> bool {
        let failed = |cell: &Cell| matches!(cell.verdict, Verdict::Fails(_));
        !self.cells.iter().any(failed) && self.inputs.iter().all(|input| input.refused)
    }
}

#[cfg(test)]
mod tests;
