//! Candidates for the comparison: programs, each with a division of the official step.

use std::sync::Arc;

use anyhow::{Result, ensure};
use common::soft::Scene;
use lab_kit::binaries::Known;
use lab_kit::program::Program;
use oracle::energy;

use super::group::Point;
use super::reference::{Reference, rms};
use crate::clock::Times;
use crate::job::{Job, RunOutput, States};
use crate::runner::Runner;
use crate::scene;

/// Number of official steps until the error is measured.
pub(super) const STEPS: u64 = 100;

/// Number of official steps until the energy is measured.
const LATE: u64 = 2000;

/// Finest division for which the energy is measured. With a finer division, the measurement would
/// take minutes.
const MOST_DIVIDED: u32 = 10;

/// Number of particles in the scene whose energy is measured.
const PARTICLES: u64 = 500;

/// A program, and the number of steps into which it divides an official step.
pub(super) struct Candidate {
    program: Program,
    divide: u32,
    /// Greatest |ΔE/E| at t = 1; `None` if it was not measured.
    pub(super) energy_drift: Option<f64>,
}

/// Makes a candidate for each of `divisions`, or only one if the program's parameter fixes the
/// division.
pub(super) fn candidates(program: Program, known: &Known, divisions: &[u32]) -> Vec<Candidate> {
    let Some(parameter) = ["divide", "substeps"].into_iter().find(|name| known.has(name)) else {
        return vec![Candidate { program, divide: 1, energy_drift: None }];
    };
    if let Some(divide) = program.parameter(parameter) {
        return vec![Candidate { program, divide: divide as u32, energy_drift: None }];
    }
    let mut all = Vec::new();
    for &divide in divisions {
        let mut program = program.clone();
        program.parameters.push((parameter.into(), f64::from(divide)));
        all.push(Candidate { program, divide, energy_drift: None });
    }
    all
}

impl Candidate {
    pub(super) fn name(&self) -> String {
        self.program.to_string()
    }

    /// Makes a job that takes official steps on one worker and writes its last state.
    pub(super) fn job(&self, scene: &Arc<Scene>, steps: u64) -> Job {
        let job = Job::new(self.program.clone(), scene::Scene::Given(Arc::clone(scene)));
        Job { steps, states: Some(States::Last), ..job }
    }

    /// Compares the ends of the candidate's runs with the reference; `None` if there are no runs.
    pub(super) fn point(&self, runs: &[RunOutput], reference: &Reference) -> Option<Point> {
        let last = runs.last()?;
        Some(Point {
            program: self.program.clone(),
            n: reference.end.len() as u64,
            divide: self.divide,
            rms_error: rms(last.frames.last()?, &reference.end),
            seconds: Times::of(runs.iter().map(|run| run.seconds).collect())?,
            force_evaluations: self.evaluations(last),
            energy_drift: self.energy_drift,
            on_front: false,
        })
    }

    /// Returns the mean number of force evaluations of a particle in a run. A particle that flies
    /// freely needs none.
    fn evaluations(&self, RunOutput { counters, .. }: &RunOutput) -> f64 {
        if let Some(counted) = counters.get("force evaluations") {
            return *counted;
        }
        // An engine with windows touches every particle once in each window. All further touches
        // are evaluations in groups, which may be computed beyond the last step.
        let touched = counters.get("particles touched per particle and step");
        if let (Some(touched), Some(windows)) = (touched, counters.get("windows")) {
            return touched * STEPS as f64 - windows;
        }
        // A program without a counter makes one evaluation per particle and step.
        STEPS as f64 * f64::from(self.divide)
    }

    /// Measures the greatest relative change of energy until t = 1, over seeds 1 to `seeds`.
    /// Returns `None` if `seeds` is 0, or if the division is finer than [`MOST_DIVIDED`].
    pub(super) fn drift(&self, runner: &Runner, seeds: u32) -> Result<Option<f64>> {
        let mut greatest: Option<f64> = None;
        for seed in (1..=seeds).take_while(|_| self.divide <= MOST_DIVIDED) {
            let scene = Arc::new(Scene::official(PARTICLES, seed)?);
            let frames = runner.run(&self.job(&scene, LATE))?.frames;
            ensure!(!frames.is_empty(), "{} wrote no frames", self.program);
            let change = energy(&frames[frames.len() - 1]) / energy(scene.particles()) - 1.0;
            greatest = Some(greatest.unwrap_or(0.0).max(change.abs()));
        }
        Ok(greatest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Makes candidates of a program with these parameters, at two divisions.
    fn tried(program: &str, parameters: &str) -> Vec<String> {
        let known = format!(r#"{{"name": "sorted", "parameters": [{parameters}]}}"#);
        let known: Known = serde_json::from_str(&known).unwrap();
        let all = candidates(program.parse().unwrap(), &known, &[1, 5]);
        all.iter().map(|candidate| format!("{} {}", candidate.program, candidate.divide)).collect()
    }

    #[test]
    fn a_variant_that_divides_is_tried_at_each_division() {
        assert_eq!(tried("solution2:sorted", ""), ["solution2:sorted 1"]);
        let divided = ["solution2:sorted,divide=1 1", "solution2:sorted,divide=5 5"];
        let parameters = r#"{"name": "skin"}, {"name": "divide"}"#;
        assert_eq!(tried("solution2:sorted", parameters), divided);
        let reported = tried("lab2:sorted,divide=7", r#"{"name": "divide"}"#);
        assert_eq!(reported, ["lab2:sorted,divide=7 7"]);
    }
}
