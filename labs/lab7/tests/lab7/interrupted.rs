//! Counters whose callers are interrupted at the worst moment.

use std::iter::from_fn;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};

use hard_discs::{Candidate, Hit, LockedCount, SharedCount, Slots};
use lab7::{append_atomic, append_locked, next_part};

/// Between a load and whatever follows, another worker takes a part of its own: all parts of a loop over
/// 0..100, of 10 iterations each.
pub(super) fn between_load_and_store() -> Vec<Range<usize>> {
    let other = Arc::new(OnceLock::new());
    let others = Arc::clone(&other);
    let next = SharedCount::interrupted(once(move |next| {
        others.get_or_init(|| next_part(next, 100, 10));
    }));
    let mut parts: Vec<_> = from_fn(|| next_part(&next, 100, 10)).take(20).collect();
    parts.extend(other.get().cloned().flatten());
    parts.sort_by_key(|part| part.start);
    parts
}

/// When the lock has just been given back, another worker appends a candidate of its own: the first discs of the
/// candidates in the list, 1, 2 and 3 if none is lost.
pub(super) fn appended_between_critical_sections() -> Vec<u32> {
    let list = Arc::new(Slots::default());
    let others = Arc::clone(&list);
    let count = LockedCount::interrupted(once(move |count| append_locked(&others, count, of(3))));
    append_locked(&list, &count, of(1));
    append_locked(&list, &count, of(2));
    in_order(&list, count.locked(|count| *count))
}

/// The same between a load and whatever follows.
pub(super) fn appended_between_load_and_store() -> Vec<u32> {
    let list = Arc::new(Slots::default());
    let others = Arc::clone(&list);
    let count = SharedCount::interrupted(once(move |count| append_atomic(&others, count, of(3))));
    append_atomic(&list, &count, of(1));
    append_atomic(&list, &count, of(2));
    // The other worker comes after a load, and here at the latest.
    count.load();
    in_order(&list, count.load())
}

fn once<C>(act: impl Fn(&C) + Send + Sync) -> impl Fn(&C) + Send + Sync {
    let came = AtomicBool::new(false);
    move |count| {
        if !came.swap(true, Ordering::Relaxed) {
            act(count);
        }
    }
}

fn of(disc: u32) -> Candidate {
    Candidate { time: 0.5, hit: Hit::Pair(disc, 9) }
}

fn in_order(list: &Slots, count: usize) -> Vec<u32> {
    let mut discs: Vec<_> = list.first(count).map(|candidate| candidate.hit.first()).collect();
    discs.sort_unstable();
    discs
}
