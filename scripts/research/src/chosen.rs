//! The programs of soft discs that a command is about: those named, or all solutions.

use anyhow::{Result, ensure};
use clap::Args;
use lab_machine::Mpiexec;

use lab_kit::program::Program;
use lab_kit::{Discs, Kit, Workers};

/// Programs as the command line names them.
#[derive(Args)]
pub(crate) struct Chosen {
    /// The programs, such as lab12:pefrl [default: all solutions]
    #[arg(value_name = "PROGRAM")]
    programs: Vec<Program>,
    /// Take the solutions of the labs named instead of your own work
    #[arg(long)]
    solution: bool,
}

impl Chosen {
    /// The packages to build: those named, or all that this machine can run; with `quick` none that has ranks.
    ///
    /// # Errors
    /// One simulates hard discs.
    pub(crate) fn packages(&self, kit: &Kit, quick: bool) -> Result<Vec<Program>> {
        let mut packages = self.programs.clone();
        for program in &mut packages {
            program.solution |= self.solution;
            ensure!(
                !program.is_hard(),
                "hard discs are not measured here: their rule is measured by 'cargo lab greedy'"
            );
        }
        if packages.is_empty() {
            packages = Program::solutions(kit, Discs::Soft, Workers::Threads)?;
            match Mpiexec::find() {
                _ if quick => {}
                Ok(_) => packages.extend(Program::solutions(kit, Discs::Soft, Workers::Ranks)?),
                Err(why) => println!("left out: labs with ranks ({why})"),
            }
        }
        Ok(packages)
    }
}
