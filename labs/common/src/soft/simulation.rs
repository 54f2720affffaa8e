//! The interface of a lab's engine.

use super::{Particle, Scene, SceneError, Statistics};
use crate::Event;

/// An engine that moves soft discs.
///
/// An engine can be reused: each [`load`](Simulation::load) replaces the scene. Calls to
/// [`read`](Simulation::read) and [`statistics`](Simulation::statistics) never change later
/// results. Under MPI every rank calls every method together; only the root's `out` is filled.
pub trait Simulation {
    /// Starts from `scene`.
    fn load(&mut self, scene: &Scene);

    /// Starts from the official scene.
    ///
    /// An engine whose particles are on several machines overrides this method, so that no machine
    /// stores the whole scene.
    ///
    /// # Errors
    /// The same as those of [`Scene::official`].
    fn load_official(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        self.load(&Scene::official(n, seed)?);
        Ok(())
    }

    /// Starts from the counter scene.
    ///
    /// An engine whose particles are on several machines overrides this method, so that each
    /// machine makes only its own particles.
    ///
    /// # Errors
    /// The same as those of [`Scene::counter`].
    fn load_counter(&mut self, n: u64, seed: u32) -> Result<(), SceneError> {
        self.load(&Scene::counter(n, seed)?);
        Ok(())
    }

    /// Advances all particles by one time step.
    fn step(&mut self);

    /// Advances all particles by `steps` time steps.
    ///
    /// An engine overrides this method if several steps in a row are cheaper than single steps, for
    /// example because its threads then start only once.
    fn run(&mut self, steps: u64) {
        for _ in 0..steps {
            self.step();
        }
    }

    /// Writes the particles with ids `first .. first + out.len()` to `out`, in id order.
    fn read(&self, first: usize, out: &mut [Particle]);

    /// Returns the statistics of the last step, or `None` if the engine was built without
    /// statistics.
    fn statistics(&self) -> Option<Statistics> {
        None
    }

    /// Returns the names and values of this variant's counters since the scene was loaded.
    ///
    /// They do not include the statistics.
    ///
    /// An example is `("lock wait [s]", 0.25)`. The program prints the counters at the end of a
    /// run.
    fn counters(&self) -> Vec<(&'static str, f64)> {
        Vec::new()
    }

    /// Returns the activities of all ranks since the scene was loaded.
    ///
    /// Returns `None` if the engine does not record activities.
    ///
    /// The option `--events FILE` writes the activities to a file.
    fn events(&self) -> Option<Vec<Event>> {
        None
    }

    /// Returns the decisions of an engine that plans and the work that it skipped, one per line, or
    /// `None`.
    ///
    /// The option `--explain` prints them.
    fn plan(&self) -> Option<String> {
        None
    }
}
