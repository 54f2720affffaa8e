//! `cargo lab precision`: run time against error.
//!
//! A time means little without the error that it buys. Every variant of every lab with soft
//! discs, and every integrator at several steps, runs the same scene; its end is compared with
//! the exact motion, that of [`oracle::reference`].

pub(crate) mod reference;
mod show;

use std::process::ExitCode;
use std::sync::Arc;

use anyhow::{Result, ensure};
use clap::Args;
use common::soft::{DT, Scene};
use oracle::energy;
use serde::{Deserialize, Serialize};

use crate::chosen::Chosen;
use lab_kit::Kit;
use lab_kit::binaries::Known;
use lab_kit::program::Program;
use lab_measure::chart::Sheet;
use lab_measure::clock::Times;
use lab_measure::experiment::in_turns;
use lab_measure::files::Files;
use lab_measure::job::{Job, Outcome};
use lab_measure::runner::Runner;
use lab_measure::scene;

/// Measure run time against error: every variant, integrator and time step of the soft discs
///
/// Of all solutions, or of the programs named: cargo lab precision lab12:pefrl solution12:pefrl -n 500.
/// The error is the rms distance from the exact positions at t = 0.05, 100 official steps. The exact
/// motion is computed with located contacts and walls. All run on one thread and take turns. For hard
/// discs 'cargo lab greedy' does the same.
#[derive(Args)]
pub(crate) struct Options {
    #[command(flatten)]
    chosen: Chosen,
    /// A small scene and few steps, to see that it works
    #[arg(long)]
    quick: bool,
    /// Numbers of particles, separated by commas
    #[arg(short, value_name = "N", value_delimiter = ',', default_values_t = [500, 5000], value_parser = clap::value_parser!(u64).range(1..))]
    n: Vec<u64>,
    /// How often each program runs
    #[arg(long, default_value_t = 3, value_name = "ROUNDS", value_parser = clap::value_parser!(u16).range(1..))]
    rounds: u16,
    /// Seeds over which the energy's drift at t = 1 is taken; 0 for none
    #[arg(long, default_value_t = 3, value_name = "SEEDS", value_parser = clap::value_parser!(u32).range(..=100))]
    seeds: u32,
    #[command(flatten)]
    pub(crate) files: Files,
}

/// Official steps until the error is taken, and until the energy is.
const STEPS: u64 = 100;
const LATE: u64 = 2000;

/// Finer divisions are not followed until the late time: it would take minutes.
const MOST_DIVIDED: u32 = 10;

/// The particles of the scene whose energy is followed.
const FEW: u64 = 500;

/// A way to compute the scene: a program, and how many steps it divides an official step into.
struct Candidate {
    program: Program,
    divide: u32,
}

/// What was found about a candidate at one n.
#[derive(Deserialize, Serialize)]
struct Point {
    program: Program,
    n: u64,
    divide: u32,
    /// Root of the mean squared distance from the exact positions.
    rms_error: f64,
    seconds: Times,
    force_evaluations: f64,
    /// Greatest |ΔE/E| at t = 1 over the seeds; none if it was not asked for.
    energy_drift: Option<f64>,
    /// No other is as good in both seconds and error, and better in one.
    on_front: bool,
}

/// The points of one n, and the reference's own error.
#[derive(Deserialize, Serialize)]
pub(crate) struct Group {
    n: u64,
    reference_error: f64,
    points: Vec<Point>,
}

impl Options {
    pub(crate) fn draw(&self, groups: Vec<Group>) -> Result<Sheet> {
        Ok(groups.iter().map(|group| vec![show::chart(group)]).collect())
    }
}

pub(crate) fn run(kit: &Kit, mut options: Options) -> Result<ExitCode> {
    let mut divisions = vec![1, 2, 5, 10, 20, 50];
    if options.quick {
        divisions = vec![1, 10];
        (options.n, options.rounds, options.seeds) = (vec![100], 1, 0);
    }
    let packages = options.chosen.packages(kit, options.quick)?;
    let runner = Runner::build(kit, &packages)?;
    let mut all = Vec::new();
    for package in &packages {
        for (program, known) in runner.binaries.variants(package)? {
            all.extend(candidates(program, &known, &divisions));
        }
    }
    let name = |candidate: &Candidate| candidate.program.to_string();
    let drifts = in_turns(&all, 1, name, |candidate| candidate.drift(&runner, options.seeds))?;
    let mut groups = Vec::new();
    for &n in &options.n {
        let scene = Arc::new(Scene::official(n, 1)?);
        let reference = reference::of(&scene, STEPS as f64 * DT)?;
        let outcomes = in_turns(&all, options.rounds.into(), name, |candidate| {
            runner.run(&candidate.job(&scene, STEPS))
        })?;
        let points = all.iter().zip(&outcomes).zip(drifts.iter().flatten());
        let points = points.filter_map(|((candidate, outcomes), &energy_drift)| {
            let last = outcomes.last()?;
            Some(Point {
                program: candidate.program.clone(),
                n,
                divide: candidate.divide,
                rms_error: reference::rms(last.frames.last()?, &reference.end),
                seconds: Times::of(outcomes.iter().map(|outcome| outcome.seconds).collect())?,
                force_evaluations: candidate.evaluations(last),
                energy_drift,
                on_front: false,
            })
        });
        let mut points: Vec<Point> = points.collect();
        let costs: Vec<_> = points.iter().map(|p| (p.seconds.min, p.rms_error)).collect();
        for (point, on_front) in points.iter_mut().zip(front(&costs)) {
            point.on_front = on_front;
        }
        let group = Group { n, reference_error: reference.error, points };
        println!("{}", show::table(&group));
        groups.push(group);
    }
    options.files.write(&groups, |shown| options.draw(shown))?;
    Ok(ExitCode::SUCCESS)
}

/// A variant that can divide its steps is tried with each of `divisions`, unless it is told how often.
fn candidates(program: Program, known: &Known, divisions: &[u32]) -> Vec<Candidate> {
    let Some(parameter) = ["divide", "substeps"].into_iter().find(|name| known.has(name)) else {
        return vec![Candidate { program, divide: 1 }];
    };
    if let Some(&(_, divide)) = program.parameters.iter().find(|(name, _)| name == parameter) {
        return vec![Candidate { program, divide: divide as u32 }];
    }
    let with = |&divide: &u32| {
        let mut program = program.clone();
        program.parameters.push((parameter.into(), f64::from(divide)));
        Candidate { program, divide }
    };
    divisions.iter().map(with).collect()
}

impl Candidate {
    /// Some official steps on one worker. The first step is always written, then at equal intervals: the last
    /// one is among them.
    fn job(&self, scene: &Arc<Scene>, steps: u64) -> Job {
        let job = Job::new(self.program.clone(), scene::Scene::Given(Arc::clone(scene)));
        Job { steps, every: Some((steps - 1).max(1)), ..job }
    }

    /// Force evaluations in a whole run: how often a particle was asked, on average. A particle that
    /// flies freely is not asked.
    fn evaluations(&self, Outcome { counters, .. }: &Outcome) -> f64 {
        // An engine with windows touches every particle once in each; all else is work in groups, which
        // may go on beyond the last step to the end of its window.
        let in_groups = || {
            let touched = counters.get("particles touched per particle and step")?;
            Some(touched * STEPS as f64 - counters.get("windows")?)
        };
        let counted = counters.get("force evaluations").copied().or_else(in_groups);
        // Every particle asks once in a step, if nothing else is counted.
        counted.unwrap_or(STEPS as f64 * f64::from(self.divide))
    }

    /// The greatest relative change of energy until t = 1, over seeds 1, 2, …
    fn drift(&self, runner: &Runner, seeds: u32) -> Result<Option<f64>> {
        let mut greatest: Option<f64> = None;
        for seed in (1..=seeds).take_while(|_| self.divide <= MOST_DIVIDED) {
            let scene = Arc::new(Scene::official(FEW, seed)?);
            let frames = runner.run(&self.job(&scene, LATE))?.frames;
            ensure!(!frames.is_empty(), "{} wrote no frames", self.program);
            let change = energy(&frames[frames.len() - 1]) / energy(scene.particles()) - 1.0;
            greatest = Some(greatest.unwrap_or(0.0).max(change.abs()));
        }
        Ok(greatest)
    }
}

/// Whether each point (cost, error) lies on the Pareto front: no other is as good in both and
/// better in one. What is not finite is never on it.
fn front(points: &[(f64, f64)]) -> Vec<bool> {
    let finite = |p: &(f64, f64)| p.0.is_finite() && p.1.is_finite();
    let beats = |a: &(f64, f64), b: &(f64, f64)| {
        finite(a) && a.0 <= b.0 && a.1 <= b.1 && (a.0 < b.0 || a.1 < b.1)
    };
    points.iter().map(|p| finite(p) && !points.iter().any(|other| beats(other, p))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_variant_that_divides_is_tried_at_each_division() {
        let mut program: Program = "solution2:sorted".parse().unwrap();
        let tried = |parameters: &str| -> Vec<String> {
            let known = format!(r#"{{"name": "sorted", "parameters": [{parameters}]}}"#);
            let known: Known = serde_json::from_str(&known).unwrap();
            let all = candidates(program.clone(), &known, &[1, 5]);
            all.iter().map(|candidate| candidate.program.to_string()).collect()
        };
        assert_eq!(tried(""), ["solution2:sorted"]);
        let divided = ["solution2:sorted,divide=1", "solution2:sorted,divide=5"];
        assert_eq!(tried(r#"{"name": "skin"}, {"name": "divide"}"#), divided);
        program = "lab2:sorted,divide=7".parse().unwrap();
        let known = r#"{"name": "sorted", "parameters": [{"name": "divide"}]}"#;
        let told = candidates(program, &serde_json::from_str(known).unwrap(), &[1, 5]);
        assert_eq!((told.len(), told[0].divide), (1, 7));
    }

    #[test]
    fn the_front_is_what_no_other_point_beats() {
        let points = [(1.0, 9.0), (2.0, 5.0), (2.0, 6.0), (3.0, 5.0), (4.0, 1.0), (0.5, f64::NAN)];
        assert_eq!(front(&points), [true, true, false, false, true, false]);
        assert_eq!(front(&[(1.0, 1.0), (1.0, 1.0)]), [true, true]);
    }
}
