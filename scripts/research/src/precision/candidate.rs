//! A way to compute the scene: a variant at a time step.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail};
use common::soft::Particle;
use oracle::mpiexec::Launcher;
use serde_json::Value;

use super::reference::particles;
use lab_kit::program::{Binaries, Program};
use lab_measure::variants::Known;

/// A program at a parameter, and how often it asks for a force in an official step.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Candidate {
    pub(super) program: Program,
    /// Steps that an official step is divided into.
    pub(super) divide: u32,
}

/// What a run says.
pub(super) struct Outcome {
    pub(super) seconds: f64,
    /// Force evaluations in the whole run, of everybody at once: how often a particle was asked,
    /// on average. Who flies freely is not asked.
    pub(super) evaluations: f64,
    pub(super) end: Vec<Particle>,
}

/// All candidates of a lab: a variant that can divide its steps is tried with each of `divisions`.
pub(super) fn candidates(package: &Program, known: &[Known], divisions: &[u32]) -> Vec<Candidate> {
    let mut all = Vec::new();
    for variant in known {
        let parameter = ["divide", "substeps"].into_iter().find(|name| variant.has(name));
        let program = package.clone().with_variant(&variant.name);
        match parameter {
            None => all.push(Candidate { program, divide: 1 }),
            Some(parameter) => all.extend(divisions.iter().map(|&divide| {
                let mut program = program.clone();
                program.parameters.push((parameter.into(), f64::from(divide)));
                Candidate { program, divide }
            })),
        }
    }
    all
}

impl Candidate {
    /// Runs the official scene for `steps` official steps on one thread of one process.
    pub(super) fn run(
        &self,
        binaries: &Binaries,
        launcher: Option<&Launcher>,
        folder: &Path,
        n: usize,
        seed: u32,
        steps: u64,
    ) -> Result<Outcome> {
        let frames = folder.join("frames.txt");
        let binary = binaries.of(&self.program)?;
        let mut command = match launcher {
            Some(launcher) if self.program.has_ranks() => launcher.start(1, binary),
            _ => Command::new(binary),
        };
        command.args([
            "-n",
            &n.to_string(),
            "-s",
            &seed.to_string(),
            "-t",
            "1",
            "--json",
            "--full",
        ]);
        // The first step is always written, then every so many: the last one is among them.
        let every = steps.saturating_sub(1).max(1).to_string();
        command.args(["--steps", &steps.to_string(), "--every", &every, "-o"]).arg(&frames);
        if let Some(variant) = &self.program.variant {
            command.args(["--variant", variant]);
        }
        for (name, value) in &self.program.parameters {
            command.args(["--param", &format!("{name}={value}")]);
        }
        let output = command.stdin(Stdio::null()).output().context("the program did not start")?;
        if !output.status.success() {
            bail!("{} failed: {}", self.program, String::from_utf8_lossy(&output.stderr).trim());
        }
        let stdout = String::from_utf8_lossy(&output.stdout);
        let said: Value = stdout
            .lines()
            .find(|line| line.starts_with('{'))
            .and_then(|line| serde_json::from_str(line).ok())
            .with_context(|| format!("{} printed no results", self.program))?;
        let text = fs::read_to_string(&frames).context("the program wrote no frames")?;
        let lines: Vec<_> = text.lines().filter(|line| !line.trim().is_empty()).collect();
        let last = lines.len().checked_sub(n).map(|from| &lines[from..]);
        let end = last.and_then(|lines| particles(lines.iter().copied()));
        let counter = |name: &str| said["counters"][name].as_f64();
        // An engine with windows touches everybody once in each; all else is work in groups, which
        // may go on beyond the last step to the end of its window.
        let in_groups = || {
            let touched = counter("particles touched per particle and step")?;
            Some(touched * steps as f64 - counter("windows")?)
        };
        let counted = counter("force evaluations").or_else(in_groups);
        Ok(Outcome {
            seconds: said["seconds"].as_f64().context("the program says no seconds")?,
            // Everybody asks once in a step, if nothing else is counted.
            evaluations: counted.unwrap_or(steps as f64 * f64::from(self.divide)),
            end: end.with_context(|| format!("{} wrote odd frames", self.program))?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_variant_that_divides_is_tried_at_each_division() {
        let listing = r#"[{"name": "plain", "parameters": []}, {"name": "rk4", "parameters":
            [{"name": "skin"}, {"name": "divide", "default": 1.0}]}]"#;
        let known: Vec<Known> = serde_json::from_str(listing).unwrap();
        let package: Program = "solution10".parse().unwrap();
        let found: Vec<String> = candidates(&package, &known, &[1, 5])
            .iter()
            .map(|candidate| candidate.program.to_string())
            .collect();
        let expected = ["solution10:plain", "solution10:rk4,divide=1", "solution10:rk4,divide=5"];
        assert_eq!(found, expected);
    }
}
