//! Running programs: what it takes, which variants they have, and what they say.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use anyhow::{Context, Result, bail};
use lab_kit::program::{Binaries, Program};
use lab_kit::{Kit, process};
use oracle::mpiexec::Launcher;
use serde::Deserialize;
use tempfile::TempDir;

use super::job::{EVENTS, FRAMES, Job, Outcome};
use super::scene::read_frames;

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

/// What it takes to run jobs: binaries, a launcher of ranks, a folder for files.
pub struct Runner {
    binaries: Binaries,
    launcher: Option<Launcher>,
    folder: TempDir,
    /// What stands before a program's words.
    tool: Vec<String>,
    /// How long a run may take.
    pub limit: Option<Duration>,
}

impl Known {
    /// Whether it has such a parameter.
    pub fn has(&self, parameter: &str) -> bool {
        self.parameters.iter().any(|known| known.name == parameter)
    }
}

impl Runner {
    /// Builds the programs, and looks for an MPI if one needs it.
    ///
    /// # Errors
    /// One does not build, or there is no MPI.
    pub fn build(kit: &Kit, programs: &[Program]) -> Result<Self> {
        let launcher = programs.iter().any(Program::has_ranks).then(Launcher::find).transpose()?;
        let binaries = Binaries::build(kit, programs)?;
        Ok(Self { binaries, launcher, folder: tempfile::tempdir()?, tool: Vec::new(), limit: None })
    }

    /// From now on a tool runs the programs: the words that stand before theirs.
    pub fn under(&mut self, tool: Vec<String>) {
        self.tool = tool;
    }

    /// Runs a job to its end.
    ///
    /// # Errors
    /// It does not start, takes too long, fails, or says nothing that can be understood.
    pub fn run(&self, job: &Job) -> Result<Outcome> {
        let name = &job.program;
        let mut command = self.command(name, job.ranks().unwrap_or(1))?;
        job.tell(&mut command, self.folder())?;
        let frames = self.folder().join(FRAMES);
        let _ = fs::remove_file(&frames);
        let stdout = self.words(&mut command, &name.to_string())?;
        let line = stdout.lines().find(|line| line.starts_with('{'));
        let line = line.with_context(|| format!("{name} printed no results"))?;
        let mut outcome: Outcome =
            serde_json::from_str(line).with_context(|| format!("{name} printed odd results"))?;
        if job.every.is_some() {
            outcome.frames = read_frames(&frames, job.scene.n())
                .with_context(|| format!("{name} wrote odd frames"))?;
        }
        if job.events {
            let lines = fs::read_to_string(self.folder().join(EVENTS))
                .with_context(|| format!("{name} wrote no events"))?;
            outcome.events = lines.lines().map(str::parse).collect::<Result<_, _>>()?;
        }
        Ok(outcome)
    }

    /// The beginning of a command that runs a program's variant, on so many ranks if it has ranks.
    pub fn command(&self, program: &Program, ranks: usize) -> Result<Command> {
        let binary = self.binaries.of(program)?;
        let mut words = self.tool.iter().map(Path::new).chain([binary.as_path()]);
        let first = words.next().unwrap_or(binary);
        let mut command = match &self.launcher {
            Some(launcher) if program.has_ranks() => launcher.start(ranks, first),
            _ => Command::new(first),
        };
        command.args(words);
        if let Some(variant) = &program.variant {
            command.args(["--variant", variant]);
        }
        for (name, value) in &program.parameters {
            command.args(["--param", &format!("{name}={value}")]);
        }
        Ok(command)
    }

    /// A program's variants, or the one that it names, by its answer to `--list-variants --json`.
    ///
    /// # Errors
    /// It does not start, does not answer, or has no such variant.
    pub fn variants(&self, program: &Program) -> Result<Vec<(Program, Known)>> {
        let mut plain = program.clone();
        (plain.variant, plain.parameters) = (None, Vec::new());
        let mut command = self.command(&plain, 1)?;
        let output = command.args(["--list-variants", "--json"]).stdin(Stdio::null()).output();
        let output = output.with_context(|| format!("{} did not start", program.binary()))?;
        let mut known: Vec<Known> = serde_json::from_slice(&output.stdout)
            .with_context(|| format!("{} lists no variants", program.binary()))?;
        if let Some(name) = &program.variant {
            known.retain(|variant| variant.name == *name);
            let package = program.package();
            anyhow::ensure!(!known.is_empty(), "there is no variant '{name}' in {package}");
        }
        let named = |known: Known| (program.clone().with_variant(&known.name), known);
        Ok(known.into_iter().map(named).collect())
    }

    /// What the binary of this name prints.
    ///
    /// # Errors
    /// It does not start, or fails: then in its own words.
    pub fn words_of(&self, binary: &str) -> Result<String> {
        self.words(&mut Command::new(self.binaries.named(binary)?), binary)
    }

    /// Where its files lie.
    pub fn folder(&self) -> &Path {
        self.folder.path()
    }

    /// Runs a command to its end and returns what it prints.
    ///
    /// # Errors
    /// It does not start, takes too long, or fails: then in its own words.
    pub fn words(&self, command: &mut Command, name: &str) -> Result<String> {
        let started = || format!("{name} did not start");
        let (status, stdout, stderr) = match self.limit {
            Some(limit) => {
                let done = process::run(command, limit).with_context(started)?;
                (done.status, done.stdout, done.stderr)
            }
            None => {
                let done = command.stdin(Stdio::null()).output().with_context(started)?;
                let text = |bytes| String::from_utf8_lossy(bytes).into_owned();
                (Some(done.status), text(&done.stdout), text(&done.stderr))
            }
        };
        match status {
            Some(status) if status.success() => Ok(stdout),
            Some(_) => bail!("{name} failed: {}", complaint(&stderr)),
            None => bail!("no answer within {} s", self.limit.unwrap_or_default().as_secs()),
        }
    }
}

/// The line of a failed run that says why: a panic's message, or the last one.
fn complaint(stderr: &str) -> &str {
    let lines = || stderr.lines().filter(|line| !line.trim().is_empty());
    let error = || lines().find(|line| line.starts_with("error"));
    let line = process::panic_in(stderr)
        .or_else(error)
        .or(lines().next_back())
        .unwrap_or("it said nothing");
    line.strip_prefix("error: ").unwrap_or(line).trim()
}

#[cfg(test)]
mod tests {
    use super::complaint;

    #[test]
    fn a_failure_is_told_in_its_own_words() {
        let todo = "\nthread 'main' (1) panicked at labs/lab2/src/grid.rs:5:9:\nnot yet implemented: task 2.1: bins\nnote: run with `RUST_BACKTRACE=1`\n";
        for (said, why) in [
            (todo, "not yet implemented: task 2.1: bins"),
            ("error: there is no variant 'x'\n", "there is no variant 'x'"),
            ("a\nb\n", "b"),
            ("", "it said nothing"),
        ] {
            assert_eq!(complaint(said), why);
        }
    }
}
