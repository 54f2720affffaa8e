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
    // task 5.8: all ranks get the scene
    let (mut n, mut size) = scene.map_or((0, 0.0), |scene| (scene.len() as u64, scene.size()));
    root.broadcast_into(&mut n);
    root.broadcast_into(&mut size);
    let mut wires: Vec<Wire> =
        scene.map_or_else(Vec::new, |scene| scene.particles().iter().map(Wire::from).collect());
    wires.resize(n as usize, Wire::default());
    root.broadcast_into(&mut wires[..]);
    (size, wires.iter().map(Particle::from).collect())
    // end 5.8
}
