//! `cargo lab run`: a lab's program.

use std::path::PathBuf;
use std::process::{Command, ExitCode};

use anyhow::{Context, Result, bail, ensure};
use clap::Args;
use oracle::mpiexec::Launcher;

use crate::kit::{Kit, Lab};
use crate::system;

/// Run a lab's program, built for speed
///
/// Everything after the number goes to the program: 'cargo lab run 1 --list-variants' shows what
/// it can do, 'cargo lab run 1 -n 2000 -o out.txt' writes the positions. What is meant for this
/// command comes before the number.
#[derive(Args)]
pub(crate) struct Options {
    /// Run the solution instead of your own work
    #[arg(long)]
    solution: bool,
    /// Run a lab with messages on so many ranks
    #[arg(long, value_name = "RANKS", value_parser = clap::value_parser!(u16).range(1..))]
    ranks: Option<u16>,
    /// The lab, such as 1
    lab: Lab,
    /// What the program is told
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, value_name = "ARGUMENTS")]
    arguments: Vec<String>,
}

/// Builds and runs the lab; its exit code becomes ours.
pub(crate) fn run(kit: &Kit, mut options: Options) -> Result<ExitCode> {
    let lab = options.lab;
    // Who writes it behind the number means the same: no lab has such a flag.
    if options.arguments.first().is_some_and(|argument| argument == "--solution") {
        options.arguments.remove(0);
        options.solution = true;
    }
    let package = if options.solution {
        kit.chosen_solutions(Some(lab))?;
        format!("solution{lab}")
    } else {
        kit.expect_starter(lab)?;
        format!("lab{lab}")
    };
    if let Some(what) = system::missing(kit, lab)? {
        bail!("lab {lab} needs {what}");
    }
    let mut cargo = kit.cargo();
    cargo.args(["build", "--release", "--package", &package, "--bin", &package]);
    // A first build takes a while and shows it; later ones have nothing to say.
    if !cargo.arg("--quiet").status().context("cargo did not start")?.success() {
        return Ok(ExitCode::FAILURE);
    }
    let program = target(kit)?.join("release").join(&package);
    let mut command = match options.ranks {
        Some(ranks) => {
            ensure!(system::has_ranks(kit, lab)?, "lab {lab} has no ranks: leave --ranks out");
            Launcher::find()?.start(ranks.into(), &program)
        }
        None => Command::new(&program),
    };
    let status = command.args(&options.arguments).status();
    let status = status.with_context(|| format!("{} did not start", program.display()))?;
    Ok(ExitCode::from(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1)))
}

/// Where cargo builds.
fn target(kit: &Kit) -> Result<PathBuf> {
    let output = kit.cargo().args(["metadata", "--no-deps", "--format-version", "1"]).output()?;
    let metadata: serde_json::Value =
        serde_json::from_slice(&output.stdout).context("cargo metadata")?;
    metadata["target_directory"].as_str().map(PathBuf::from).context("cargo names no target folder")
}
