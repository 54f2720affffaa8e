//! Tasks 5.4 and 5.6: to the root and back.

use common::soft::Particle;
use common_mpi::{Wire, displacements, split, total};
use mpi::Count;
use mpi::datatype::{Partition, PartitionMut};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::ROOT;

/// Collects at the root the `items` of each rank: returns there a list for each rank, in the order
/// of ranks, the root's own among them. On other ranks it returns no list.
///
/// The root does not know how much each rank has. So it takes two collective operations. First the
/// root gathers a number from each rank, `count`: [`Root::gather_into`], on the root
/// [`Root::gather_into_root`]. Then it gathers that many items from each:
/// [`Root::gather_varcount_into`], on the root [`Root::gather_varcount_into_root`]. The second one
/// fills a [`PartitionMut`]: a buffer for the items of all ranks, how many items each rank sends, and
/// where those of each rank begin ([`displacements`]). [`total`] and [`split`] help.
///
/// All ranks call it together, also those that have no items.
///
/// Book: chapter 5, *Gather*.
pub fn gather_at_root(world: &SimpleCommunicator, items: &[Wire]) -> Vec<Vec<Wire>> {
    let root = world.process_at_rank(ROOT);
    let count = items.len() as Count;
    todo!("task 5.4: from all ranks to the root")
}

/// Hands out the lists that the root has: returns `lists[k]` on rank k, on the root too. On other
/// ranks than the root `lists` is not read and may be empty.
///
/// The reverse of [`gather_at_root`]. First the root scatters to each rank the length of its list:
/// [`Root::scatter_into`], on the root [`Root::scatter_into_root`]. Then it scatters the items:
/// [`Root::scatter_varcount_into`] and [`Root::scatter_varcount_into_root`]. The root sends from a
/// [`Partition`] of one buffer, in which the lists stand one behind the other (`concat`).
///
/// All ranks call it together, also those that get nothing.
///
/// Book: chapter 5, *Scatter*.
pub fn scatter_from_root(world: &SimpleCommunicator, lists: &[Vec<Wire>]) -> Vec<Wire> {
    let root = world.process_at_rank(ROOT);
    let mut count: Count = 0;
    todo!("task 5.6: from the root to all ranks")
}

/// Copies those of all ranks' `own` particles with ids `first .. first + out.len()` into the root's `out`, in the
/// order of ids. All ranks call it together.
pub fn read_at_root(
    world: &SimpleCommunicator,
    own: impl Iterator<Item = Wire>,
    first: usize,
    out: &mut [Particle],
) {
    let wanted = first..first + out.len();
    let own: Vec<Wire> = own.filter(|wire| wanted.contains(&(wire.id as usize))).collect();
    for wire in gather_at_root(world, &own).iter().flatten() {
        out[wire.id as usize - first] = wire.into();
    }
}
