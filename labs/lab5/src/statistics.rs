//! Task 5.9: statistics of all ranks.

use common::soft::Statistics;
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::ROOT;

/// Combines what each rank saw in its own block: returns the statistics of the whole box on the
/// root and nothing on the others.
///
/// The least of all `dmin`, the sum of all `davg`, the sum of all `navg` and `pair_tests`: three
/// reductions ([`Root::reduce_into`], on the root [`Root::reduce_into_root`]), one of them of a pair of
/// numbers at once. [`SystemOperation`] has `min()` and `sum()`.
///
/// All ranks call it together.
///
/// Book: chapter 5, *Reduce*.
pub fn reduce(world: &SimpleCommunicator, own: &Statistics) -> Option<Statistics> {
    let root = world.process_at_rank(ROOT);
    todo!("task 5.9: statistics of all ranks")
}
