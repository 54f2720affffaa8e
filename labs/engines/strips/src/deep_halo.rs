//! The decisions of lab 13 about deep ghosts.

use mpi::topology::SimpleCommunicator;

use crate::partition::Partition;

/// The depth of ghosts for several steps without a message, and the confirmation of these steps.
pub trait DeepHalo: Partition {
    /// Returns the greatest distance of a ghost from the strip for `steps` steps without a message.
    ///
    /// No particle moves further than `fastest` in a step.
    fn deep_width(fastest: f64, steps: u32) -> f64;

    /// Returns the number of steps that an epoch should have: from 1 to `outlook.most`.
    fn best_depth(outlook: Outlook) -> u32;

    /// Returns the number of right steps among the last `steps` steps of all ranks, with ghosts
    /// `width` deep.
    ///
    /// The number is at least 1, and the same on all ranks. `numbers` begins with the greatest
    /// distance that a particle of this rank went in each step. Afterwards each of its numbers is
    /// the greatest among all ranks.
    fn confirm(world: &SimpleCommunicator, numbers: &mut [f64], steps: usize, width: f64) -> usize;
}

/// The facts that determine the cheapest length of an epoch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outlook {
    /// Distance that the fastest particle of all ranks goes in a step.
    pub fastest: f64,
    /// Height of a strip; a length.
    pub height: f64,
    /// Number of particles of a rank, at least 1.
    pub particles: f64,
    /// Greatest number of steps of an epoch, at least 1. The lists of all ranks are expected to
    /// last this number of steps.
    pub most: u32,
}
