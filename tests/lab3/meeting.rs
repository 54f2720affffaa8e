//! Where threads meet: what shows that several share some work.

use std::ops::{Deref, DerefMut};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{self, ThreadId};
use std::time::{Duration, Instant};

use common::soft::{NoStatistics, Observer, Statistics};
use lab3::Worker;
use parking_lot::Mutex;

/// Where threads that are told of pairs meet: the first waits until `expected` have come, or until it
/// is clear that they never will.
pub(super) struct Meeting {
    expected: AtomicUsize,
    /// Each thread once, and how many threads its pool has.
    came: Mutex<Vec<(ThreadId, usize)>>,
    patience: Mutex<Option<Instant>>,
}

pub(super) static MEETING: Meeting = Meeting {
    expected: AtomicUsize::new(0),
    came: Mutex::new(Vec::new()),
    patience: Mutex::new(None),
};

impl Meeting {
    pub(super) fn begin(&self, threads: usize) {
        self.expected.store(threads, Ordering::SeqCst);
        self.came.lock().clear();
        *self.patience.lock() = None;
    }

    fn visit(&self) {
        let me = (thread::current().id(), rayon::current_num_threads());
        let mut came = self.came.lock();
        if !came.contains(&me) {
            came.push(me);
        }
        drop(came);
        let until = *self.patience.lock().get_or_insert(Instant::now() + Duration::from_secs(3));
        while self.came.lock().len() < self.expected.load(Ordering::SeqCst)
            && Instant::now() < until
        {
            thread::yield_now();
        }
    }

    /// How many threads came, and how many of them from a pool of `threads`.
    pub(super) fn end(&self, threads: usize) -> [usize; 2] {
        let came = self.came.lock();
        [came.len(), came.iter().filter(|(_, pool)| *pool == threads).count()]
    }
}

/// An observer that sends its thread to the meeting.
#[derive(Clone, Default)]
pub(super) struct Visitor;

impl Observer for Visitor {
    fn tested(&mut self, _pairs: u64) {
        MEETING.visit();
    }
    fn seen(&mut self, _r2: f64) {}
    fn merge(&mut self, _other: &Self) {
        MEETING.visit();
    }
    fn statistics(&self) -> Option<Statistics> {
        None
    }
}

/// A worker that sends the thread that moves its particles to the meeting.
pub(super) struct Moved(pub(super) Worker<NoStatistics>);

impl Deref for Moved {
    type Target = Worker<NoStatistics>;
    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl DerefMut for Moved {
    fn deref_mut(&mut self) -> &mut Self::Target {
        if !self.0.accelerations.is_empty() {
            MEETING.visit();
        }
        &mut self.0
    }
}

/// Counts the observers merged into it that were told of 150 pairs.
#[derive(Clone, Default)]
pub(super) struct OfOne {
    tested: u64,
    merged: u64,
}

impl Observer for OfOne {
    fn tested(&mut self, pairs: u64) {
        self.tested += pairs;
    }
    fn seen(&mut self, _r2: f64) {}
    fn merge(&mut self, other: &Self) {
        self.merged += u64::from(other.tested == 150);
    }
    fn statistics(&self) -> Option<Statistics> {
        Some(Statistics { navg: self.merged, ..Statistics::default() })
    }
}

/// How many observers are being merged at this moment, and how often a merge has waited.
static MERGING: [AtomicUsize; 2] = [AtomicUsize::new(0), AtomicUsize::new(0)];

/// Counts, and takes its time to merge: until another thread merges too, or some milliseconds.
#[derive(Clone, Default)]
pub(super) struct Slow(pub(super) u64);

impl Observer for Slow {
    fn tested(&mut self, pairs: u64) {
        self.0 += pairs;
    }
    fn seen(&mut self, _r2: f64) {}
    fn merge(&mut self, other: &Self) {
        let [inside, waits] = &MERGING;
        inside.fetch_add(1, Ordering::SeqCst);
        if waits.fetch_add(1, Ordering::SeqCst) < 20 {
            let until = Instant::now() + Duration::from_millis(20);
            while inside.load(Ordering::SeqCst) < 2 && Instant::now() < until {
                thread::yield_now();
            }
        }
        self.0 += other.0;
        inside.fetch_sub(1, Ordering::SeqCst);
    }
    fn statistics(&self) -> Option<Statistics> {
        Some(Statistics { pair_tests: self.0, ..Statistics::default() })
    }
}
