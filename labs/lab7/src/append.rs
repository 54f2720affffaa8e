//! Task 7.10: candidates of all workers in one array.

use hard_discs::{Candidate, LockedCount, SharedCount, Slots};

/// Appends a candidate to an array that all workers write into.
///
/// `count` is how many slots of `list` are used; they are the first ones. All workers call this at the same time: no
/// two may write into the same slot, and no slot below the count may stay empty. [`LockedCount::locked`] is the
/// critical section: while it runs, no other worker can touch the count. Between two of them another worker can. Do
/// no more in it than you must: all other workers wait for its end.
///
/// Book: chapter 7, *One list for all*.
pub fn append_locked(list: &Slots, count: &LockedCount, candidate: Candidate) {
    todo!("task 7.10: a slot of its own, from a counter behind a lock")
}

/// The same without a lock. A `load` and then a `store` are two steps, and another worker can come between them.
///
/// Book: chapter 7, *One list for all*.
pub fn append_atomic(list: &Slots, count: &SharedCount, candidate: Candidate) {
    todo!("task 7.10b: a slot of its own, from an atomic counter")
}
