//! Compares LAMMPS with programs of the kit: errors of the pair force, and positions over time.

use std::sync::Arc;

use anyhow::{Context, Result};
use clap::Args;
use common::soft::{CUTOFF, DT, MASS, Particle, Scene};
use lab_kit::program::Program;
use lab_measure::commands::precision::reference::{self, Reference};
use lab_measure::job::{Job, States};
use lab_measure::scene::{self, read_frames, write_scene};
use oracle::{acceleration_of_pair, energy};
use serde::Serialize;

use crate::setup::{Lammps, Setup, Style, Tried};

/// Options for the trajectories that are compared.
#[derive(Args)]
pub(crate) struct Compared {
    /// Number of particles whose trajectories are compared; 0 skips trajectories and forces
    #[arg(long, default_value_t = 5000, value_name = "N")]
    pub(crate) compare: usize,
    /// Steps over which they are compared, at twenty moments
    #[arg(long, default_value_t = 1000, value_name = "STEPS")]
    steps: u64,
    /// Number of smaller steps in a step of LAMMPS; a program has a parameter for this number, as
    /// in solution10:neighbour-list,divide=10
    #[arg(long, default_value_t = 1, value_name = "PARTS", value_parser = clap::value_parser!(u32).range(1..=1000))]
    divide: u32,
}

/// Largest errors of a pair's force, relative to the exact force at its distance.
#[derive(Serialize)]
pub(crate) struct PairError {
    pub(crate) style: Style,
    pub(crate) distances: usize,
    /// Largest error at distances of at least half a cutoff. Hardly any pair of the official scene
    /// comes nearer.
    pub(crate) beyond_half_a_cutoff: f64,
    /// Largest error at distances of at least a hundredth of a cutoff.
    pub(crate) largest: f64,
}

/// Computes forces of pairs with each style of LAMMPS, and returns the errors.
pub(crate) fn pairs(lammps: &Lammps, tried: &Tried) -> Result<Vec<PairError>> {
    let mut of_styles = Vec::new();
    for style in lammps.styles() {
        let printed = lammps.run(tried.first_of(style)?, 1, &["forces"])?;
        let errors: Option<Vec<_>> = printed.lines().map(relative_error).collect();
        let errors = errors.context("LAMMPS printed no forces")?;
        of_styles.push(PairError {
            style,
            distances: errors.len(),
            beyond_half_a_cutoff: largest(&errors, 0.5 * CUTOFF),
            largest: largest(&errors, 0.0),
        });
    }
    Ok(of_styles)
}

/// Reads a line `distance force`; returns the distance, and the relative error of the force.
fn relative_error(line: &str) -> Option<(f64, f64)> {
    let (r, force) = line.split_once(' ')?;
    let r: f64 = r.parse().ok()?;
    let force: f64 = force.parse().ok()?;
    let exact = -MASS * acceleration_of_pair(r, 0.0).x;
    Some((r, (force / exact - 1.0).abs()))
}

fn largest(errors: &[(f64, f64)], from: f64) -> f64 {
    let there = errors.iter().filter(|(r, _)| *r >= from);
    there.map(|(_, error)| *error).fold(0.0, f64::max)
}

/// Number of states that are compared after the first step, at equal intervals.
const MOMENTS: u64 = 20;

/// Step after which positions are also compared with the exact ones, if states are compared after
/// it.
const EARLY: u64 = 101;

/// The states of LAMMPS and of a program after the same number of steps.
#[derive(Serialize)]
pub(crate) struct Moment {
    pub(crate) step: u64,
    pub(crate) program: Program,
    pub(crate) style: Style,
    /// Greatest distance between a particle in LAMMPS and in the program; `None` once LAMMPS has
    /// lost particles.
    pub(crate) furthest_in_cutoffs: Option<f64>,
    /// Root of the mean squared distance from the exact positions; `None` except after step [`EARLY`].
    pub(crate) rms_error: Option<f64>,
    pub(crate) rms_error_lammps: Option<f64>,
    /// Relative changes of energy since the start.
    pub(crate) energy_change: f64,
    pub(crate) energy_change_lammps: Option<f64>,
}

impl Compared {
    /// Runs the same scene in LAMMPS and in the programs, and compares the states.
    pub(crate) fn trajectories(
        &self,
        lammps: &Lammps,
        tried: &Tried,
        programs: &[Program],
    ) -> Result<Vec<Moment>> {
        let every = self.every();
        let steps = 1 + MOMENTS * every;
        let scene = Arc::new(Scene::official(self.compare as u64, 1)?);
        let is_moment = EARLY <= steps && (EARLY - 1).is_multiple_of(every);
        let exact = is_moment.then(|| reference::of(&scene, EARLY as f64 * DT)).transpose()?;
        let start = energy(scene.particles());
        let mut theirs = Vec::new();
        for style in lammps.styles() {
            theirs.push((style, self.frames_of(lammps, tried.first_of(style)?, &scene)?));
        }
        let mut moments = Vec::new();
        for program in programs {
            let job = Job::new(program.clone(), scene::Scene::Given(Arc::clone(&scene)));
            let states = Some(States::Every(every));
            let frames = lammps.runner.run(&Job { steps, states, ..job })?.frames;
            for (style, theirs) in &theirs {
                for (k, here) in frames.iter().enumerate() {
                    let there = theirs.get(k);
                    let step = 1 + k as u64 * every;
                    let exact = exact.as_ref().filter(|_| step == EARLY);
                    moments.push(Moment {
                        step,
                        program: program.clone(),
                        style: *style,
                        furthest_in_cutoffs: there.map(|there| furthest(here, there) / CUTOFF),
                        rms_error: error(Some(here), exact),
                        rms_error_lammps: error(there, exact),
                        energy_change: energy(here) / start - 1.0,
                        energy_change_lammps: there.map(|there| energy(there) / start - 1.0),
                    });
                }
            }
        }
        Ok(moments)
    }

    /// Returns the number of steps between two moments.
    fn every(&self) -> u64 {
        (self.steps / MOMENTS).max(1)
    }

    /// Runs LAMMPS on the scene and returns its state at each moment.
    fn frames_of(
        &self,
        lammps: &Lammps,
        setup: Setup,
        scene: &Scene,
    ) -> Result<Vec<Vec<Particle>>> {
        let start = lammps.file("scene.txt");
        let frames = lammps.file("lammps.txt");
        write_scene(&start, scene)?;
        let files = [&start, &frames].map(|file| file.display().to_string());
        let steps = [1 + MOMENTS * self.every(), self.every(), self.divide.into()];
        let [steps, every, divide] = steps.map(|steps| steps.to_string());
        let words = ["frames", &files[0], &steps, &files[1], &every, &divide];
        lammps.run(setup, 1, &words)?;
        Ok(read_frames(&frames, self.compare)?)
    }
}

/// Returns the error of a state; `None` where there is no state or no reference.
fn error(state: Option<&Vec<Particle>>, exact: Option<&Reference>) -> Option<f64> {
    Some(reference::rms(state?, &exact?.end))
}

fn furthest(a: &[Particle], b: &[Particle]) -> f64 {
    let apart = a.iter().zip(b).map(|(a, b)| a.to(b).norm_squared().sqrt());
    apart.fold(0.0, f64::max)
}
