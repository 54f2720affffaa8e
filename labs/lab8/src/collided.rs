//! Task 8.6: what a worker must be told after a step.

use std::ops::Range;

use common::hard::Disc;
use hard_disc_ranks::DiscWire;
use solution5::Cut;
use solution7::Candidate;

/// The discs of the blocks `held` that have collided: those that a worker cannot move by itself.
///
/// A disc that has not collided flies straight, so each worker that has it can move it. A disc that has
/// collided may have met one of a block that the worker does not have; then the worker cannot know
/// where it is. So after each step the master sends the discs that were in a collision of `taken`, and
/// only these.
///
/// `discs` are all discs, as they are after the step. Of a pair both discs may be in held blocks, or
/// one, or none; look at each by itself. [`Cut::owner`] says which block a disc is in.
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

/// What a worker does with the master's message: takes its discs, those with numbers in `held`, to
/// the end of the step before, and then puts in those that `arrived`.
///
/// `moves` is false if there was no step before, or if all held discs arrive. Else each held disc flies
/// straight by (vx, vy), whether it has collided or not: a disc that has collided is among the arrived
/// ones and is overwritten. The sum is x + vx and nothing else, since the master does the same and bits
/// must agree.
///
/// Book: chapter 8, *What a worker cannot know*.
pub fn update(discs: &mut [Disc], held: &[Range<usize>], moves: bool, arrived: &[DiscWire]) {
    todo!("task 8.6b: straight on, except for those that arrive")
}
