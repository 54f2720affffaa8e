//! The decisions of lab 13 about ghosts whose positions are sent in each step.

use std::ops::Range;

use mpi::Rank;
use mpi::topology::SimpleCommunicator;
use neighbour_list::kernels::{Pair, Positions};

use crate::partition::Partition;

/// The choice of ghosts for several steps, and the messages with their positions in each step.
pub trait Halo: Partition {
    /// Returns the greatest distance of a ghost from the strip, for ghosts that last `steps` steps.
    ///
    /// No particle moves further than `fastest` in a step.
    fn ghost_width(fastest: f64, steps: u32) -> f64;

    /// Returns the number of steps that ghosts should last: from 1 to `scenery.most`.
    fn best_steps(scenery: Scenery) -> u32;

    /// Returns the particles that a partner needs: their indices in `y`. These particles are within
    /// `width` of the partner's `strip`.
    ///
    /// The indices are in ascending order.
    fn choose(y: &[f64], strip: &Range<f64>, width: f64) -> Vec<u32>;

    /// Returns the pairs of a particle of this rank and a ghost within `reach`, in the order of the
    /// particles.
    fn pairs_across(own: Positions<'_>, ghosts: Positions<'_>, reach: f64) -> Vec<Pair>;

    /// Sends `sent[k]` to rank `partners[k]` and receives its positions in `received[k]`. Calls
    /// `meanwhile` once.
    fn exchange_positions(
        world: &SimpleCommunicator,
        partners: &[Rank],
        sent: &[Vec<f64>],
        received: &mut [Vec<f64>],
        meanwhile: impl FnOnce(),
    );

    /// Whether all ranks rebuild their lists before the next forces. The answer is the same on all
    /// ranks.
    ///
    /// The lists are rebuilt if `list_has_expired` on any rank, or if ghosts have expired on any
    /// rank. Ghosts were chosen up to the distance `width`, and since then a particle of the rank
    /// may have moved by `moved`.
    fn must_renew(
        world: &SimpleCommunicator,
        list_has_expired: bool,
        moved: f64,
        width: f64,
    ) -> bool;
}

/// The facts that determine the cheapest number of steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scenery {
    /// Distance that the fastest particle of all ranks moves in a step.
    pub fastest: f64,
    /// Number of particles per unit area where they are densest.
    pub density: f64,
    /// Height of a strip. The length of the strip along x does not matter.
    pub height: f64,
    /// Greatest number of steps that ghosts should last, at least 1. The lists of all ranks are
    /// expected to last this number of steps, and ghosts are chosen again when lists are rebuilt.
    pub most: u32,
}
