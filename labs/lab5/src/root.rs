//! Tasks 5.4 and 5.6: from all ranks to the root, and from the root to all ranks.

use common::soft::Particle;
use common_mpi::{Wire, displacements, split, total};
use mpi::Count;
use mpi::datatype::{Partition, PartitionMut};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::ROOT;

/// Collects the `items` of each rank at the root.
///
/// On the root, this returns one list for each rank, in the order of ranks, including the root's
/// own list. On the other ranks, it returns no lists.
///
/// The root does not know how many items each rank has, so two collective operations are needed:
///
/// - The root gathers `count` from each rank. Call [`Root::gather_into`], and on the root
///   [`Root::gather_into_root`].
/// - The root gathers the items of each rank. Call [`Root::gather_varcount_into`], and on the root
///   [`Root::gather_varcount_into_root`]. The root fills a [`PartitionMut`]: a buffer for the items
///   of all ranks, the number of items from each rank, and the index at which each rank's items
///   begin ([`displacements`]). [`total`] and [`split`] help with the buffer.
///
/// All ranks call this together, even ranks without items.
///
/// Book: chapter 5, *Gather*.
pub fn gather_at_root(world: &SimpleCommunicator, items: &[Wire]) -> Vec<Vec<Wire>> {
    let root = world.process_at_rank(ROOT);
    let count = items.len() as Count;
    todo!("task 5.4: from all ranks to the root")
}

/// Sends each rank its list from the root: rank k returns `lists[k]`. The root receives a list too.
///
/// Only the root reads `lists`; on the other ranks it may be empty.
///
/// This is the reverse of [`gather_at_root`]:
///
/// - The root scatters the length of its list to each rank. Call [`Root::scatter_into`], and on the
///   root [`Root::scatter_into_root`].
/// - The root scatters the items. Call [`Root::scatter_varcount_into`], and on the root
///   [`Root::scatter_varcount_into_root`]. The root sends from a [`Partition`] of one buffer that
///   contains all lists in sequence (`concat`).
///
/// All ranks call this together, even ranks with an empty list.
///
/// Book: chapter 5, *Scatter*.
pub fn scatter_from_root(world: &SimpleCommunicator, lists: &[Vec<Wire>]) -> Vec<Wire> {
    let root = world.process_at_rank(ROOT);
    let mut count: Count = 0;
    todo!("task 5.6: from the root to all ranks")
}

/// Copies the particles with ids `first .. first + out.len()` to the root's `out`, in id order.
///
/// `own` contains the particles of the calling rank. All ranks call this together.
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
