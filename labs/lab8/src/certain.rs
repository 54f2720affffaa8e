//! Task 8.10: which candidates are certain to happen.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use hard_disc_ranks::{Decisions, slots_of};
use solution7::order;

/// Takes every open candidate that is certain to happen, and drops those that cannot happen.
///
/// This is lab 7's choice ([`solution7::take_in_order`]) by a rank that does not have all
/// candidates. Look at the first candidate in the queue of each free disc, always at the earliest
/// of these first. It has three possible ends:
///
/// - *Dropped*: one of its discs is not free, so it cannot happen. In the queue of each free disc
///   where it stands first, [advance](hard_disc_ranks::Queues::advance); the candidate that is first there
///   now is looked at when it is the earliest.
/// - *Taken*: none of its discs `waits`, and it comes before the rival of each of them that has
///   one. Then no other candidate, from this rank or another, can come in between. Append it to
///   `taken` and mark its discs as not free.
/// - *Left open*: it may or may not happen, and its discs wait, since no later candidate of theirs
///   is certain before this one is decided. If one of its discs did not wait before, it is the
///   earliest open candidate of that disc, and other ranks may have to hear of it: append it to
///   `front`.
///
/// Empty `front` first: it still has the open candidates of the round before. `waits` is false for all
/// discs when you are called, and must be so again when you return. A candidate that is first in two
/// queues comes up twice; the second time its discs are taken or wait already, and nothing changes.
///
/// A [`BinaryHeap`] of [`Reverse`]d indices gives the earliest: a lower index comes earlier. To go
/// through [all](hard_disc_ranks::Queues::all) candidates instead would give the same result, but this is
/// called in every round, and a crowd has millions of candidates and a hundred rounds. Nearly all
/// of these candidates stand in a queue behind one that is left open, and the heap never meets
/// them.
///
/// A rival may be out of date, which does no harm: the candidates of other ranks only become fewer,
/// so a candidate that comes before an old rival also comes before all that are left.
///
/// Book: chapter 8, *What is certain*.
pub fn take_certain(decisions: &mut Decisions) {
    todo!("task 8.10: what is certain")
}
