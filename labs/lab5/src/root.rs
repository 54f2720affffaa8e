//! Tasks 5.4 and 5.6: to the root and back.

use common_mpi::Wire;
use mpi::Count;
use mpi::datatype::{Partition, PartitionMut};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::{ROOT, displacements, split, total};

/// Collects at the root what each rank has: returns there a list for each rank, in the order of
/// ranks, the root's own among them. On other ranks it returns nothing.
///
/// Nobody knows how much the others have. So it takes two collective operations: first the root
/// gathers a number from each rank ([`Root::gather_into`], on the root [`Root::gather_into_root`]),
/// then that many items from each ([`Root::gather_varcount_into`] and `…_into_root`). The second
/// one fills a [`PartitionMut`]: a buffer, how many items of each rank go into it, and where those
/// of each rank begin ([`displacements`]).
///
/// All ranks call it together.
///
/// Book: chapter 5, *Gather*.
pub fn gather_at_root(world: &SimpleCommunicator, items: &[Wire]) -> Vec<Vec<Wire>> {
    let root = world.process_at_rank(ROOT);
    let count = items.len() as Count;
    todo!("task 5.4: from everybody to the root")
}

/// Hands out what the root has for each rank: `lists[k]` is for rank k, and its return value
/// there. `lists` matters on the root only.
///
/// The reverse of [`gather_at_root`]: first the root scatters to each rank how much there is for
/// it, then that much. The root sends from a [`Partition`] of one buffer, so the lists must first
/// stand in one behind the other (`concat`).
///
/// All ranks call it together.
///
/// Book: chapter 5, *Scatter*.
pub fn scatter_from_root(world: &SimpleCommunicator, lists: &[Vec<Wire>]) -> Vec<Wire> {
    let root = world.process_at_rank(ROOT);
    let mut count: Count = 0;
    todo!("task 5.6: from the root to everybody")
}
