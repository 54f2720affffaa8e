//! A run of a program on a drawn scene, and its error.

use std::sync::Arc;

use anyhow::{Result, anyhow};
use common::soft::{Particle, Scene};
use oracle::contest::{Kind, STEPS};

use crate::commands::precision::reference::rms;
use crate::job::{Job, RunOutput, States};
use crate::runner::Runner;

/// The result of a run. The inner error is a fault of the program, in words.
pub(super) type Ran<T> = Result<std::result::Result<T, String>>;

/// A way to run a job on a drawn scene.
pub type Track<'a> = dyn Fn(&Drawn, &Job) -> Ran<RunOutput> + 'a;

/// Runs jobs by a runner. Every error of the runner counts as a fault of the program.
pub(super) fn by(runner: &Runner) -> impl Fn(&Drawn, &Job) -> Ran<RunOutput> {
    |_, job| Ok(runner.run(job).map_err(|why| format!("{why:#}")))
}

/// A scene and its exact end.
pub struct Drawn {
    /// Kind of the scene.
    pub kind: Kind,
    /// Seed that determines the scene.
    pub seed: u32,
    /// The scene.
    pub scene: Arc<Scene>,
    /// Particles whose error is measured.
    exact: Vec<Particle>,
}

/// The end of a correct run.
pub(super) struct End {
    /// Seconds of loading, stepping and reading the state.
    pub(super) seconds: f64,
    /// Root mean square distance from the exact positions.
    pub(super) error: f64,
    pub(super) state: Vec<Particle>,
}

impl Drawn {
    /// Generates a random scene with the contest's number of particles divided by `shrink`.
    pub(super) fn new(kind: Kind, shrink: usize, seed: u32) -> Result<Self> {
        let scene = kind.scene(kind.n() / shrink, seed);
        let exact =
            kind.exact_end(&scene, seed).map_err(|why| anyhow!("{}: {why}", kind.name()))?;
        Ok(Self { kind, seed, scene: Arc::new(scene), exact })
    }

    /// Runs a job for the contest's steps.
    pub(super) fn run(&self, track: &Track<'_>, job: Job) -> Ran<End> {
        let job = Job { steps: STEPS, states: Some(States::Last), ..job };
        let output = match track(self, &job)? {
            Ok(output) => output,
            Err(why) => return Ok(Err(why)),
        };
        let Some(state) = output.frames.last() else { return Ok(Err("it wrote no state".into())) };
        if let Some(fault) = self.fault(state) {
            return Ok(Err(fault));
        }
        let judged: Vec<Particle> = self.exact.iter().map(|p| state[p.id as usize]).collect();
        let seconds = output.loading + output.seconds + output.reading;
        Ok(Ok(End { seconds, error: rms(&judged, &self.exact), state: state.clone() }))
    }

    /// Finds a particle that is missing or outside the box.
    fn fault(&self, state: &[Particle]) -> Option<String> {
        let inside = 0.0..=self.scene.size();
        for (number, p) in state.iter().enumerate() {
            if [p.x, p.y, p.vx, p.vy] == [0.0; 4] {
                return Some(format!("particle {number} is missing"));
            }
            if !inside.contains(&p.x) || !inside.contains(&p.y) {
                return Some(format!(
                    "particle {number} is outside the box, at ({}, {})",
                    p.x, p.y
                ));
            }
        }
        None
    }
}
