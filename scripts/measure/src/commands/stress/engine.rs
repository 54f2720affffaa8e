//! A lab's program in the stress tests.

use std::sync::Arc;

use anyhow::Result;
use common::soft::{Particle, Scene};
use lab_kit::binaries::Known;
use lab_kit::program::Program;

use super::method::Method;
use crate::job::{Job, States};
use crate::runner::Runner;
use crate::scene;

/// A scene, and the steps that a program must take in it.
pub(super) struct Asked<'a> {
    pub(super) scene: &'a Scene,
    pub(super) steps: u64,
    /// Number of steps between two states. The first state is the one after step 1.
    pub(super) every: u64,
    /// Length of a step in official steps.
    pub(super) stretch: f64,
}

/// The states; `None` if the program cannot take such steps, because its step is fixed.
pub(super) type Answer = Result<Option<Vec<Vec<Particle>>>>;

/// A variant of a lab's program.
pub(super) struct Lab<'a> {
    pub(super) program: Program,
    pub(super) known: Known,
    pub(super) runner: &'a Runner,
}

impl Lab<'_> {
    pub(super) fn name(&self) -> String {
        self.program.to_string()
    }

    /// Returns the method that the program claims to use.
    pub(super) fn method(&self) -> Method {
        Method::of(self.program.variant.as_deref().unwrap_or_default())
    }

    /// Runs a scene and returns its states.
    pub(super) fn run(&self, asked: &Asked) -> Answer {
        let Some(job) = self.job(asked) else { return Ok(None) };
        Ok(Some(self.runner.run(&job)?.frames))
    }

    /// Makes the job for these steps; `None` if the program's step is fixed.
    fn job(&self, asked: &Asked) -> Option<Job> {
        let scene = scene::Scene::Given(Arc::new(asked.scene.clone()));
        let mut job = Job::new(self.program.clone(), scene);
        job.steps = asked.steps;
        job.states = Some(States::Every(asked.every));
        // If two workers waited for each other a million times, the time would depend mostly on the
        // machine's load.
        job.workers = if asked.steps > 5_000 { 1 } else { 2 };
        if self.known.has("stretch") {
            job.program.parameters.push(("stretch".into(), asked.stretch));
        } else if self.known.has("substeps") {
            // A long step, which lasts `stretch` official steps, has about ten small steps in all.
            // More small steps would make no difference in free flight.
            job.program.parameters.push(("substeps".into(), (10.0 / asked.stretch).floor()));
            job.steps = (asked.steps as f64 * asked.stretch) as u64;
            job.states = Some(States::Every((asked.every as f64 * asked.stretch) as u64));
        } else if asked.stretch != 1.0 {
            return None;
        }
        Some(job)
    }
}
