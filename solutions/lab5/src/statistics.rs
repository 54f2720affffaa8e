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
    // task 5.9: statistics of all ranks
    let counts = [own.navg, own.pair_tests];
    if world.rank() != ROOT {
        root.reduce_into(&own.dmin, SystemOperation::min());
        root.reduce_into(&own.davg, SystemOperation::sum());
        root.reduce_into(&counts[..], SystemOperation::sum());
        return None;
    }
    let mut all = Statistics::default();
    let mut sums = [0; 2];
    root.reduce_into_root(&own.dmin, &mut all.dmin, SystemOperation::min());
    root.reduce_into_root(&own.davg, &mut all.davg, SystemOperation::sum());
    root.reduce_into_root(&counts[..], &mut sums[..], SystemOperation::sum());
    [all.navg, all.pair_tests] = sums;
    Some(all)
    // end 5.9
}
