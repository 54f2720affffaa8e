//! The interface of a lab's engine.

use super::{Particle, Scene, SceneError, Statistics};
use crate::Event;

/// An engine that moves soft discs.
///
/// An engine is reusable: each [`load`](Simulation::load) forgets the scene before. Looking, by
/// [`read`](Simulation::read) or the statistics, never changes what comes after.
///
/// Under MPI every rank calls every method together; only the root's `out` is filled.
pub trait Simulation {
    /// Starts over from `scene`.
    fn load(&mut self, scene: &Scene);

    /// Starts over from the official scene. An engine whose particles live on several machines
    /// overrides this, so that none of them has to hold the whole scene.
    ///
    /// # Errors
    /// As [`Scene::official`].
    fn load_official(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        self.load(&Scene::official(n, seed)?);
        Ok(())
    }

    /// Starts over from the counter scene. An engine whose particles live on several machines
    /// overrides this, so that each makes its own and none holds more.
    ///
    /// # Errors
    /// As [`Scene::counter`].
    fn load_counter(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        self.load(&Scene::counter(n, seed)?);
        Ok(())
    }

    /// Advances all particles by one time step.
    fn step(&mut self);

    /// Advances all particles by `steps` time steps. An engine overrides it if steps in a row are
    /// cheaper than one by one, for example because its threads then need not start again.
    fn run(&mut self, steps: u64) {
        for _ in 0..steps {
            self.step();
        }
    }

    /// Writes the particles with ids `first .. first + out.len()` into `out`, in id order.
    fn read(&self, first: usize, out: &mut [Particle]);

    /// The statistics of the last step; none if the engine was built without statistics.
    fn statistics(&self) -> Option<Statistics> {
        None
    }

    /// What this variant counts beyond the statistics since it was loaded, name and value, such
    /// as `("lock wait [s]", 0.25)`. Shown at the end of a run.
    fn counters(&self) -> Vec<(&'static str, f64)> {
        Vec::new()
    }

    /// The activities of all ranks since the scene was loaded, if the engine was built to record it; none if it
    /// cannot. Written by `--events FILE`.
    fn events(&self) -> Option<Vec<Event>> {
        None
    }

    /// What an engine that plans decided and skipped, a line each; none if it decides nothing.
    /// Shown by `--explain`.
    fn plan(&self) -> Option<String> {
        None
    }
}
