//! Ghosts for several steps without a message.

use mpi::topology::SimpleCommunicator;

use crate::partition::Partition;

/// How deep ghosts are chosen, for how many steps without a message, and whether these steps were right.
pub trait DeepHalo: Partition {
    /// How far from a strip its ghosts come that are moved for `steps` steps without a message, if no particle goes
    /// further than `fastest` in one.
    fn deep_width(fastest: f64, steps: u32) -> f64;

    /// How many steps an epoch should have: from 1 to `outlook.most`.
    fn best_depth(outlook: Outlook) -> u32;

    /// How many of the `steps` steps that all ranks have taken with ghosts `width` deep are right, at least 1 and on
    /// all ranks the same. `said` begins with how far the furthest own particle went in each of them; afterwards each
    /// of its numbers is the greatest that any rank said.
    fn confirm(world: &SimpleCommunicator, said: &mut [f64], steps: usize, width: f64) -> usize;
}

/// The facts on which the cheapest length of an epoch depends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outlook {
    /// How far the fastest particle of all goes in a step.
    pub fastest: f64,
    /// Height of a strip.
    pub height: f64,
    /// Particles of a rank, at least 1.
    pub particles: f64,
    /// Steps that the lists of all ranks last, at least 1. No epoch is longer.
    pub most: u32,
}
