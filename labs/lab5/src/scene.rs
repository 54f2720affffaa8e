//! Task 5.8: all ranks get the scene.

use common::soft::{Particle, Scene};
use common_mpi::Wire;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::ROOT;

/// Broadcasts the root's scene: returns the side of the box and all particles in id order.
///
/// On the root, `scene` contains the scene ([`Scene::size`], [`Scene::particles`]). On the other
/// ranks, it is `None`. Every rank returns the same side and the same particles.
///
/// A broadcast ([`Root::broadcast_into`]) is the same call on all ranks: it reads the root's
/// buffer, and overwrites the buffers of all other ranks, whatever they contain. Every buffer must
/// have the right length before the call. So exactly three calls are needed: for the number of
/// particles (a `u64`), the side of the box (an `f64`), and the particles (a slice of [`Wire`]).
///
/// All ranks call this together.
///
/// Book: chapter 5, *Bcast*.
pub fn broadcast(world: &SimpleCommunicator, scene: Option<&Scene>) -> (f64, Vec<Particle>) {
    let root = world.process_at_rank(ROOT);
    todo!("task 5.8: all ranks get the scene")
}
