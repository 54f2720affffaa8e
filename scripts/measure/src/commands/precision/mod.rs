//! `cargo lab precision`: run time against error.
//!
//! A time means little without its error. Every variant of every lab with soft discs, and every
//! integrator at several steps, runs the same scene. The end of each run is compared with the exact
//! motion ([`oracle::reference`]).

mod candidate;
mod diagram;
pub(crate) mod group;
pub mod reference;

use std::sync::Arc;

use anyhow::Result;
use clap::Args;
use common::soft::{DT, Scene};
use lab_kit::Kit;

use crate::chart::Sheet;
use crate::experiment::{in_turns, one_by_one};
use crate::numbers::Files;
use crate::subject::SoftPrograms;
use candidate::{Candidate, STEPS, candidates};
use group::Group;

/// Measure run time against error: every variant, integrator and time step of the soft discs
///
/// Measures all solutions, or the programs that you name: cargo lab precision lab12:pefrl
/// solution12:pefrl -n 500. The error is the rms distance from the exact positions at t = 0.05,
/// which is 100 official steps. The exact motion is computed with located contacts and walls. All
/// programs run on one thread and take turns.
#[derive(Args)]
pub struct Options {
    #[command(flatten)]
    programs: SoftPrograms,
    /// Use a small scene and few steps, to see that the command works
    #[arg(long)]
    quick: bool,
    /// Numbers of particles, separated by commas
    #[arg(short, value_name = "N", value_delimiter = ',', default_values_t = [500, 5000], value_parser = clap::value_parser!(u64).range(1..))]
    n: Vec<u64>,
    /// Number of takes of each program
    #[arg(long, default_value_t = 3, value_name = "ROUNDS", value_parser = clap::value_parser!(u16).range(1..))]
    rounds: u16,
    /// Number of seeds for the energy drift at t = 1; 0 skips it
    #[arg(long, default_value_t = 3, value_name = "SEEDS", value_parser = clap::value_parser!(u32).range(..=100))]
    seeds: u32,
    #[command(flatten)]
    pub(super) files: Files,
}

impl Options {
    pub(super) fn draw(&self, groups: Vec<Group>) -> Result<Sheet> {
        Ok(groups.iter().map(|group| vec![diagram::chart(group)]).collect())
    }
}

pub(super) fn run(kit: &Kit, mut options: Options) -> Result<()> {
    let mut divisions = vec![1, 2, 5, 10, 20, 50];
    if options.quick {
        divisions = vec![1, 10];
        options.n = vec![100];
        options.rounds = 1;
        options.seeds = 0;
    }
    let (runner, variants) = options.programs.build(kit, options.quick)?;
    let mut all = Vec::new();
    for (program, known) in variants {
        all.extend(candidates(program, &known, &divisions));
    }
    let drifts =
        one_by_one(&all, Candidate::name, |candidate| candidate.drift(&runner, options.seeds))?;
    for (candidate, drift) in all.iter_mut().zip(drifts) {
        candidate.energy_drift = drift;
    }
    let mut groups = Vec::new();
    for &n in &options.n {
        let scene = Arc::new(Scene::official(n, 1)?);
        let reference = reference::of(&scene, STEPS as f64 * DT)?;
        let runs = in_turns(&all, options.rounds.into(), Candidate::name, |candidate| {
            runner.run(&candidate.job(&scene, STEPS))
        })?;
        let points =
            all.iter().zip(&runs).filter_map(|(candidate, runs)| candidate.point(runs, &reference));
        let group = Group::new(n, reference.error, points.collect());
        println!("{}", diagram::table(&group));
        groups.push(group);
    }
    options.files.write(&groups, |shown| options.draw(shown))
}
