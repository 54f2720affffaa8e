//! Compiled programs: starts them, and lists their variants.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail, ensure};
use lab_machine::Mpiexec;
use serde::Deserialize;
use serde_json::Value;

use crate::cargo::run_visibly;
use crate::fresh;
use crate::kit::Kit;
use crate::program::Program;

/// Compiled programs: the binaries' names and paths.
pub struct Binaries {
    built: Vec<(String, PathBuf)>,
    /// Launcher of ranks; `None` if no program has ranks.
    launcher: Option<Mpiexec>,
    /// Command of a tool that runs the programs, such as a profiler; empty if they are run
    /// directly.
    pub tool: Vec<String>,
}

/// A variant that a program has listed.
#[derive(Debug, Deserialize)]
pub struct Known {
    /// Name of the variant.
    pub name: String,
    /// Parameters of the variant.
    pub parameters: Vec<Parameter>,
}

/// A parameter of a variant.
#[derive(Debug, Deserialize)]
pub struct Parameter {
    /// Name in `--param NAME=VALUE`.
    pub name: String,
}

impl Known {
    /// Whether the variant has this parameter.
    pub fn has(&self, parameter: &str) -> bool {
        self.parameters.iter().any(|known| known.name == parameter)
    }
}

impl Binaries {
    /// Builds all programs in release mode, and finds an MPI if a program needs it.
    ///
    /// # Errors
    /// If a program is missing or does not compile, or if there is no MPI.
    pub fn build(kit: &Kit, programs: &[Program]) -> Result<Self> {
        let launcher = programs.iter().any(Program::has_ranks).then(Mpiexec::find).transpose()?;
        let mut packages = Vec::new();
        for program in programs {
            let folder =
                if program.solution { kit.solution(program.lab) } else { kit.starter(program.lab) };
            let package = program.package();
            let shown = folder.strip_prefix(kit.root()).unwrap_or(&folder).display();
            let is_here = folder.join("Cargo.toml").is_file();
            ensure!(is_here, "there is no {package} in this kit: {shown} is missing");
            packages.push(package);
        }
        packages.sort();
        packages.dedup();

        let mut cargo = kit.cargo();
        cargo.args(["build", "--release", "--message-format=json-render-diagnostics", "--bins"]);
        for package in &packages {
            cargo.args(["--package", package]);
        }
        let output = fresh::build(&mut cargo, run_visibly).context("cargo did not start")?;
        if !output.status.success() {
            bail!("{} does not build, see above", packages.join(" or "));
        }
        let text = String::from_utf8_lossy(&output.stdout);
        let built = text.lines().filter_map(executable).collect();
        let built = Self { built, launcher, tool: Vec::new() };
        packages.iter().try_for_each(|package| built.named(package).map(|_| ()))?;
        Ok(built)
    }

    /// Returns the path of a binary by its name.
    pub fn named(&self, binary: &str) -> Result<&Path> {
        let found = self.built.iter().find(|(name, _)| name == binary);
        Ok(&found.with_context(|| format!("no binary {binary} was built"))?.1)
    }

    /// Returns the beginning of a command that runs a program. A program with ranks runs on `ranks`
    /// ranks.
    pub fn start(&self, program: &Program, ranks: usize) -> Result<Command> {
        let binary = self.named(&program.binary())?;
        let mut words = self.tool.iter().map(Path::new).chain([binary]);
        let first = words.next().unwrap_or(binary);
        let mut command = match &self.launcher {
            Some(launcher) if program.has_ranks() => launcher.start(ranks, first),
            _ => Command::new(first),
        };
        command.args(words);
        Ok(command)
    }

    /// Lists a program's variants with `--list-variants --json`, or only the variant that `program`
    /// names.
    ///
    /// # Errors
    /// If the program does not start, prints no list, or does not have the variant.
    pub fn variants(&self, program: &Program) -> Result<Vec<(Program, Known)>> {
        let mut command = self.start(program, 1)?;
        let output = command.args(["--list-variants", "--json"]).stdin(Stdio::null()).output();
        let output = output.with_context(|| format!("{} did not start", program.binary()))?;
        let mut known: Vec<Known> = serde_json::from_slice(&output.stdout)
            .with_context(|| format!("{} lists no variants", program.binary()))?;
        if let Some(name) = &program.variant {
            known.retain(|variant| variant.name == *name);
            ensure!(!known.is_empty(), "there is no variant '{name}' in {}", program.package());
        }
        let known = known.into_iter();
        Ok(known.map(|known| (program.clone().with_variant(&known.name), known)).collect())
    }
}

/// Returns the name and path of a binary from a line that Cargo prints about it.
fn executable(line: &str) -> Option<(String, PathBuf)> {
    let message: Value = serde_json::from_str(line).ok()?;
    let path = message.get("executable")?.as_str()?;
    let name = message.get("target")?.get("name")?.as_str()?;
    Some((name.to_owned(), path.into()))
}

#[cfg(test)]
mod tests {
    use super::executable;

    #[test]
    fn the_binary_is_found_in_what_cargo_prints() {
        let line = r#"{"reason":"compiler-artifact","target":{"name":"solution1","kind":["bin"]},"executable":"/t/release/solution1"}"#;
        assert_eq!(executable(line), Some(("solution1".into(), "/t/release/solution1".into())));
        let library =
            r#"{"reason":"compiler-artifact","target":{"name":"common"},"executable":null}"#;
        assert_eq!(executable(library), None);
        assert_eq!(executable("not json"), None);
    }
}
