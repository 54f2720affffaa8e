//! `cargo lab precision`: run time against error.
//!
//! A time means little without the error that it buys. Every variant of every lab with soft
//! discs, and every integrator at several steps, runs the same scene; its end is compared with
//! the exact motion, that of [`oracle::reference`].

mod candidate;
mod pareto;
mod reference;
mod show;

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::{Result, ensure};
use clap::Args;
use common::soft::{DT, Scene};
use oracle::mpiexec::Launcher;

use crate::stress::energy;
use candidate::{Candidate, candidates};
use lab_kit::files::write_text;
use lab_kit::program::{Binaries, Program};
use lab_kit::{Discs, Kit, Workers};
use lab_measure::clock::Times;
use lab_measure::record::Files;
use lab_measure::variants::variants;

/// Measure run time against error: every variant, integrator and time step of the soft discs
///
/// The error is the rms distance from the exact places at t = 0.05, 100 official steps. The exact
/// motion is computed with located contacts and walls, and kept in target/reference. All run on
/// one thread and take turns. For hard discs 'cargo lab greedy' does the same.
#[derive(Args)]
pub(crate) struct Options {
    /// A small scene and few steps, to see that it works
    #[arg(long)]
    quick: bool,
    /// Numbers of particles, separated by commas
    #[arg(short, value_name = "N", value_delimiter = ',', default_values_t = [500, 5000])]
    n: Vec<usize>,
    /// How often each program runs
    #[arg(long, default_value_t = 3, value_name = "ROUNDS", value_parser = clap::value_parser!(u16).range(1..))]
    rounds: u16,
    /// Seeds over which the energy's drift at t = 1 is taken; 0 for none
    #[arg(long, default_value_t = 3, value_name = "SEEDS", value_parser = clap::value_parser!(u32).range(..=100))]
    seeds: u32,
    /// Write the table to this file as CSV
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    #[command(flatten)]
    files: Files,
}

/// Official steps until the error is taken, and until the energy is.
const STEPS: u64 = 100;
const LATE: u64 = 2000;

/// Finer divisions are not followed until the late time: it would take minutes.
const MOST_DIVIDED: u32 = 10;

/// The particles of the scene whose energy is followed.
const FEW: usize = 500;

/// What was found about a candidate at one n.
struct Point {
    candidate: Candidate,
    n: usize,
    times: Times,
    evaluations: f64,
    /// Root of the mean squared distance from the exact places.
    error: f64,
    /// Greatest |ΔE/E| at t = 1 over the seeds; none if it was not asked for.
    drift: Option<f64>,
    /// Nobody is as good in both seconds and error.
    on_front: bool,
}

/// The points of one n, and the reference's own error.
struct Group {
    n: usize,
    reference_error: f64,
    points: Vec<Point>,
}

pub(crate) fn run(kit: &Kit, options: Options) -> Result<ExitCode> {
    let divisions: &[u32] = if options.quick { &[1, 10] } else { &[1, 2, 5, 10, 20, 50] };
    let sizes = if options.quick { vec![100] } else { options.n.clone() };
    ensure!(sizes.iter().all(|&n| n > 0), "a scene needs at least one particle");
    let rounds = if options.quick { 1 } else { options.rounds };
    let launcher = if options.quick { None } else { Launcher::find().ok() };
    let launcher = launcher.as_ref();
    let (binaries, all) = build(kit, divisions, launcher)?;
    let folder = tempfile::tempdir()?;

    let seeds = if options.quick { 0 } else { options.seeds };
    let drifts = all
        .iter()
        .map(|candidate| drift(candidate, &binaries, launcher, folder.path(), seeds))
        .collect::<Result<Vec<_>>>()?;
    let mut groups = Vec::new();
    for n in sizes {
        let reference = reference::of(kit, n, 1, STEPS as f64 * DT)?;
        let mut takes = vec![Vec::new(); all.len()];
        let mut last = Vec::new();
        for _ in 0..rounds {
            last.clear();
            for (candidate, takes) in all.iter().zip(&mut takes) {
                let outcome = candidate.run(&binaries, launcher, folder.path(), n, 1, STEPS)?;
                takes.push(outcome.seconds);
                last.push(outcome);
            }
        }
        let points = all.iter().zip(takes).zip(last).zip(&drifts);
        let points = points.filter_map(|(((candidate, takes), outcome), &drift)| {
            Some(Point {
                candidate: candidate.clone(),
                n,
                times: Times::of(takes)?,
                evaluations: outcome.evaluations,
                error: reference::rms(&outcome.end, &reference.end),
                drift,
                on_front: false,
            })
        });
        let mut group =
            Group { n, reference_error: reference.error, points: points.collect::<Vec<_>>() };
        let costs: Vec<_> = group.points.iter().map(|p| (p.times.min(), p.error)).collect();
        for (point, on) in group.points.iter_mut().zip(pareto::front(&costs)) {
            point.on_front = on;
        }
        println!("{}", show::table(&group));
        groups.push(group);
    }
    if let Some(path) = &options.csv {
        write_text(path, &show::csv(&groups))?;
    }
    options.files.write(show::results(&groups), &show::charts(&groups))?;
    Ok(ExitCode::SUCCESS)
}

fn build(
    kit: &Kit,
    divisions: &[u32],
    launcher: Option<&Launcher>,
) -> Result<(Binaries, Vec<Candidate>)> {
    let mut packages = Program::solutions(kit, Discs::Soft, Workers::Threads)?;
    if launcher.is_some() {
        packages.extend(Program::solutions(kit, Discs::Soft, Workers::Ranks)?);
    }
    let binaries = Binaries::build(kit, &packages)?;
    let mut all = Vec::new();
    for package in &packages {
        let known = variants(&binaries, package, launcher)?;
        all.extend(candidates(package, &known, divisions));
    }
    Ok((binaries, all))
}

/// The greatest relative change of energy until t = 1, over seeds 1, 2, …
fn drift(
    candidate: &Candidate,
    binaries: &Binaries,
    launcher: Option<&Launcher>,
    folder: &std::path::Path,
    seeds: u32,
) -> Result<Option<f64>> {
    let mut greatest = None;
    if candidate.divide > MOST_DIVIDED {
        return Ok(greatest);
    }
    for seed in 1..=seeds {
        let start = energy(Scene::official(FEW as u64, seed)?.particles());
        let end = energy(&candidate.run(binaries, launcher, folder, FEW, seed, LATE)?.end);
        let change = (end / start - 1.0).abs();
        greatest = Some(greatest.map_or(change, |g: f64| g.max(change)));
    }
    Ok(greatest)
}
