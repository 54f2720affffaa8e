//! What a program can do: its variants and their parameters, as it says itself.

use std::process::{Command, Stdio};

use anyhow::{Context, Result};
use lab_kit::program::{Binaries, Program};
use oracle::mpiexec::Launcher;
use serde::Deserialize;

/// A variant that a program has told of.
#[derive(Debug, Deserialize)]
pub struct Known {
    /// Its name.
    pub name: String,
    /// What can be set in it.
    pub parameters: Vec<Parameter>,
}

/// What can be set in a variant.
#[derive(Debug, Deserialize)]
pub struct Parameter {
    /// The name in `--param NAME=VALUE`.
    pub name: String,
}

impl Known {
    /// Whether it has such a parameter.
    pub fn has(&self, parameter: &str) -> bool {
        self.parameters.iter().any(|known| known.name == parameter)
    }
}

/// A program's variants, by its answer to `--list-variants --json`. One with ranks is asked on one rank.
///
/// # Errors
/// It does not start, or does not answer.
pub fn variants(
    binaries: &Binaries,
    program: &Program,
    launcher: Option<&Launcher>,
) -> Result<Vec<Known>> {
    let mut command = match launcher {
        Some(launcher) if program.has_ranks() => launcher.start(1, binaries.of(program)?),
        _ => Command::new(binaries.of(program)?),
    };
    let output = command.args(["--list-variants", "--json"]).stdin(Stdio::null()).output();
    let output = output.with_context(|| format!("{} did not start", program.binary()))?;
    serde_json::from_slice(&output.stdout)
        .with_context(|| format!("{} lists no variants", program.binary()))
}
