//! Queues whose callers are interrupted at the worst moment.

use std::iter::from_fn;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};

use lab7::{LockedCount, SharedCount, next_part, next_part_locked};

/// Between a load and whatever follows, another worker takes a part of its own: all parts of a loop over
/// 0..100, of 10 iterations each.
pub(super) fn between_load_and_store() -> Vec<Range<usize>> {
    with_another(|interruption| SharedCount::interrupted(interruption), next_part)
}

/// The same when the lock has just been given back.
pub(super) fn between_critical_sections() -> Vec<Range<usize>> {
    with_another(|interruption| LockedCount::interrupted(interruption), next_part_locked)
}

fn with_another<C: 'static>(
    count: impl FnOnce(Box<dyn Fn(&C) + Send + Sync>) -> C,
    next: fn(&C, usize, usize) -> Option<Range<usize>>,
) -> Vec<Range<usize>> {
    let (other, came) = (Arc::new(OnceLock::new()), AtomicBool::new(false));
    let others = Arc::clone(&other);
    let count = count(Box::new(move |count| {
        if !came.swap(true, Ordering::Relaxed) {
            others.get_or_init(|| next(count, 100, 10));
        }
    }));
    let parts = from_fn(|| next(&count, 100, 10)).take(20);
    let mut parts: Vec<_> = parts.collect();
    parts.extend(other.get().cloned().flatten());
    parts.sort_by_key(|part| part.start);
    parts
}
