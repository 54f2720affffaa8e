//! The interface of a lab's engine.

use super::{Disc, Scene};
use crate::Event;

/// An engine that moves hard discs.
///
/// An engine is reusable: each [`load`](Simulation::load) forgets the scene before. Looking, by
/// [`read`](Simulation::read), never changes what comes after.
///
/// Under MPI every rank calls every method together; only the root's `out` is filled.
pub trait Simulation {
    /// Starts over from `scene`.
    fn load(&mut self, scene: &Scene);

    /// Advances all discs by one time step.
    fn step(&mut self);

    /// Writes the discs with numbers `first .. first + out.len()` into `out`.
    fn read(&self, first: usize, out: &mut [Disc]);

    /// What this variant has counted since it was loaded, name and value, such as
    /// `("pair tests", 4.5e7)`. Shown at the end of a run.
    fn counters(&self) -> Vec<(&'static str, f64)> {
        Vec::new()
    }

    /// The activities of all ranks since the scene was loaded, if the engine was built to record it; none if it
    /// cannot. Written by `--events FILE`.
    fn events(&self) -> Option<Vec<Event>> {
        None
    }
}
