//! Task 5.9: statistics of all ranks.

use common::soft::Statistics;
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::ROOT;

/// Returns the combined statistics of all ranks on the root, and `None` on the other ranks.
///
/// `own` contains the statistics of the rank's block. The result contains the least `dmin`, the sum
/// of all `davg`, the sum of all `navg` and the sum of all `pair_tests`.
///
/// Three reductions are enough, because the last two numbers can travel together as one slice. Call
/// [`Root::reduce_into`], and on the root [`Root::reduce_into_root`]. The operations are
/// [`SystemOperation::min`] and [`SystemOperation::sum`].
///
/// All ranks call this together.
///
/// Book: chapter 5, *Reduce*.
pub fn reduce(world: &SimpleCommunicator, own: &Statistics) -> Option<Statistics> {
    let root = world.process_at_rank(ROOT);
    todo!("task 5.9: statistics of all ranks")
}
