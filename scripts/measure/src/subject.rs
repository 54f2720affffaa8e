//! What a measuring command is about: a lab and which of its variants, or programs of any labs.

use anyhow::{Result, bail, ensure};
use clap::Args;

use super::runner::Runner;
use lab_kit::program::Program;
use lab_kit::{Kit, Lab};

/// A lab and variants of it, as the command line names them.
#[derive(Args)]
pub struct Subject {
    /// The lab, such as 2
    lab: Lab,
    /// Measure the solution instead of your own work
    #[arg(long)]
    solution: bool,
    /// Variants, separated by commas, or 'all'
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    variant: Vec<String>,
    /// Adjust a parameter, in every variant that has it
    #[arg(long, value_name = "NAME=VALUE", value_parser = parameter)]
    param: Vec<(String, f64)>,
}

/// Programs of any labs, as the command line names them.
#[derive(Args)]
pub struct Programs {
    /// The programs, the one to compare with first
    #[arg(required = true, value_name = "PROGRAM")]
    programs: Vec<Program>,
    /// Take the solutions instead of your own work
    #[arg(long)]
    solution: bool,
}

impl Programs {
    /// The programs, and whether their discs are hard.
    ///
    /// # Errors
    /// Some are soft and some are hard.
    pub fn of_one_kind(&self) -> Result<(Vec<Program>, bool)> {
        let mut programs = self.programs.clone();
        programs.iter_mut().for_each(|program| program.solution |= self.solution);
        let hard = programs[0].is_hard();
        ensure!(
            programs.iter().all(|program| program.is_hard() == hard),
            "soft and hard discs stand in no table together: they are different problems"
        );
        Ok((programs, hard))
    }
}

impl Subject {
    /// The lab's first program.
    ///
    /// # Errors
    /// There is no such lab.
    pub fn package(&self) -> Result<Program> {
        let mut program = Program::new(self.lab, self.solution)?;
        program.parameters.clone_from(&self.param);
        Ok(program)
    }

    /// Builds the lab, and other programs that it is to be compared with, and lists the variants
    /// that were asked for: the first, or all of them if `all`, where none were named. They have one
    /// problem in common.
    pub fn build(
        &self,
        kit: &Kit,
        others: &[Program],
        all: bool,
    ) -> Result<(Runner, Vec<Program>)> {
        let package = self.package()?;
        let packages: Vec<Program> = others.iter().cloned().chain([package.clone()]).collect();
        let runner = Runner::build(kit, &packages)?;
        let mut programs = Vec::new();
        for program in std::iter::once(package.clone()).chain(package.others()?) {
            for (mut program, variant) in runner.binaries.variants(&program)? {
                program.parameters.retain(|(set, _)| variant.has(set));
                programs.push(program);
            }
        }
        let known: Vec<String> = programs.iter().filter_map(|p| p.variant.clone()).collect();
        ensure!(!known.is_empty(), "{} has no variants", package.package());
        let names = match self.variant.as_slice() {
            [] if all => known,
            [] => known[..1].to_vec(),
            [all] if all == "all" => known,
            names => {
                let odd = names.iter().find(|name| !known.contains(name));
                ensure!(
                    odd.is_none(),
                    "there is no variant '{}'; there are: {}",
                    odd.map_or("", |name| name),
                    known.join(", ")
                );
                names.to_vec()
            }
        };
        let named = |name: &String| programs.iter().find(|p| p.variant.as_ref() == Some(name));
        let programs: Vec<Program> = names.iter().filter_map(named).cloned().collect();
        let has =
            |set: &str| programs.iter().any(|p| p.parameters.iter().any(|(name, _)| name == set));
        if let Some((set, _)) = self.param.iter().find(|(set, _)| !has(set)) {
            bail!("none of {} has a parameter '{set}'", names.join(", "));
        }
        ensure!(
            programs.iter().all(|p| p.is_hard() == programs[0].is_hard()),
            "soft and hard discs cannot be compared: name variants of one kind with --variant"
        );
        Ok((runner, programs))
    }
}

fn parameter(text: &str) -> Result<(String, f64), String> {
    let (name, value) = text.split_once('=').ok_or("expected NAME=VALUE")?;
    let value = value.parse().map_err(|_| format!("'{value}' is not a number"))?;
    Ok((name.into(), value))
}
