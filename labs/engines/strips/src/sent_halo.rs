//! Ghosts that last several steps. Their positions are sent in each step.

use std::ops::Range;

use mpi::Rank;
use mpi::topology::SimpleCommunicator;
use neighbour_list::kernels::{Pair, Positions};

use crate::partition::Partition;

/// The choice of ghosts for several steps, and the messages with their positions in each step.
pub trait Halo: Partition {
    /// The greatest distance of a ghost from the strip, if ghosts are to last `steps` steps and no particle goes further
    /// than `fastest` in a step.
    fn ghost_width(fastest: f64, steps: u32) -> f64;

    /// The number of steps that ghosts should last: from 1 to `scenery.most`.
    fn best_steps(scenery: Scenery) -> u32;

    /// The particles that a partner needs: the indices in `y`, ascending, of all no further than `width` from its
    /// `strip`.
    fn choose(y: &[f64], strip: &Range<f64>, width: f64) -> Vec<u32>;

    /// The pairs of a particle of this rank and a ghost within `reach`, ascending in the first particle.
    fn pairs_across(own: Positions<'_>, ghosts: Positions<'_>, reach: f64) -> Vec<Pair>;

    /// Sends `sent[k]` to rank `partners[k]`, fills `received[k]` with the positions from that rank, and calls `meanwhile`
    /// once.
    fn exchange_positions(
        world: &SimpleCommunicator,
        partners: &[Rank],
        sent: &[Vec<f64>],
        received: &mut [Vec<f64>],
        meanwhile: impl FnOnce(),
    );

    /// Whether all ranks rebuild their lists before the next forces. The answer is the same on all ranks: yes, if on any of
    /// them `list_has_expired`, or if ghosts have expired there. They were chosen `width` wide, and since then a particle of
    /// that rank may have `moved` so far.
    fn must_renew(
        world: &SimpleCommunicator,
        list_has_expired: bool,
        moved: f64,
        width: f64,
    ) -> bool;
}

/// The facts that decide the cheapest number of steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scenery {
    /// Distance that the fastest particle of all goes in a step.
    pub fastest: f64,
    /// Particles per area, where they stand closest.
    pub density: f64,
    /// Height of a strip; its length along x does not matter.
    pub height: f64,
    /// Steps that the lists of all ranks last, at least 1. Then ghosts are chosen again anyway.
    pub most: u32,
}
