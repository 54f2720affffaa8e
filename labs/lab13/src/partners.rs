//! Task 13.2: ranks that need ghosts from each other.

use mpi::Rank;
use strips::Strips;

/// Returns the ranks that exchange ghosts with `rank`, in ascending order.
///
/// They are all other ranks whose strip is at most `width`, a length, from the strip of `rank`.
/// Usually they are the previous rank and the next rank. But strips may be thinner than `width`,
/// and ghosts then go further than to the next rank. An empty strip has no particles: its rank
/// neither needs nor sends ghosts.
///
/// Every rank computes its partners alone, without a message. So the results of two ranks must
/// agree: rank a finds rank b exactly if b finds a.
///
/// Book: chapter 13, *Which ranks are partners*.
pub fn partners(strips: &Strips, rank: usize, width: f64) -> Vec<Rank> {
    todo!("task 13.2: the ranks within the width of the ghosts")
}
