//! Task 5.8: all ranks get the scene.

use common::soft::{Particle, Scene};
use common_mpi::Wire;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::ROOT;

/// Sends the scene of the root to all ranks, and returns on each of them the side of the box and
/// all particles in id order. `scene` is there on the root ([`Scene::size`], [`Scene::particles`]); on
/// other ranks it is `None`, and their buffers begin with any values.
///
/// A broadcast ([`Root::broadcast_into`]) is the same call on all ranks: the root's buffer is read,
/// those of all other ranks are overwritten. A buffer must have the right length before the call.
/// So it takes three calls, and no more: the number of particles (a `u64`), the side of the box (an `f64`), and then
/// the particles, as a slice of [`Wire`].
///
/// All ranks call it together.
///
/// Book: chapter 5, *Bcast*.
pub fn broadcast(world: &SimpleCommunicator, scene: Option<&Scene>) -> (f64, Vec<Particle>) {
    let root = world.process_at_rank(ROOT);
    todo!("task 5.8: all ranks get the scene")
}
