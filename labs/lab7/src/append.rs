//! Task 7.10: the candidates of all workers in one array.

use hard_discs::{Candidate, LockedCount, SharedCount, Slots};

/// Appends a candidate to an array into which all workers write.
///
/// - `count` is the number of used slots, which are the first slots of `list`.
/// - All workers call this at the same time. Two workers may never write into the same slot, and no
///   slot below the count may stay empty.
/// - [`LockedCount::locked`] is the critical section: while it runs, no other worker can access the
///   count. Between two critical sections, another worker can change it.
/// - Do no more in the critical section than you must, because all other workers wait for it to
///   end.
///
/// Book: chapter 7, *One list for all*.
pub fn append_locked(list: &Slots, count: &LockedCount, candidate: Candidate) {
    todo!("task 7.10: a slot of its own, from a counter behind a lock")
}

/// Appends a candidate to an array into which all workers write, without a lock.
///
/// This does the same as [`append_locked`]. A `load` followed by a `store` is two operations:
/// another worker can change the count between them.
///
/// Book: chapter 7, *One list for all*.
pub fn append_atomic(list: &Slots, count: &SharedCount, candidate: Candidate) {
    todo!("task 7.10b: a slot of its own, from an atomic counter")
}
