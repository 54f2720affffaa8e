//! Questions about counts that two workers share: tasks 7.8 and 7.10.
//!
//! The first worker is interrupted before and after it changes the count, or after it has released
//! a lock. At that point the other worker does all of its own work on the count. Therefore a correct
//! program gives the same result as two threads that meet at the worst moment, and a wrong program
//! is caught in every run. Reads are not interrupted, because a submission could use up the
//! interruptions with reads that it does not need.

use std::iter::from_fn;
use std::ops::Range;
use std::sync::atomic::Ordering::Relaxed;
use std::sync::atomic::{AtomicBool, AtomicU32, AtomicUsize};
use std::sync::{Arc, Mutex, OnceLock, mpsc};
use std::thread;
use std::time::Duration;

use hard_discs::{Candidate, Hit, LockedCount, SharedCount, Slots};
use lab7::{append_atomic, append_locked, next_part};
use oracle::{Ask, Random, integers, truth};

/// Time that a worker waits for another worker that may never come.
const PATIENCE: Duration = Duration::from_secs(10);

/// Places at which the first worker is interrupted, among all possible places.
#[derive(Clone, Copy)]
enum Places {
    /// A single place, counted from 0.
    Only(usize),
    /// One place in `number`, at random.
    OneIn { number: usize, seed: u64 },
}

impl Places {
    /// Draws each of the first places alone; in a long run also all places and a few.
    fn drawn(random: &mut Random, first: usize) -> Vec<(Self, bool)> {
        let mut all: Vec<(Self, bool)> =
            (0..first).map(|place| (Self::Only(place), false)).collect();
        for number in [1, 2, 10, 100, 1000] {
            all.push((Self::OneIn { number, seed: random.bits() }, true));
        }
        all
    }

    fn include(self, place: usize) -> bool {
        match self {
            Self::Only(only) => place == only,
            Self::OneIn { number, seed } => Random::new(seed ^ place as u64).below(number) == 0,
        }
    }

    fn words(self) -> String {
        match self {
            Self::Only(place) => format!("at interruption point {place} only, counted from 0"),
            Self::OneIn { number, .. } => {
                format!("at one in {number} of the interruption points")
            }
        }
    }

    /// Returns a function that calls `act` at these places. Calls from within `act` have no effect.
    fn interrupt<C>(self, act: impl Fn(&C) + Send + Sync) -> impl Fn(&C) + Send + Sync {
        let place = AtomicUsize::new(0);
        let is_at_work = AtomicBool::new(false);
        move |count| {
            if !is_at_work.swap(true, Relaxed) {
                if self.include(place.fetch_add(1, Relaxed)) {
                    act(count);
                }
                is_at_work.store(false, Relaxed);
            }
        }
    }
}

/// Asks two workers for all parts of a loop.
pub(crate) fn interrupted_queue(random: &mut Random, ask: &mut impl Ask) {
    for (places, is_long) in Places::drawn(random, 40) {
        let n = if is_long { 20_000 + 10 * random.below(2) } else { 100 };
        let question = format!(
            "{n} iterations in parts of 10. A second worker takes a part each time the first worker is interrupted, \
             {}: the start and end of each part that the first or the second worker takes",
            places.words()
        );
        ask.exact(
            &question,
            || {
                integers(
                    parts_of_two(n, places).into_iter().flat_map(|part| [part.start, part.end]),
                )
            },
            || integers((0..n).step_by(10).flat_map(|start| [start, start + 10])),
        );
    }
}

/// Returns the parts of 10 iterations that two workers take, in ascending order.
fn parts_of_two(n: usize, places: Places) -> Vec<Range<usize>> {
    let others = Arc::new(Mutex::new(Vec::new()));
    let taken = Arc::clone(&others);
    let next = SharedCount::interrupted(places.interrupt(move |next| {
        taken
            .lock()
            .expect("no worker panics while it holds this lock")
            .extend(next_part(next, n, 10));
    }));
    // Stops a queue that hands out parts forever.
    let mut parts: Vec<Range<usize>> = from_fn(|| next_part(&next, n, 10)).take(2 * n).collect();
    parts.append(&mut others.lock().expect("as above"));
    parts.sort_unstable_by_key(|part| (part.start, part.end));
    parts
}

/// The first number of the candidates that the other worker appends.
const OTHERS: u32 = 1_000_000;

/// A list that two workers append to, with a record of the other worker's candidates.
#[derive(Default)]
struct SharedList {
    list: Slots,
    others: AtomicU32,
    /// Whether the first worker has finished. The other worker then appends nothing more.
    has_ended: AtomicBool,
}

impl SharedList {
    /// Returns the next candidate of the other worker.
    fn next(&self) -> Option<Candidate> {
        (!self.has_ended.load(Relaxed)).then(|| of(OTHERS + self.others.fetch_add(1, Relaxed)))
    }

    /// Returns the number of the other worker's candidates, followed by the first discs of the
    /// list. The latter are the first discs of the first `count` candidates, in ascending order.
    fn numbers(&self, count: usize) -> Vec<f64> {
        let mut discs: Vec<u32> = self.list.first(count).map(|c| c.hit.first()).collect();
        discs.sort_unstable();
        [self.others.load(Relaxed)].into_iter().chain(discs).map(f64::from).collect()
    }
}

fn of(disc: u32) -> Candidate {
    Candidate { time: 0.5, hit: Hit::Pair(disc, u32::MAX) }
}

/// Checks that the list holds candidates 1 to `own` and as many of the other worker's candidates as
/// reported.
fn holds_all(found: &[f64], own: u32) -> Result<(), String> {
    let Some((&others, discs)) = found.split_first() else {
        return Err("the answer is empty".into());
    };
    let right = (1..=own).chain((OTHERS..).take(others as usize)).map(f64::from);
    let missing = right.clone().find(|disc| !discs.contains(disc));
    match missing {
        Some(disc) => Err(format!("the candidate of disc {disc} is not in the list")),
        None if discs.len() > right.count() => {
            Err(format!("too many slots are in use: {}", discs.len()))
        }
        None => Ok(()),
    }
}

/// Returns the question about a list of two workers.
fn appended(own: u32, how: &str, places: Places) -> String {
    format!(
        "one worker appends the candidates of discs 1 to {own} {how}. A second worker appends one candidate each time \
         the first worker is interrupted, {}. It begins with the candidate of disc {OTHERS}, and continues with the \
         next disc each time: (1) number of candidates that the second worker has appended, (2) the first disc of \
         each candidate in the list, in ascending order",
        places.words()
    )
}

/// Asks about appending while another worker appends each time the lock has been released.
pub(crate) fn interrupted_lock(random: &mut Random, ask: &mut impl Ask) {
    for (places, is_long) in Places::drawn(random, 6) {
        let own = if is_long { 2000 } else { 2 };
        let found = || {
            let shared = Arc::new(SharedList::default());
            let others = Arc::clone(&shared);
            let count = LockedCount::interrupted(places.interrupt(move |count| {
                others.next().into_iter().for_each(|new| append_locked(&others.list, count, new));
            }));
            (1..=own).for_each(|disc| append_locked(&shared.list, &count, of(disc)));
            shared.has_ended.store(true, Relaxed);
            shared.numbers(count.locked(|count| *count))
        };
        let question = appended(own, "under a lock", places);
        ask.judge(&question, found, |found| holds_all(found, own));
    }
}

/// Asks about appending while another worker appends before and after each change of the count.
pub(crate) fn interrupted_count(random: &mut Random, ask: &mut impl Ask) {
    for (places, is_long) in Places::drawn(random, 6) {
        let own = if is_long { 2000 } else { 2 };
        let found = || {
            let shared = Arc::new(SharedList::default());
            let others = Arc::clone(&shared);
            let count = SharedCount::interrupted(places.interrupt(move |count| {
                others.next().into_iter().for_each(|new| append_atomic(&others.list, count, new));
            }));
            (1..=own).for_each(|disc| append_atomic(&shared.list, &count, of(disc)));
            shared.has_ended.store(true, Relaxed);
            shared.numbers(count.load())
        };
        let question = appended(own, "without a lock", places);
        ask.judge(&question, found, |found| holds_all(found, own));
    }
}

/// Asks about another worker that appends in the middle of an append, which is possible only
/// without a lock.
pub(crate) fn no_lock(_: &mut Random, ask: &mut impl Ask) {
    let question = "one worker appends without a lock. A second worker appends when the first is about to add to the \
                    count: 1 if the second worker finishes before the first continues, 0 if the second must wait";
    ask.exact(question, || vec![truth(finishes_in_between())], || vec![1.0]);
}

fn finishes_in_between() -> bool {
    let (go, come) = mpsc::channel();
    let (finished, done) = mpsc::channel();
    // The other worker is not interrupted.
    let channels = Mutex::new(Some((go, done)));
    let in_time = Arc::new(AtomicBool::new(false));
    let is_done = Arc::clone(&in_time);
    let count = SharedCount::interrupted(move |_: &SharedCount| {
        let first = channels.lock().expect("no worker panics while it holds this lock").take();
        if let Some((go, done)) = first {
            _ = go.send(());
            is_done.store(done.recv_timeout(PATIENCE).is_ok(), Relaxed);
        }
    });
    let list = Slots::default();
    thread::scope(|scope| {
        scope.spawn(|| append_atomic(&list, &count, of(1)));
        if come.recv_timeout(PATIENCE).is_ok() {
            append_atomic(&list, &count, of(2));
            _ = finished.send(());
        }
    });
    in_time.load(Relaxed)
}

/// Checks that candidates are not written under the lock, because all other workers wait for the
/// lock.
pub(crate) fn short_lock(_: &mut Random, ask: &mut impl Ask) {
    let question = "the candidate of disc 1 is the first that is appended under a lock: the disc in slot 0 when the \
                    lock has been released and the count is 1, or 0 if the slot is not written yet";
    ask.exact(question, || vec![written_under_the_lock()], || vec![0.0]);
}

fn written_under_the_lock() -> f64 {
    let list = Arc::new(Slots::default());
    let written = Arc::new(OnceLock::new());
    let (seen, first) = (Arc::clone(&list), Arc::clone(&written));
    let always = Places::OneIn { number: 1, seed: 0 };
    let count = LockedCount::interrupted(always.interrupt(move |count: &LockedCount| {
        if count.locked(|count| *count) == 1 {
            first.get_or_init(|| seen.first(1).map(|c| f64::from(c.hit.first())).sum());
        }
    }));
    append_locked(&list, &count, of(1));
    written.get().copied().unwrap_or(f64::NAN)
}
