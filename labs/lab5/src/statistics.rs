//! Task 5.9: statistics of all ranks.

use common::soft::Statistics;
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::ROOT;

/// Combines the statistics of each rank's own block: returns those of the whole box on the root, and
/// `None` on the other ranks.
///
/// They are the least `dmin` of all ranks, the sum of all `davg`, the sum of all `navg` and that of
/// all `pair_tests`. That takes three reductions ([`Root::reduce_into`], on the root
/// [`Root::reduce_into_root`]), since the last two numbers can go together as one slice.
/// [`SystemOperation`] has `min()` and `sum()`.
///
/// All ranks call it together.
///
/// Book: chapter 5, *Reduce*.
pub fn reduce(world: &SimpleCommunicator, own: &Statistics) -> Option<Statistics> {
    let root = world.process_at_rank(ROOT);
    todo!("task 5.9: statistics of all ranks")
}
