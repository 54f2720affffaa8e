//! What tests and probe ask alike of work that several threads share: they meet.

use std::ops::{Deref, DerefMut};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{self, ThreadId};
use std::time::{Duration, Instant};

use common::soft::{CUTOFF, NoStatistics, Observer, Simulation, Statistics};
use lab3::{BLOCK, Vanilla, Worker, in_order, pool, sum_and_move, under_a_lock};
use parking_lot::Mutex;
use solution2::VecBins;

use super::anywhere;
use super::ask::Ask;
use crate::Random;

/// Where threads that are told of pairs meet: the first waits until `expected` have come, or until it
/// is clear that they never will.
struct Meeting {
    expected: AtomicUsize,
    /// Each thread once, and how many threads its pool has.
    came: Mutex<Vec<(ThreadId, usize)>>,
    patience: Mutex<Option<Instant>>,
}

static MEETING: Meeting = Meeting {
    expected: AtomicUsize::new(0),
    came: Mutex::new(Vec::new()),
    patience: Mutex::new(None),
};

impl Meeting {
    fn begin(&self, threads: usize) {
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
    fn end(&self, threads: usize) -> [usize; 2] {
        let came = self.came.lock();
        [came.len(), came.iter().filter(|(_, pool)| *pool == threads).count()]
    }
}

/// An observer that sends its thread to the meeting.
#[derive(Clone, Default)]
struct Visitor;

impl Observer for Visitor {
    fn tested(&mut self, pairs: u64) {
        // Who looks at nothing does no work.
        if pairs > 0 {
            MEETING.visit();
        }
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
struct Moved(Worker<NoStatistics>);

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
struct OfOne {
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
struct Slow(u64);

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

/// Only one question at a time may use the meeting.
static IN_USE: Mutex<()> = Mutex::new(());

/// Whether all threads of a pool share the work, of which `Visitor` is told.
fn shared(ask: Ask<'_>, doing: &str, threads: usize, work: impl FnOnce()) {
    let _in_use = IN_USE.lock();
    MEETING.begin(threads);
    work();
    let came = MEETING.end(threads).map(|count| count as f64).to_vec();
    let question = format!(
        "a pool of {threads} threads: how many {doing}, and how many of these are the pool's"
    );
    ask(&question, came, vec![threads as f64; 2]);
}

/// Threads that sum the forces of all pairs, and an observer for each particle.
pub(super) fn all_pairs(random: &mut Random, ask: Ask<'_>) {
    let scene = anywhere(random, 150, 10.3 * CUTOFF, 1.0);
    for threads in [2, 5] {
        shared(ask, "sum forces", threads, || {
            let mut engine = Vanilla::<Visitor>::new(threads);
            engine.load(&scene);
            engine.sum_forces();
        });
    }
    let mut engine = Vanilla::<OfOne>::new(2);
    engine.load(&scene);
    engine.sum_forces();
    let alone = Simulation::statistics(&engine).map_or(0, |seen| seen.navg);
    let question = "of 150 observers, those that are told of the pairs of one particle; a sum of several \
                    depends on which thread comes first";
    ask(question, vec![alone as f64], vec![150.0]);
}

/// Threads that add parts under a lock, and that sum blocks of them; no addition is lost.
pub(super) fn parts(ask: Ask<'_>) {
    let found = pool(4).install(|| under_a_lock(&vec![Slow(1); 100]));
    let question = "100 parts of one under a lock, where additions take their time: the total, less if one \
                    thread overwrites what another adds";
    ask(question, vec![found.0 as f64], vec![100.0]);
    let parts = vec![Visitor; 20 * BLOCK];
    for threads in [2, 3] {
        let pool = pool(threads);
        shared(ask, "add parts under a lock", threads, || {
            pool.install(|| under_a_lock(&parts));
        });
        shared(ask, "sum blocks in order", threads, || {
            pool.install(|| in_order(&parts));
        });
    }
}

/// Threads that sum forces, and that move, of workers with some rows each.
pub(super) fn workers(random: &mut Random, ask: Ask<'_>) {
    fn workers<O: Observer>(bins: &VecBins, count: usize) -> impl Iterator<Item = Worker<O>> {
        let rows = bins.grid().rows();
        let cut = move |worker| worker * rows / count;
        (0..count).map(move |k| Worker::new(cut(k)..cut(k + 1)))
    }
    let scene = anywhere(random, 150, 9.5 * CUTOFF, 1.0);
    let mut bins = VecBins::of_scene(&scene, 1.0);
    for threads in [2, 3, 5] {
        bins.refill(scene.particles());
        let mut visitors: Vec<_> = workers::<Visitor>(&bins, threads).map(Box::new).collect();
        shared(ask, "sum forces", threads, || {
            pool(threads).install(|| sum_and_move(&mut visitors, &mut bins));
        });
        bins.refill(scene.particles());
        let mut workers: Vec<Moved> = workers(&bins, threads).map(Moved).collect();
        shared(ask, "move particles", threads, || {
            pool(threads).install(|| sum_and_move(&mut workers, &mut bins));
        });
    }
}
