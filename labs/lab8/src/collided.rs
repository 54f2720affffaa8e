//! Task 8.6: the discs that the master sends to a worker after a step.

use std::ops::Range;

use common::hard::Disc;
use hard_disc_ranks::DiscWire;
use solution5::Cut;
use solution7::Candidate;

/// Returns the collided discs of the blocks `held`: the worker cannot move these itself.
///
/// - `discs` are all discs, as they are after the step.
/// - `held` are the numbers of the worker's blocks.
/// - `taken` are the collisions of the step.
///
/// A disc that has not collided flies straight, so each worker that has it can move it. A disc that
/// has collided may have met a disc of a block that the worker does not have, so the worker cannot
/// compute its position. After each step, the master therefore sends the discs that were in a
/// collision of `taken`, and only these.
///
/// Look at each disc of a pair separately: a held block may contain both of them, one, or neither.
/// [`Cut::owner`] returns the block of a disc.
///
/// Book: chapter 8, *What a worker cannot know*.
pub fn collided(
    discs: &[Disc],
    blocks: &Cut,
    held: &[usize],
    taken: &[Candidate],
) -> Vec<DiscWire> {
    todo!("task 8.6: the discs that have collided")
}

/// Moves a worker's discs to the end of the previous step, then inserts the discs that `arrived`.
///
/// - `held` are the ranges of the worker's disc numbers.
/// - If `moves` is true, each held disc moves in a straight line for one step, whether it has
///   collided or not. A disc that has collided is among the discs that arrived, and is overwritten.
/// - `moves` is false if there was no previous step, or if all held discs arrive.
/// - Use exactly the sums `x + vx` and `y + vy`. The master computes the same sums, and the bits must
///   agree.
///
/// Book: chapter 8, *What a worker cannot know*.
pub fn update(discs: &mut [Disc], held: &[Range<usize>], moves: bool, arrived: &[DiscWire]) {
    todo!("task 8.6b: straight on, except for those that arrive")
}
