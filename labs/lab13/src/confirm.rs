//! Task 13.8: whether the steps of an epoch stand.

use common::soft::CUTOFF;
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// How many steps of an epoch are right: all, or those before the first that may be wrong. At least
/// 1.
///
/// - `moves`: how far the particle that went furthest went, of all ranks, in each of the steps that
///   were taken, at least one.
/// - `width`: how deep the ghosts were chosen. At least the cutoff.
///
/// [`deep_width`](crate::deep_width) trusted that no particle would become faster than was foreseen.
/// Now it is known. In k steps forces are computed k times, and particles are moved k − 1 times before
/// the last of them: the first k steps are right if k cutoffs and twice the first k − 1 `moves` are
/// no more than `width`.
///
/// Book: chapter 13, *And if it was wrong*.
pub fn right_steps(moves: &[f64], width: f64) -> usize {
    todo!("task 13.8: how many steps are right")
}

/// How many of the `steps` steps that all ranks have taken are right on all of them
/// ([`right_steps`]): on every rank the same number.
///
/// - `said`: first how far the furthest particle of this rank went in each of the steps, then other
///   numbers, by which the next epoch is planned. Afterwards each is the greatest that any rank said.
/// - `width`: how deep ghosts were chosen, on all ranks the same.
///
/// A rank knows how far its own particles went. But an error on one rank comes from particles
/// of another, and these particles may have gone further. And all ranks must roll back, or none: a rank
/// that rolls back to an earlier step would get ghosts of a later one.
///
/// Book: chapter 13, *And if it was wrong*.
pub fn confirm(world: &SimpleCommunicator, said: &mut [f64], steps: usize, width: f64) -> usize {
    todo!("task 13.8b: all ranks agree how many steps are right")
}
