//! `cargo lab run`: runs a lab's program.

use std::process::{Command, ExitCode, Stdio};

use crate::calls;
use anyhow::{Context, Result, ensure};
use clap::Args;
use lab_kit::binaries::Binaries;
use lab_kit::program::Program;
use lab_kit::terminal::folded;
use lab_kit::{Kit, Lab, system};

/// Run a lab's program, built for speed
///
/// Everything after the number goes to the program: 'cargo lab run 1 --list-variants' shows what
/// it can do, and 'cargo lab run 1 -n 2000 -o out.txt' writes the positions. Options of this
/// command come before the number.
#[derive(Args)]
pub(crate) struct Options {
    /// Run the solution instead of your own work
    #[arg(long)]
    solution: bool,
    /// Run a lab with messages on this number of ranks
    #[arg(long, value_name = "RANKS", value_parser = clap::value_parser!(u16).range(1..))]
    ranks: Option<u16>,
    /// Show afterwards the MPI calls of each rank, and which calls belong together
    #[arg(long, requires = "ranks")]
    watch: bool,
    /// The lab, such as 1
    lab: Lab,
    /// Arguments of the program
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, value_name = "ARGUMENTS")]
    arguments: Vec<String>,
}

/// Builds and runs the lab, and returns its exit code.
pub(crate) fn run(kit: &Kit, mut options: Options) -> Result<ExitCode> {
    let lab = options.lab;
    // The flag is also accepted after the number, because no lab's program has a flag of this name.
    if options.arguments.first().is_some_and(|argument| argument == "--solution") {
        options.arguments.remove(0);
        options.solution = true;
    }
    if options.solution {
        kit.chosen_solutions(Some(lab))?;
    } else {
        kit.expect_starter(lab)?;
    }
    system::expect(kit, lab)?;
    let program = Program::new(lab, options.solution)?;
    let binaries = Binaries::build(kit, std::slice::from_ref(&program))?;
    let mut command = match options.ranks {
        Some(ranks) => {
            ensure!(program.has_ranks(), "lab {lab} has no ranks: leave --ranks out");
            binaries.start(&program, ranks.into())?
        }
        None => Command::new(binaries.named(&program.binary())?),
    };
    command.args(&options.arguments);
    let records = options.watch.then(tempfile::tempdir).transpose()?;
    if let Some(records) = &records {
        command.env("CUTOFF_CALLS", records.path());
    }
    let started = if options.arguments.iter().any(|argument| argument == "--list-variants") {
        command.stderr(Stdio::inherit()).output().map(|output| {
            let listed = String::from_utf8_lossy(&output.stdout);
            listed.lines().for_each(|line| print!("{}", below_its_text(line)));
            output.status
        })
    } else {
        command.status()
    };
    let status = started.with_context(|| format!("{program} did not start"))?;
    if let Some(records) = &records {
        match calls::table(records.path(), options.ranks.unwrap_or(1).into()) {
            Some(table) => print!("\n{table}"),
            None => ensure!(!status.success(), "no rank has called MPI from a file of the labs"),
        }
    }
    Ok(ExitCode::from(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1)))
}

/// Folds a line in the list of variants, and indents further lines to the line's text.
///
/// Such a line is `sorted       a counting sort`.
fn below_its_text(line: &str) -> String {
    let name = line.find("  ").unwrap_or(0);
    let spaces = line[name..].len() - line[name..].trim_start().len();
    let (name, about) = line.split_at(name + spaces);
    folded(name, about)
}
