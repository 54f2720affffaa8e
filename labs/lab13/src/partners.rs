//! Task 13.2: which ranks need ghosts of each other.

use mpi::Rank;
use strips::Strips;

/// The ranks that need ghosts of `rank` and send it theirs: all other ranks whose strip is no
/// further than `width` from that of `rank` (at `width` is not further), in ascending order.
///
/// Mostly they are the rank before and the rank after. But strips may be thinner than `width`,
/// and then ghosts go further than to the next one. An empty strip has no particles: its rank
/// needs no ghosts and has none to send.
///
/// Every rank finds its own partners by itself, without a message. So a must find b exactly if
/// b finds a.
///
/// Book: chapter 13, *Which ranks are partners*.
pub fn partners(strips: &Strips, rank: usize, width: f64) -> Vec<Rank> {
    todo!("task 13.2: the ranks within the width of the ghosts")
}
