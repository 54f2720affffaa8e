//! How exact LAMMPS's force of a pair is, and where particles are in LAMMPS and in programs of ours, step by step.

use std::sync::Arc;

use anyhow::{Context, Result};
use common::soft::{CUTOFF, DT, MASS, Particle, Scene};
use oracle::{acceleration_of_pair, energy};
use serde::Serialize;

use super::Options;
use super::setup::{Installed, Style};
use crate::precision::reference;
use lab_kit::program::Program;
use lab_measure::job::Job;
use lab_measure::runner::Runner;
use lab_measure::scene::{self, read_frames, write_scene};

/// The largest error of a pair's force, relative to the exact force at its distance.
#[derive(Serialize)]
pub(super) struct PairError {
    pub(super) style: Style,
    pub(super) distances: usize,
    /// From half a cutoff on: nearer than that hardly a pair of the official scene comes.
    pub(super) beyond_half_a_cutoff: f64,
    /// From a hundredth of a cutoff on.
    pub(super) largest: f64,
}

/// The errors of each style.
pub(super) fn pairs(lammps: &Installed, runner: &Runner) -> Result<Vec<PairError>> {
    let of = |style: Style| {
        let mut command = style.usual().command(lammps, 1);
        let said = runner.words(command.arg("forces"), "LAMMPS")?;
        let error = |line: &str| {
            let (r, force) = line.split_once(' ')?;
            let (r, force): (f64, f64) = (r.parse().ok()?, force.parse().ok()?);
            let exact = -MASS * acceleration_of_pair(r, 0.0).x;
            Some((r, (force / exact - 1.0).abs()))
        };
        let errors: Option<Vec<(f64, f64)>> = said.lines().map(error).collect();
        let errors = errors.context("LAMMPS said no forces")?;
        let largest = |from: f64| {
            errors.iter().filter(|(r, _)| *r >= from).map(|(_, error)| *error).fold(0.0, f64::max)
        };
        Ok(PairError {
            style,
            distances: errors.len(),
            beyond_half_a_cutoff: largest(0.5 * CUTOFF),
            largest: largest(0.0),
        })
    };
    Style::ALL.into_iter().map(of).collect()
}

/// States are compared this often after the first step, at equal intervals.
const MOMENTS: u64 = 20;

/// After this step positions are compared with the exact ones too, if it is one of those.
const EARLY: u64 = 101;

/// The same moment in LAMMPS and in a program of ours.
#[derive(Serialize)]
pub(super) struct Moment {
    pub(super) step: u64,
    pub(super) program: Program,
    pub(super) style: Style,
    /// The greatest distance of a particle here from the same there; none once LAMMPS has lost particles.
    pub(super) furthest_in_cutoffs: Option<f64>,
    /// Root of the mean squared distance from the exact positions; none after other steps.
    pub(super) rms_error: Option<f64>,
    pub(super) rms_error_lammps: Option<f64>,
    /// Relative changes of energy since the start.
    pub(super) energy_change: f64,
    pub(super) energy_change_lammps: Option<f64>,
}

/// Lets all run the same scene for a while and compares where particles are.
pub(super) fn trajectories(
    lammps: &Installed,
    runner: &Runner,
    options: &Options,
) -> Result<Vec<Moment>> {
    let (n, every) = (options.compare, (options.steps / MOMENTS).max(1));
    let steps = 1 + MOMENTS * every;
    let scene = Arc::new(Scene::official(n as u64, 1)?);
    let (start, frames) = (runner.folder().join("scene.txt"), runner.folder().join("lammps.txt"));
    write_scene(&start, &scene)?;
    let mut theirs = Vec::new();
    for style in Style::ALL {
        let mut command = style.usual().command(lammps, 1);
        command
            .arg("frames")
            .arg(&start)
            .arg(steps.to_string())
            .arg(&frames)
            .arg(every.to_string())
            .arg(options.divide.to_string());
        runner.words(&mut command, "LAMMPS")?;
        theirs.push((style, read_frames(&frames, n)?));
    }
    let change = |frame: &Vec<Particle>| energy(frame) / energy(scene.particles()) - 1.0;
    let is_moment = EARLY <= steps && (EARLY - 1).is_multiple_of(every);
    let exact = is_moment.then(|| reference::of(&scene, EARLY as f64 * DT)).transpose()?;
    let error = |frame: &[Particle], step| {
        let exact = exact.as_ref().filter(|_| step == EARLY)?;
        Some(reference::rms(frame, &exact.end))
    };
    let mut moments = Vec::new();
    for program in &options.program {
        let job = Job::new(program.clone(), scene::Scene::Given(Arc::clone(&scene)));
        let here = runner.run(&Job { steps, every: Some(every), ..job })?.frames;
        for (style, there) in &theirs {
            for (k, here) in here.iter().enumerate() {
                let (there, step) = (there.get(k), 1 + k as u64 * every);
                moments.push(Moment {
                    step,
                    program: program.clone(),
                    style: *style,
                    furthest_in_cutoffs: there.map(|there| furthest(here, there) / CUTOFF),
                    rms_error: error(here, step),
                    rms_error_lammps: there.and_then(|there| error(there, step)),
                    energy_change: change(here),
                    energy_change_lammps: there.map(change),
                });
            }
        }
    }
    Ok(moments)
}

fn furthest(a: &[Particle], b: &[Particle]) -> f64 {
    let apart = a.iter().zip(b).map(|(a, b)| a.to(b).norm_squared().sqrt());
    apart.fold(0.0, f64::max)
}
