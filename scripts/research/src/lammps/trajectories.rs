//! Where particles are in LAMMPS and in programs of ours, step by step.

use std::sync::Arc;

use anyhow::Result;
use common::soft::{CUTOFF, Scene};
use oracle::energy;
use serde::Serialize;

use super::Options;
use super::install::Installed;
use super::setup::Style;
use lab_kit::program::Program;
use lab_measure::job::Job;
use lab_measure::runner::Runner;
use lab_measure::scene::{self, read_frames, write_scene};

/// States are compared after steps 1, 1 + EVERY, … of this many.
const STEPS: u64 = 1001;
const EVERY: u64 = 50;

/// The same moment in LAMMPS and in a program of ours.
#[derive(Serialize)]
pub(super) struct Moment {
    pub(super) step: u64,
    pub(super) program: Program,
    pub(super) style: Style,
    /// The greatest distance of a particle here from the same there.
    pub(super) furthest_in_cutoffs: f64,
    /// Relative changes of energy since the start.
    pub(super) energy_change: f64,
    pub(super) energy_change_lammps: f64,
}

/// Lets all run the same scene for a while and compares where particles are.
pub(super) fn compare(
    lammps: &Installed,
    runner: &Runner,
    options: &Options,
) -> Result<Vec<Moment>> {
    let n = options.compare;
    let scene = Arc::new(Scene::official(n as u64, 1)?);
    let (start, frames) = (runner.folder().join("scene.txt"), runner.folder().join("lammps.txt"));
    write_scene(&start, &scene)?;
    let mut theirs = Vec::new();
    for &style in &options.tried.styles {
        let mut command = style.usual().command(lammps, 1);
        command
            .arg("frames")
            .arg(&start)
            .arg(STEPS.to_string())
            .arg(&frames)
            .arg(EVERY.to_string());
        runner.words(&mut command, "LAMMPS")?;
        theirs.push((style, read_frames(&frames, n)?));
    }
    let change = |frame: &_| energy(frame) / energy(scene.particles()) - 1.0;
    let mut moments = Vec::new();
    for program in &options.program {
        let job = Job::new(program.clone(), scene::Scene::Given(Arc::clone(&scene)));
        let here = runner.run(&Job { steps: STEPS, every: Some(EVERY), ..job })?.frames;
        for (style, there) in &theirs {
            for ((here, there), step) in here.iter().zip(there).zip((1..).step_by(EVERY as usize)) {
                let apart = here.iter().zip(there).map(|(a, b)| a.to(b).norm_squared().sqrt());
                moments.push(Moment {
                    step,
                    program: program.clone(),
                    style: *style,
                    furthest_in_cutoffs: apart.fold(0.0, f64::max) / CUTOFF,
                    energy_change: change(here),
                    energy_change_lammps: change(there),
                });
            }
        }
    }
    Ok(moments)
}
