//! `cargo lab stress`: scenes that are hard on a program, and what becomes of it.
//!
//! Energy alone says little: a step that is too long gains energy in a correct program too. So each
//! step of a program is compared with the same step of its method, written a second time in
//! [`method`]. A bad figure of a program that follows its method is a limit of the method, and the
//! chapter has a section about it; everything else is a failure.

mod engine;
mod inputs;
mod method;
mod show;
mod trials;
mod verdict;

use std::path::Path;
use std::process::ExitCode;

use anyhow::Result;
use clap::Args;
use oracle::mpiexec::Launcher;

use engine::{Engine, Lab};
use lab_kit::process;
use lab_kit::program::{Binaries, Program};
use lab_kit::progress::progress;
use lab_kit::{Discs, Kit, Workers};
use lab_measure::record::Files;
use lab_measure::variants::Known;
pub(crate) use verdict::energy;
use verdict::{Cell, Met, Verdict};

/// Set programs to scenes that are hard on them: close, fast, crowded, far out, absurd
///
/// Every variant of every soft-disc lab, or of the programs named, such as lab2 or lab4:queues. A
/// cell passes, or shows a limit of the method that the chapter 'Accurate' explains, or fails. The
/// exit code is 1 if any fails.
#[derive(Args)]
pub(crate) struct Options {
    /// The programs [default: all solutions]
    #[arg(value_name = "PROGRAM")]
    programs: Vec<Program>,
    /// Take the solutions of the labs named instead of your own work
    #[arg(long)]
    solution: bool,
    /// Fewer phases, steps and particles, and no labs with ranks
    #[arg(long)]
    quick: bool,
    #[command(flatten)]
    files: Files,
}

/// What was found about an engine.
struct Row {
    name: String,
    /// A cell for each column of each trial, in their order.
    cells: Vec<Cell>,
    met: Vec<Met>,
    /// What it said to each bad input, or what was wrong with that.
    refused: Vec<Result<String, String>>,
}

pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    process::kill_all_on_interrupt();
    let launcher = Launcher::find();
    let packages = packages(kit, &options, &launcher)?;
    let binaries = Binaries::build(kit, &packages)?;
    let folder = tempfile::tempdir()?;
    let mut labs = Vec::new();
    for package in &packages {
        labs.extend(variants(package, &binaries, launcher.as_ref().ok(), folder.path())?);
    }
    let trials = trials::all(options.quick);
    let bar = progress((labs.len() * (trials.len() + 1)) as u64);
    let mut rows = Vec::new();
    for lab in &labs {
        let mut row =
            Row { name: lab.name(), cells: Vec::new(), met: Vec::new(), refused: Vec::new() };
        for trial in &trials {
            bar.set_message(format!("{}: {}", row.name, trial.name));
            let (cells, met) = verdict::judge(lab, trial);
            row.cells.extend(cells);
            row.met.extend(met);
            bar.inc(1);
        }
        for bad in inputs::BAD {
            row.refused.push(inputs::refuse(lab, bad)?);
        }
        bar.inc(1);
        rows.push(row);
    }
    bar.finish_and_clear();
    print!("{}", show::tables(&trials, &rows));
    options.files.write(show::results(&trials, &rows), &show::charts(&rows))?;
    Ok(if rows.iter().all(Row::holds) { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

impl Row {
    fn holds(&self) -> bool {
        let failed = |cell: &Cell| matches!(cell.verdict, Verdict::Fails(_));
        !self.cells.iter().any(failed) && self.refused.iter().all(Result::is_ok)
    }
}

/// The packages to build: those named, or all that this machine can run.
fn packages(
    kit: &Kit,
    options: &Options,
    launcher: &Result<Launcher, oracle::mpiexec::NoLauncher>,
) -> Result<Vec<Program>> {
    let mut packages = options.programs.clone();
    for program in &mut packages {
        program.solution |= options.solution;
        anyhow::ensure!(
            !program.is_hard(),
            "hard discs are not under stress here: their rule is measured by 'cargo lab greedy'"
        );
    }
    if packages.is_empty() {
        packages = Program::solutions(kit, Discs::Soft, Workers::Threads)?;
        match launcher {
            _ if options.quick => {}
            Ok(_) => packages.extend(Program::solutions(kit, Discs::Soft, Workers::Ranks)?),
            Err(why) => println!("left out: labs with ranks ({why})"),
        }
    } else if packages.iter().any(Program::has_ranks) {
        launcher.as_ref().map_err(|e| anyhow::anyhow!("{e}"))?;
    }
    Ok(packages)
}

/// All variants of a program that names none, or the one it names.
fn variants<'a>(
    package: &Program,
    binaries: &'a Binaries,
    launcher: Option<&'a Launcher>,
    folder: &'a Path,
) -> Result<Vec<Lab<'a>>> {
    let known = lab_measure::variants::variants(binaries, package, launcher)?;
    let lab = |known: Known| {
        let program = package.clone().with_variant(&known.name);
        Lab { program, parameters: known.parameters, binaries, launcher, folder }
    };
    let mut labs: Vec<Lab> = known.into_iter().map(lab).collect();
    if let Some(name) = &package.variant {
        labs.retain(|lab| lab.program.variant.as_ref() == Some(name));
        anyhow::ensure!(!labs.is_empty(), "there is no variant '{name}' in {}", package.package());
    }
    Ok(labs)
}

#[cfg(test)]
mod tests;
