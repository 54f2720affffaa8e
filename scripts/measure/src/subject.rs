//! Options that name the programs of a measurement: a lab's variants, any programs, or all soft
//! discs.

use anyhow::{Result, bail, ensure};
use clap::Args;

use super::runner::Runner;
use lab_kit::binaries::Known;
use lab_kit::program::Program;
use lab_kit::{Discs, Kit, Lab, Workers};
use lab_machine::Mpiexec;

/// Options that name a lab and variants of it.
#[derive(Args)]
pub(crate) struct Subject {
    /// The lab, such as 2
    lab: Lab,
    /// Measure the solution instead of your own work
    #[arg(long)]
    solution: bool,
    /// Variants, separated by commas, or 'all'
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    variant: Vec<String>,
    /// Set a parameter, in every variant that has it
    #[arg(long, value_name = "NAME=VALUE", value_parser = parameter)]
    param: Vec<(String, f64)>,
}

/// Options that name programs of any labs.
#[derive(Args)]
pub(crate) struct Programs {
    /// The programs; the first one is the one to compare with
    #[arg(required = true, value_name = "PROGRAM")]
    programs: Vec<Program>,
    /// Measure the solutions instead of your own work
    #[arg(long)]
    solution: bool,
}

/// Options that name programs of soft discs.
#[derive(Args)]
pub(crate) struct SoftPrograms {
    /// The programs, such as lab12:pefrl [default: all solutions]
    #[arg(value_name = "PROGRAM")]
    programs: Vec<Program>,
    /// Measure the solutions of the labs named instead of your own work
    #[arg(long)]
    solution: bool,
}

impl Programs {
    /// Returns the programs. All of them simulate soft discs, or all simulate hard discs.
    pub(crate) fn of_one_kind(&self) -> Result<Vec<Program>> {
        let mut programs = self.programs.clone();
        programs.iter_mut().for_each(|program| program.solution |= self.solution);
        ensure!(
            programs.iter().all(|program| program.is_hard() == programs[0].is_hard()),
            "soft and hard discs are different problems, so they cannot be in one table"
        );
        Ok(programs)
    }
}

impl SoftPrograms {
    /// Builds the programs that the user named, or all solutions that this machine can run, and
    /// returns their variants. With `quick`, solutions with ranks are omitted.
    pub(crate) fn build(&self, kit: &Kit, quick: bool) -> Result<(Runner, Vec<(Program, Known)>)> {
        let mut packages = self.programs.clone();
        for program in &mut packages {
            program.solution |= self.solution;
            ensure!(!program.is_hard(), "{program}: this command measures soft discs only");
        }
        if packages.is_empty() {
            packages = Program::solutions(kit, Discs::Soft, Workers::Threads)?;
            match Mpiexec::find() {
                _ if quick => {}
                Ok(_) => packages.extend(Program::solutions(kit, Discs::Soft, Workers::Ranks)?),
                Err(why) => println!("left out: labs with ranks ({why})"),
            }
        }
        let runner = Runner::build(kit, &packages)?;
        let variants = runner.variants(&packages)?;
        Ok((runner, variants))
    }
}

impl Subject {
    /// Returns the lab's package as a program without a variant.
    pub(crate) fn package(&self) -> Result<Program> {
        let mut program = Program::new(self.lab, self.solution)?;
        program.parameters.clone_from(&self.param);
        Ok(program)
    }

    /// Builds the lab, and `others` to compare it with. Returns the variants that the user chose.
    ///
    /// Without a choice it returns the first variant, or all variants if `all`. All programs
    /// simulate the same kind of discs.
    pub(crate) fn build(
        &self,
        kit: &Kit,
        others: &[Program],
        all: bool,
    ) -> Result<(Runner, Vec<Program>)> {
        let package = self.package()?;
        let packages = [others, std::slice::from_ref(&package)].concat();
        let runner = Runner::build(kit, &packages)?;
        let mut programs = Vec::new();
        let of_lab = [vec![package.clone()], package.others()?].concat();
        for (mut program, known) in runner.variants(&of_lab)? {
            program.parameters.retain(|(set, _)| known.has(set));
            programs.push(program);
        }
        ensure!(!programs.is_empty(), "{} has no variants", package.package());
        let programs = self.chosen(programs, all)?;
        for (set, _) in &self.param {
            let has = programs.iter().any(|program| program.parameter(set).is_some());
            ensure!(has, "none of {} has a parameter '{set}'", names(&programs));
        }
        ensure!(
            programs.iter().all(|program| program.is_hard() == programs[0].is_hard()),
            "soft and hard discs cannot be compared: name variants of one kind with --variant"
        );
        Ok((runner, programs))
    }

    fn chosen(&self, mut programs: Vec<Program>, all: bool) -> Result<Vec<Program>> {
        if self.variant == ["all"] || all && self.variant.is_empty() {
            return Ok(programs);
        }
        if self.variant.is_empty() {
            programs.truncate(1);
            return Ok(programs);
        }
        let mut chosen = Vec::new();
        for name in &self.variant {
            match programs.iter().find(|program| program.variant.as_ref() == Some(name)) {
                Some(program) => chosen.push(program.clone()),
                None => bail!("there is no variant '{name}'; there are: {}", names(&programs)),
            }
        }
        Ok(chosen)
    }
}

fn names(programs: &[Program]) -> String {
    programs.iter().filter_map(|program| program.variant.as_deref()).collect::<Vec<_>>().join(", ")
}

fn parameter(text: &str) -> Result<(String, f64), String> {
    let (name, value) = text.split_once('=').ok_or("expected NAME=VALUE")?;
    let value = value.parse().map_err(|_| format!("'{value}' is not a number"))?;
    Ok((name.into(), value))
}
