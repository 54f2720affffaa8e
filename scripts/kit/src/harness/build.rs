//! Builds the test program of a lab.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use anyhow::{Context, Result, bail};
use serde_json::Value;
use thiserror::Error;

use super::verdict::Outcome;
use crate::cargo::run_visibly;
use crate::fresh;
use crate::lab::Lab;
use crate::process;

/// Compiled tests of a lab.
#[derive(Debug)]
pub struct TestProgram {
    program: PathBuf,
    /// Folder of the package. The tests run in it.
    folder: PathBuf,
    top: PathBuf,
}

/// Reason why there is no test program.
#[derive(Debug, Error)]
pub enum BuildError {
    /// The code does not compile.
    #[error("it does not compile: {}", .0.first().map_or("", |error| error.rendered.trim()))]
    Compile(Vec<CompileError>),
    /// An error that is not in the lab's code, in words.
    #[error("{0}")]
    Other(String),
}

impl From<anyhow::Error> for BuildError {
    fn from(error: anyhow::Error) -> Self {
        Self::Other(format!("{error:#}"))
    }
}

/// An error of the compiler.
#[derive(Debug)]
pub struct CompileError {
    /// Text of the error as the compiler shows it.
    pub rendered: String,
    /// First location in the error: file below the workspace, and line from 1.
    pub location: Option<(PathBuf, usize)>,
}

/// Settings for building a lab's tests.
pub struct Build {
    /// Cargo command in the workspace's top folder, without arguments.
    pub cargo: Command,
    /// Package that the tests belong to.
    pub package: String,
    /// Lab that the tests belong to.
    pub lab: Lab,
    /// Whether Cargo's progress bar and error messages are shown.
    pub shown: bool,
    /// Whether errors are shown in colours.
    pub colour: bool,
}

/// Settings for comparing snapshots, which override a file `insta.yaml`. With them, insta writes no
/// files and hides no differences.
const SNAPSHOTS: [(&str, &str); 4] = [
    ("INSTA_UPDATE", "no"),
    ("INSTA_FORCE_PASS", "0"),
    ("INSTA_OUTPUT", "diff"),
    ("INSTA_REQUIRE_FULL_MATCH", "0"),
];

/// Builds the tests of a package.
pub fn build(build: Build) -> Result<TestProgram, BuildError> {
    let Build { mut cargo, package, lab, shown, colour } = build;
    let top = cargo.get_current_dir().context("cargo has no folder")?.to_owned();
    let format = if colour { "json-diagnostic-rendered-ansi" } else { "json" };
    let target = format!("lab{lab}");
    cargo.args(["test", "--no-run", "--package", &package, "--test", &target]);
    cargo.arg(format!("--message-format={format}"));
    let output = if shown {
        fresh::build(&mut cargo, run_visibly)
    } else {
        fresh::build(cargo.arg("--quiet"), Command::output)
    };
    let output = output.context("cargo did not start")?;
    let mut program = None;
    let mut errors = Vec::new();
    for line in String::from_utf8_lossy(&output.stdout).lines() {
        let Ok(message) = serde_json::from_str::<Value>(line) else { continue };
        if message["target"]["name"] == target && message["target"]["kind"][0] == "test" {
            program = TestProgram::of(&message, &top).or(program);
        }
        errors.extend(compile_error(&message["message"]));
    }
    match program {
        Some(program) if output.status.success() => Ok(program),
        _ if !errors.is_empty() => Err(BuildError::Compile(errors)),
        _ => Err(BuildError::Other(match String::from_utf8_lossy(&output.stderr).trim() {
            "" => "the reason is in cargo's messages above".into(),
            complaint => complaint.into(),
        })),
    }
}

fn compile_error(message: &Value) -> Option<CompileError> {
    // The final 'aborting due to 3 errors' has no location.
    let spans = message["spans"].as_array().filter(|spans| !spans.is_empty())?;
    if message["level"] != "error" {
        return None;
    }
    let rendered = message["rendered"].as_str().unwrap_or_default().into();
    Some(CompileError { rendered, location: spans.iter().find_map(location) })
}

fn location(span: &Value) -> Option<(PathBuf, usize)> {
    Some((span["file_name"].as_str()?.into(), span["line_start"].as_u64()? as usize))
}

/// Returns the name of the test in a line of the lab's table of questions.
fn name(line: &str) -> Option<String> {
    let mut fields = line.strip_prefix("question|")?.split('|');
    Some(format!("{}::{}", fields.next()?, fields.next()?))
}

impl TestProgram {
    /// Reads Cargo's message about a test program; `None` if no file was made.
    fn of(message: &Value, top: &Path) -> Option<Self> {
        let folder = Path::new(message["manifest_path"].as_str()?).parent()?.to_owned();
        Some(Self { program: message["executable"].as_str()?.into(), folder, top: top.to_owned() })
    }

    fn command(&self) -> Command {
        let mut command = Command::new(&self.program);
        // Variables for the tests of other projects, such as INSTA_FORCE_PASS, must not affect
        // these tests.
        for (name, _) in std::env::vars_os() {
            let shown = name.to_string_lossy();
            if shown.starts_with("INSTA_") || shown.starts_with("RUST_") {
                command.env_remove(name);
            }
        }
        // A plain `cargo test` sets the first variable. Because of the second variable, the
        // snapshots need not search for the workspace.
        command
            .current_dir(&self.folder)
            .env("CARGO_MANIFEST_DIR", &self.folder)
            .env("INSTA_WORKSPACE_ROOT", &self.top)
            .envs(SNAPSHOTS);
        command
    }

    /// Returns the names of all tests, in the order of the lab's table of questions.
    ///
    /// The program itself prints this table.
    pub fn tests(&self) -> Result<Vec<String>> {
        let mut command = self.command();
        command.args(["--exact", "questions", "--ignored", "--nocapture"]);
        let done = process::run(&mut command, Duration::from_secs(60))
            .context("the tests cannot be listed")?;
        if done.status.is_none_or(|status| !status.success()) {
            bail!("the tests cannot be listed: {}", done.stderr.trim());
        }
        Ok(done.stdout.lines().filter_map(name).collect())
    }

    /// Runs one test, with additional environment variables.
    pub fn run(
        &self,
        test: &str,
        environment: &[(String, String)],
        limit: Duration,
    ) -> Result<Outcome> {
        let mut command = self.command();
        command.args(["--exact", "--nocapture", test]);
        command.envs(environment.iter().map(|(name, value)| (name, value)));
        let done =
            process::run(&mut command, limit).with_context(|| format!("{test} did not start"))?;
        Ok(Outcome::read(test, &done))
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use serde_json::Value;

    use super::SNAPSHOTS;
    use crate::files::read_toml_at;
    use crate::kit::Kit;

    /// Cargo sets the same variables for a plain `cargo test`.
    #[test]
    fn no_variable_of_other_projects_decides_about_a_snapshot() {
        let config = Kit::find().unwrap().path(".cargo/config.toml");
        let set: BTreeMap<String, Value> = read_toml_at(&config, "/env").unwrap().unwrap();
        let ours: Vec<_> = set.iter().filter(|(name, _)| name.starts_with("INSTA_")).collect();
        // Without its features for files and for its command, insta reads these 13 variables.
        assert_eq!(ours.len(), 13);
        assert!(ours.iter().all(|(_, value)| value["force"] == true), "{ours:?}");
        for (name, value) in SNAPSHOTS {
            assert_eq!(set[name]["value"], value, "{name}");
        }
    }
}
