//! The interface of a lab's engine.

use super::{Disc, Scene};
use crate::Event;

/// An engine that moves hard discs.
///
/// An engine can be reused: each [`load`](Simulation::load) replaces the scene. Calls to
/// [`read`](Simulation::read) never change later results. Under MPI every rank calls every method
/// together; only the root's `out` is filled.
pub trait Simulation {
    /// Starts from `scene`.
    fn load(&mut self, scene: &Scene);

    /// Advances all discs by one time step.
    fn step(&mut self);

    /// Writes the discs with numbers `first .. first + out.len()` to `out`.
    fn read(&self, first: usize, out: &mut [Disc]);

    /// Returns the names and values of this variant's counters since the scene was loaded.
    ///
    /// An example is `("pair tests", 4.5e7)`.
    ///
    /// The program prints the counters at the end of a run.
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
}
