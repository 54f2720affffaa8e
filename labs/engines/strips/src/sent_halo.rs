//! Ghosts for several steps, whose positions are sent in each of them.

use std::ops::Range;

use mpi::Rank;
use mpi::topology::SimpleCommunicator;
use neighbour_list::kernels::{Pair, Positions};

use crate::partition::Partition;

/// How ghosts are chosen for several steps, and how their positions are sent in each of them.
pub trait Halo: Partition {
    /// How far from a strip its ghosts come that last `steps` steps, if no particle goes further than `fastest` in one.
    fn ghost_width(fastest: f64, steps: u32) -> f64;

    /// For how many steps ghosts should be chosen: from 1 to `scenery.most`.
    fn best_steps(scenery: Scenery) -> u32;

    /// The particles that a partner needs: the indices in `y`, ascending, of all no further than `width` from its
    /// `strip`.
    fn choose(y: &[f64], strip: &Range<f64>, width: f64) -> Vec<u32>;

    /// The pairs within `reach` of an own particle and a ghost, ascending in the own particle.
    fn pairs_across(own: Positions<'_>, ghosts: Positions<'_>, reach: f64) -> Vec<Pair>;

    /// Sends `sent[k]` to rank `partners[k]`, fills `received[k]` with what that rank sends, and calls `meanwhile` once.
    fn exchange_positions(
        world: &SimpleCommunicator,
        partners: &[Rank],
        sent: &[Vec<f64>],
        received: &mut [Vec<f64>],
        meanwhile: impl FnOnce(),
    );

    /// Whether all ranks rebuild their lists before the next forces, on all ranks the same: if on any of them its own
    /// `list_has_expired`, or its ghosts have, which were chosen `width` wide, since when an own particle may have
    /// `moved` so far.
    fn must_renew(
        world: &SimpleCommunicator,
        list_has_expired: bool,
        moved: f64,
        width: f64,
    ) -> bool;
}

/// The facts on which the cheapest number of steps depends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scenery {
    /// How far the fastest particle of all goes in a step.
    pub fastest: f64,
    /// Particles per area, where they stand closest.
    pub density: f64,
    /// Height of a strip; its length along x does not matter.
    pub height: f64,
    /// Steps that the lists of all ranks last, at least 1. Then ghosts are chosen again anyway.
    pub most: u32,
}
