//! Data of all ranks.

use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// For each of several numbers of a rank: the mean over all ranks, and the greatest. All ranks call
/// it together; only the root, rank 0, gets the answer.
pub(crate) fn mean_and_greatest<const N: usize>(
    own: [f64; N],
    world: &SimpleCommunicator,
) -> Option<[(f64, f64); N]> {
    let (mut sum, mut greatest) = ([0.0; N], [0.0; N]);
    let root = world.process_at_rank(0);
    if world.rank() != 0 {
        root.reduce_into(&own, SystemOperation::sum());
        root.reduce_into(&own, SystemOperation::max());
        return None;
    }
    root.reduce_into_root(&own, &mut sum, SystemOperation::sum());
    root.reduce_into_root(&own, &mut greatest, SystemOperation::max());
    let ranks = f64::from(world.size());
    Some(std::array::from_fn(|k| (sum[k] / ranks, greatest[k])))
}
