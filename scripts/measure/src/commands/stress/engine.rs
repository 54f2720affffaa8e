//! A lab's program in the stress tests.

use std::sync::Arc;

use anyhow::Result;
use common::soft::{Particle, Scene};
use lab_kit::binaries::Known;
use lab_kit::program::Program;

use super::method::Method;
use super::trials::Trial;
use crate::job::{Job, States};
use crate::runner::Runner;
use crate::scene;

/// The states that a trial observes; `None` if the program cannot take the trial's step, because
/// its own is fixed.
pub(super) type Answer = Result<Option<Vec<Vec<Particle>>>>;

/// A way to run a scene of a trial.
pub(super) type RunScene<'a> = dyn Fn(&Scene) -> Answer + 'a;

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

    pub(super) fn run(&self, scene: &Scene, trial: &Trial) -> Answer {
        let &Trial { steps, every, stretch, .. } = trial;
        let scene = scene::Scene::Given(Arc::new(scene.clone()));
        let mut job = Job::new(self.program.clone(), scene);
        job.steps = steps;
        job.states = Some(States::Every(every));
        // If two workers waited for each other a million times, the time would depend mostly on the
        // machine's load.
        job.workers = if steps > 5_000 { 1 } else { 2 };
        if self.known.has("stretch") {
            job.program.parameters.push(("stretch".into(), stretch));
        } else if self.known.has("substeps") {
            // A long step, which lasts `stretch` official steps, has about ten small steps in all.
            // More small steps would make no difference in free flight.
            job.program.parameters.push(("substeps".into(), (10.0 / stretch).floor()));
            job.steps = (steps as f64 * stretch) as u64;
            job.states = Some(States::Every((every as f64 * stretch) as u64));
        } else if stretch != 1.0 {
            return Ok(None);
        }
        Ok(Some(self.runner.run(&job)?.frames))
    }
}
