//! `cargo lab run`: a lab's program.

use std::process::ExitCode;

use anyhow::{Context, Result};
use clap::Args;

use crate::kit::{Kit, Lab};

/// Run a lab's program, built for speed
///
/// Everything after the number goes to the program: `cargo lab run 1 --list-variants` shows what
/// it can do, `cargo lab run 1 -n 2000 -o out.txt` writes the positions.
#[derive(Args)]
pub(crate) struct Options {
    /// The lab, such as 1
    lab: Lab,
    /// Run the solution instead of your own work
    #[arg(long)]
    solution: bool,
    /// What the program is told
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, value_name = "ARGUMENTS")]
    arguments: Vec<String>,
}

/// Builds and runs the lab; its exit code becomes ours.
pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let lab = options.lab;
    let package = if options.solution {
        anyhow::ensure!(
            kit.solution(lab).join("Cargo.toml").is_file(),
            "there is no solution of lab {lab} in this kit"
        );
        format!("solution{lab}")
    } else {
        kit.expect_starter(lab)?;
        format!("lab{lab}")
    };
    let status = kit
        .cargo()
        .args(["run", "--quiet", "--release", "--package", &package, "--"])
        .args(&options.arguments)
        .current_dir(std::env::current_dir()?)
        .status()
        .context("cargo did not start")?;
    Ok(ExitCode::from(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1)))
}
