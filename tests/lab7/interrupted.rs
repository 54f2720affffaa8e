//! What tests and probe ask alike about counters whose callers are interrupted at the worst moment.

use std::iter::from_fn;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, OnceLock};

use hard_discs::{Candidate, Hit, LockedCount, SharedCount, Slots};
use lab7::{append_atomic, append_locked, next_part};

use super::ask::Ask;

/// What is done the `nth` time, from 0.
fn only<C>(nth: usize, act: impl Fn(&C) + Send + Sync) -> impl Fn(&C) + Send + Sync {
    let times = AtomicUsize::new(0);
    move |count| {
        if times.fetch_add(1, Ordering::Relaxed) == nth {
            act(count);
        }
    }
}

/// Between a load and whatever follows, another worker takes a part of its own: all parts of a loop over
/// 0..100, of 10 iterations each.
pub(super) fn parts(ask: Ask<'_>) {
    for nth in 0..12 {
        let other = Arc::new(OnceLock::new());
        let others = Arc::clone(&other);
        let next = SharedCount::interrupted(only(nth, move |next| {
            others.get_or_init(|| next_part(next, 100, 10));
        }));
        let mut parts: Vec<_> = from_fn(|| next_part(&next, 100, 10)).take(20).collect();
        parts.extend(other.get().cloned().flatten());
        parts.sort_by_key(|part| part.start);
        let found = parts.iter().flat_map(|part| [part.start as f64, part.end as f64]).collect();
        let right = (0..10).flat_map(|k| [10.0 * f64::from(k), 10.0 * f64::from(k) + 10.0]);
        let question = format!(
            "100 iterations in chunks of 10, another worker takes one after load {nth}: begin and end of each part"
        );
        ask(&question, found, right.collect());
    }
}

/// When the lock has just been given back, another worker appends a candidate of its own; and none has been written
/// before, while all others waited for the lock.
pub(super) fn appends_locked(ask: Ask<'_>) {
    let (list, early) = (Arc::new(Slots::default()), Arc::new(OnceLock::new()));
    let (others, written) = (Arc::clone(&list), Arc::clone(&early));
    let count = LockedCount::interrupted(only(0, move |count| {
        written.get_or_init(|| first_discs(&others, 1));
        append_locked(&others, count, of(3));
    }));
    append_locked(&list, &count, of(1));
    append_locked(&list, &count, of(2));
    let question = "three candidates appended, one of them by another worker when the lock was free: which discs";
    ask(question, first_discs(&list, count.locked(|count| *count)), vec![1.0, 2.0, 3.0]);
    let question = "what stands in the list when the lock has just been given back for the first time: disc, 0 for none";
    ask(question, early.get().cloned().unwrap_or_default(), vec![0.0]);
}

/// Another worker appends a candidate between a load and whatever follows.
pub(super) fn appends_atomic(ask: Ask<'_>) {
    for nth in 0..3 {
        let list = Arc::new(Slots::default());
        let others = Arc::clone(&list);
        let other = only(nth, move |count| append_atomic(&others, count, of(3)));
        let count = SharedCount::interrupted(other);
        append_atomic(&list, &count, of(1));
        append_atomic(&list, &count, of(2));
        // Who does not load is interrupted here.
        (0..3).for_each(|_| _ = count.load());
        let question = format!(
            "three candidates appended, one of them by another worker after load {nth}: which discs"
        );
        ask(&question, first_discs(&list, count.load()), vec![1.0, 2.0, 3.0]);
    }
}

fn of(disc: u32) -> Candidate {
    Candidate { time: 0.5, hit: Hit::Pair(disc, 9) }
}

/// The first discs of the candidates in the list, in ascending order.
fn first_discs(list: &Slots, count: usize) -> Vec<f64> {
    let mut discs: Vec<_> =
        list.first(count).map(|candidate| f64::from(candidate.hit.first())).collect();
    discs.sort_by(f64::total_cmp);
    discs
}
