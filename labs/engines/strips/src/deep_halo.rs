//! Ghosts for several steps without a message.

use mpi::topology::SimpleCommunicator;

use crate::partition::Partition;

/// The depth of ghosts for several steps without a message, and the check whether these steps were right.
pub trait DeepHalo: Partition {
    /// The greatest distance of a ghost from the strip, if a rank is to take `steps` steps without a message and no
    /// particle goes further than `fastest` in a step.
    fn deep_width(fastest: f64, steps: u32) -> f64;

    /// The number of steps that an epoch should have: from 1 to `outlook.most`.
    fn best_depth(outlook: Outlook) -> u32;

    /// The number of steps that are right, of the `steps` that all ranks have taken with ghosts `width` deep. It is at
    /// least 1 and the same on all ranks. `said` begins with the greatest distance that a particle of this rank went in
    /// each step; afterwards each number of it is the greatest of all ranks.
    fn confirm(world: &SimpleCommunicator, said: &mut [f64], steps: usize, width: f64) -> usize;
}

/// The facts that decide the cheapest length of an epoch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outlook {
    /// Distance that the fastest particle of all goes in a step.
    pub fastest: f64,
    /// Height of a strip.
    pub height: f64,
    /// Particles of a rank, at least 1.
    pub particles: f64,
    /// Steps that the lists of all ranks last, at least 1. No epoch is longer.
    pub most: u32,
}
