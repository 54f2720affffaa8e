//! Task 13.8: the steps of an epoch that are right.

use common::soft::CUTOFF;
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// Returns the number of steps of an epoch before the first step that may be wrong.
///
/// The first step is always right.
///
/// - `moves`: a number for each step taken, the greatest distance that a particle of any rank moved
///   in this step. There is at least one step.
/// - `width`: the depth with which ghosts were chosen, at least the cutoff. All numbers are
///   lengths.
///
/// [`deep_width`](crate::deep_width) assumed a greatest speed. Now the actual moves are known. In k
/// steps, forces are computed k times, and particles are moved k − 1 times before the last of these
/// computations. So the first k steps are right if k cutoffs plus twice the sum of the first k − 1
/// `moves` are at most `width`.
///
/// Book: chapter 13, *And if it was wrong*.
pub fn right_steps(moves: &[f64], width: f64) -> usize {
    todo!("task 13.8: how many steps are right")
}

/// Returns the number of steps that are right on all ranks, which is the same on every rank.
///
/// All ranks have taken `steps` steps. [`right_steps`] computes the number of right steps.
///
/// - `numbers`: the first `steps` numbers are the greatest distances that a particle of this rank
///   moved in each step. From the other numbers, the next epoch is planned. Replace each number
///   with the greatest number that any rank has at this index. A single reduction suffices for all
///   numbers.
/// - `width`: the depth with which ghosts were chosen, a length. It is the same on all ranks.
///
/// A rank knows the moves of its own particles. But an error on a rank comes from the particles of
/// another rank, which may have moved further. And all ranks must roll back together: a rank that
/// rolls back alone to an earlier step would get the ghosts of a later step.
///
/// Book: chapter 13, *And if it was wrong*.
pub fn confirm(world: &SimpleCommunicator, numbers: &mut [f64], steps: usize, width: f64) -> usize {
    todo!("task 13.8b: all ranks agree how many steps are right")
}
