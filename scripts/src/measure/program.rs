//! The programs that are timed: a lab's binary, one of its variants, and how that is set.

use std::fmt;
use std::path::PathBuf;
use std::process::Stdio;
use std::str::FromStr;

use anyhow::{Context, Result, bail, ensure};
use serde_json::Value;

use crate::kit::{Kit, Lab};

/// A variant of a lab, the student's or the solution's, written as on the command line:
/// `lab3`, `lab3:fork-join`, `solution3:fork-join,t=2,padding=1`. Lab 9 has a second program, that of
/// hard discs: `lab9-hard:basic-f32`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Program {
    /// Which lab.
    pub(crate) lab: Lab,
    /// Whether it is the solution, not the student's work.
    pub(crate) solution: bool,
    /// Whether it is lab 9's other program, that of hard discs.
    hard: bool,
    /// The variant; none for the lab's first.
    pub(crate) variant: Option<String>,
    /// Threads of the process, or of each rank; none if the command decides.
    pub(crate) threads: Option<usize>,
    /// Processes, for labs of several; none if the command decides.
    pub(crate) ranks: Option<usize>,
    /// The variant's parameters, as for `--param`.
    pub(crate) parameters: Vec<(String, f64)>,
}

impl Program {
    /// A lab's first variant, as it is.
    pub(crate) fn new(lab: Lab, solution: bool) -> Self {
        Self {
            lab,
            solution,
            hard: false,
            variant: None,
            threads: None,
            ranks: None,
            parameters: Vec::new(),
        }
    }

    /// The same with another variant.
    pub(crate) fn with_variant(mut self, variant: &str) -> Self {
        self.variant = Some(variant.into());
        self
    }

    /// Lab 9's program of hard discs, if this is a program of lab 9.
    pub(crate) fn hard(&self) -> Option<Self> {
        (self.lab.number() == 9).then(|| Self { hard: true, ..self.clone() })
    }

    /// The name of its binary.
    pub(crate) fn binary(&self) -> String {
        format!("{}{}", self.package(), if self.hard { "-hard" } else { "" })
    }

    /// The cargo package it is in.
    pub(crate) fn package(&self) -> String {
        format!("{}{}", if self.solution { "solution" } else { "lab" }, self.lab)
    }

    /// Whether its workers are processes that exchange messages.
    pub(crate) fn has_ranks(&self) -> bool {
        matches!(self.lab.number(), 5 | 6 | 8)
    }

    /// Whether it simulates hard discs.
    pub(crate) fn is_hard(&self) -> bool {
        self.hard || matches!(self.lab.number(), 7 | 8)
    }
}

impl FromStr for Program {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut parts = text.split(',');
        let name = parts.next().unwrap_or_default();
        let (package, variant) = name
            .split_once(':')
            .map_or((name, None), |(package, variant)| (package, Some(variant)));
        let (package, hard) =
            package.strip_suffix("-hard").map_or((package, false), |package| (package, true));
        let (solution, lab) = match package.strip_prefix("solution") {
            Some(number) => (true, number.parse()?),
            None => (false, package.parse()?),
        };
        let mut program = Self::new(lab, solution);
        if hard {
            program = program.hard().ok_or_else(|| format!("there is no {package}-hard"))?;
        }
        program.variant = variant.map(Into::into);
        for part in parts {
            let (name, value) = part
                .split_once('=')
                .ok_or_else(|| format!("'{part}' in '{text}' is not NAME=VALUE"))?;
            let number = |what: &str| -> Result<usize, String> {
                value
                    .parse()
                    .ok()
                    .filter(|n| *n > 0)
                    .ok_or(format!("'{value}' is no number of {what}"))
            };
            match name {
                "t" | "threads" => program.threads = Some(number("threads")?),
                "r" | "ranks" => program.ranks = Some(number("ranks")?),
                _ => {
                    let value = value.parse().map_err(|_| format!("'{value}' is not a number"))?;
                    program.parameters.push((name.into(), value));
                }
            }
        }
        Ok(program)
    }
}

impl fmt::Display for Program {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.binary())?;
        if let Some(variant) = &self.variant {
            write!(f, ":{variant}")?;
        }
        if let Some(ranks) = self.ranks {
            write!(f, ",r={ranks}")?;
        }
        if let Some(threads) = self.threads {
            write!(f, ",t={threads}")?;
        }
        for (name, value) in &self.parameters {
            write!(f, ",{name}={value}")?;
        }
        Ok(())
    }
}

/// What was built: the binaries' names and where they lie.
pub(crate) struct Binaries(Vec<(String, PathBuf)>);

impl Binaries {
    /// Builds the programs for speed, all before anything is timed.
    pub(crate) fn build<'p>(
        kit: &Kit,
        programs: impl IntoIterator<Item = &'p Program>,
    ) -> Result<Self> {
        let mut packages = Vec::new();
        for program in programs {
            let folder =
                if program.solution { kit.solution(program.lab) } else { kit.starter(program.lab) };
            ensure!(
                folder.join("Cargo.toml").is_file(),
                "there is no {} in this kit: {} is missing",
                program.package(),
                folder.strip_prefix(kit.root()).unwrap_or(&folder).display()
            );
            packages.push(program.package());
        }
        packages.sort();
        packages.dedup();

        let mut cargo = kit.cargo();
        cargo.args(["build", "--release", "--message-format=json-render-diagnostics", "--bins"]);
        for package in &packages {
            cargo.args(["--package", package]);
        }
        let output = cargo.stderr(Stdio::inherit()).output().context("cargo did not start")?;
        if !output.status.success() {
            bail!("{} does not build, see above", packages.join(" or "));
        }
        let text = String::from_utf8_lossy(&output.stdout);
        let built: Vec<_> = text.lines().filter_map(executable).collect();
        let built = Self(built);
        packages.iter().try_for_each(|package| built.named(package).map(|_| ()))?;
        Ok(built)
    }

    /// The binary of a program that was built.
    pub(crate) fn of(&self, program: &Program) -> Result<&PathBuf> {
        self.named(&program.binary())
    }

    /// The binary of this name.
    pub(crate) fn named(&self, binary: &str) -> Result<&PathBuf> {
        let found = self.0.iter().find(|(name, _)| name == binary);
        Ok(&found.with_context(|| format!("no binary {binary} was built"))?.1)
    }
}

/// The name and place of a binary from a line that cargo prints about it.
fn executable(line: &str) -> Option<(String, PathBuf)> {
    let message: Value = serde_json::from_str(line).ok()?;
    let path = message.get("executable")?.as_str()?;
    let name = message.get("target")?.get("name")?.as_str()?;
    Some((name.to_owned(), path.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn programs_are_written_as_they_are_read() {
        for text in [
            "lab2",
            "solution2:sorted",
            "solution3:fork-join,t=2",
            "lab4:region-locks,t=8,regions=20,x=0.5",
            "solution6:halo,r=4,t=2",
            "solution9-hard:basic-f32,workgroup=64",
        ] {
            assert_eq!(text.parse::<Program>().unwrap().to_string(), text);
        }
        for text in [
            "",
            "lab",
            "lab0:x",
            "solution:x",
            "lab2:x,t",
            "lab2:x,t=0",
            "lab2:x,k=y",
            "lab2-hard:x",
        ] {
            assert!(text.parse::<Program>().is_err(), "{text}");
        }
    }

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
