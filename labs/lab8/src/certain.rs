//! Task 8.10: the candidates that are certain to happen.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use hard_disc_ranks::{Decisions, slots_of};
use solution7::order;

/// Takes every open candidate that is certain to happen, and drops every candidate that cannot
/// happen.
///
/// This is lab 7's choice ([`solution7::take_in_order`]), made by a rank that does not have all
/// candidates. The next candidate to look at is always the earliest of the candidates that are
/// first in the queue of a free disc.
///
/// The *rival* of a disc is the disc's earliest open candidate on other ranks, as far as this rank
/// knows. A disc may have no rival.
///
/// There are three cases:
///
/// - *Dropped*: one of the candidate's discs is not free, so it cannot happen. If its other disc is
///   still free, and the candidate is first in that disc's queue,
///   [advance](hard_disc_ranks::Queues::advance) that queue. The queue then has a new first
///   candidate, which you also look at, in its turn.
/// - *Taken*: `waits` is false for all its discs, and the candidate comes before the rival of each
///   of its discs. No other candidate of these discs, on this rank or another rank, can then come
///   before it. Append it to `taken`, and mark its discs as not free.
/// - *Left open*: it may or may not happen. Let its discs wait, because no later candidate of these
///   discs is certain until this candidate is decided. If one of the discs did not wait before, the
///   candidate is the earliest open candidate of that disc. Other ranks may need to know it, so
///   append it to `front`.
///
/// Empty `front` first: it still contains the open candidates of the previous round. At the start,
/// `waits` is false for all discs. It must be false for all discs again when you return. A
/// candidate that is first in two queues comes up twice. The second time, its discs are already
/// taken or waiting, and nothing changes.
///
/// A [`BinaryHeap`] of [`Reverse`]d indices yields the earliest candidate, because a candidate with
/// a lower index is earlier. A loop over [all](hard_disc_ranks::Queues::all) candidates would give
/// the same result. But this function is called in every round, and a crowd has millions of
/// candidates and a hundred rounds. Nearly all of these candidates are in a queue behind an open
/// candidate, and never enter the heap.
///
/// A rival may be out of date. This does no harm, because the other ranks only lose open
/// candidates. So a candidate that comes before an old rival of a disc also comes before all
/// candidates of this disc that are still open on the other ranks.
///
/// Book: chapter 8, *What is certain*.
pub fn take_certain(decisions: &mut Decisions) {
    todo!("task 8.10: what is certain")
}
