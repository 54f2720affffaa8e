//! Task 5.8: everybody gets the scene.

use common::soft::{Particle, Scene};
use common_mpi::Wire;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::ROOT;

/// Sends the scene of the root to all ranks, and returns on each of them the side of the box and
/// all particles in id order. `scene` matters on the root only, and is there.
///
/// A broadcast ([`Root::broadcast_into`]) looks the same everywhere: the root's buffer is read, the
/// others' are overwritten. It has to have the right size before, so three of them are needed: the
/// number of particles (an `u64`), the side of the box (an `f64`), the particles.
///
/// All ranks call it together.
///
/// Book: chapter 5, *Bcast*.
pub fn broadcast(world: &SimpleCommunicator, scene: Option<&Scene>) -> (f64, Vec<Particle>) {
    let root = world.process_at_rank(ROOT);
    todo!("task 5.8: everybody gets the scene")
}
