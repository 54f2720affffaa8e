//! What is put under stress: a program of a lab.

use std::sync::Arc;

use anyhow::Result;
use common::soft::{Particle, Scene};

use super::method::Method;
use lab_kit::binaries::Known;
use lab_kit::program::Program;
use lab_measure::job::Job;
use lab_measure::runner::Runner;
use lab_measure::scene;

/// What is asked of a program.
pub(super) struct Asked<'a> {
    pub(super) scene: &'a Scene,
    pub(super) steps: u64,
    /// States wanted: after steps 1, 1 + every, 1 + 2 every, …
    pub(super) every: u64,
    /// The length of a step in official ones.
    pub(super) stretch: f64,
}

/// What came of it: the states that were asked for; none if it cannot do this, as its step is built in.
pub(super) type Answer = Result<Option<Vec<Vec<Particle>>>>;

/// A variant of a lab's program.
pub(super) struct Lab<'a> {
    pub(super) program: Program,
    pub(super) known: Known,
    pub(super) runner: &'a Runner,
}

impl Lab<'_> {
    /// The job that is asked for; none if its step is built in.
    fn job(&self, asked: &Asked) -> Option<Job> {
        let mut job =
            Job::new(self.program.clone(), scene::Scene::Given(Arc::new(asked.scene.clone())));
        (job.steps, job.every) = (asked.steps, Some(asked.every));
        // Two that wait for each other a million times would measure the machine's load.
        job.workers = if asked.steps > 5_000 { 1 } else { 2 };
        if self.known.has("stretch") {
            job.program.parameters.push(("stretch".into(), asked.stretch));
        } else if self.known.has("substeps") {
            // Free flight does not know how long a step is. About ten small steps for a long one are
            // fewer for each official one.
            job.program.parameters.push(("substeps".into(), (10.0 / asked.stretch).floor()));
            let stretched = |steps: u64| (steps as f64 * asked.stretch) as u64;
            (job.steps, job.every) = (stretched(asked.steps), Some(stretched(asked.every)));
        } else if asked.stretch != 1.0 {
            return None;
        }
        Some(job)
    }

    /// How it says that it goes through time.
    pub(super) fn method(&self) -> Method {
        Method::of(self.program.variant.as_deref().unwrap_or_default())
    }

    /// Runs a scene.
    pub(super) fn run(&self, asked: &Asked) -> Answer {
        self.job(asked).map(|job| Ok(self.runner.run(&job)?.frames)).transpose()
    }
}
