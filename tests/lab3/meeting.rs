//! What tests and probe ask alike of work that several threads share.

use std::ops::{Deref, DerefMut};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use common::soft::{CUTOFF, NoStatistics, Observer, Particle, Simulation, Statistics};
use lab3::{BLOCK, Vanilla, Worker, in_order, pool, sum_and_move, under_a_lock};
use parking_lot::Mutex;
use solution2::VecBins;

use super::ask::Ask;
use super::{Share, anywhere};
use crate::Random;

/// Where threads come that do some of the work.
static MEETING: Share = Share::new();

fn does(units: u64) {
    MEETING.does(rayon::current_num_threads(), units);
}

/// An observer that counts whose work the forces and the additions are.
#[derive(Clone, Default)]
struct Visitor;

impl Observer for Visitor {
    fn tested(&mut self, _pairs: u64) {}
    fn seen(&mut self, _r2: f64) {
        does(1);
    }
    fn merge(&mut self, _other: &Self) {
        does(1);
    }
    fn statistics(&self) -> Option<Statistics> {
        None
    }
}

/// A worker that counts whose work the moves of its particles are.
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
            does(self.0.accelerations.len() as u64);
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

/// Whether all threads of a pool share work of so many units, each of which [`does`] counts.
fn shared(ask: Ask<'_>, doing: &str, threads: usize, units: usize, work: impl FnOnce()) {
    let _in_use = IN_USE.lock();
    let question = format!(
        "a pool of {threads} threads: how many {doing}, how many of these are the pool's, and does one thread do more \
         than two thirds of it (1)"
    );
    let found = MEETING.of(threads, units as u64, work);
    ask(&question, found, vec![threads as f64, threads as f64, 0.0]);
}

/// Threads that sum the forces of all pairs, each of which is within the cutoff, and an observer for each particle.
pub(super) fn all_pairs(random: &mut Random, ask: Ask<'_>) {
    let n = 120 + random.below(100);
    let scene = anywhere(random, n, 0.7 * CUTOFF, 1.0);
    for threads in [2, 4 + random.below(4)] {
        shared(ask, "sum forces", threads, n * n, || {
            let mut engine = Vanilla::<Visitor>::new(threads);
            engine.load(&scene);
            engine.sum_forces();
        });
    }
    let scene = anywhere(random, 150, 10.3 * CUTOFF, 1.0);
    let mut engine = Vanilla::<OfOne>::new(2);
    engine.load(&scene);
    engine.sum_forces();
    let alone = Simulation::statistics(&engine).map_or(0, |seen| seen.navg);
    let question = "of 150 observers, those that are told of the pairs of one particle; a sum of several \
                    depends on which thread comes first";
    ask(question, vec![alone as f64], vec![150.0]);
}

/// Threads that add parts under a lock, and that sum blocks of them; no addition is lost.
pub(super) fn parts(random: &mut Random, ask: Ask<'_>) {
    let found = pool(4).install(|| under_a_lock(&vec![Slow(1); 100]));
    let question = "100 parts of one under a lock, where additions take their time: the total, less if one \
                    thread overwrites what another adds";
    ask(question, vec![found.0 as f64], vec![100.0]);
    let blocks = 20 + random.below(20);
    let parts = vec![Visitor; blocks * BLOCK];
    // Who adds under a lock holds up all others: which thread adds how much is then the lock's affair.
    let threads = 2 + random.below(2);
    let locked = pool(threads);
    shared(ask, "add parts under a lock", threads, parts.len(), || {
        locked.install(|| under_a_lock(&parts));
    });
    for threads in [2, 4 + random.below(2)] {
        let pool = pool(threads);
        shared(ask, "sum blocks in order", threads, parts.len() + blocks, || {
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
    let n = 150 + random.below(100);
    let scene = anywhere(random, n, 9.5 * CUTOFF, 1.0);
    let all = scene.particles();
    let near = |p: &Particle, q: &Particle| p.to(q).norm_squared() <= CUTOFF * CUTOFF;
    let pairs = all.iter().map(|p| all.iter().filter(|q| near(p, q)).count() - 1).sum();
    let mut bins = VecBins::of_scene(&scene, 1.0);
    for threads in [2, 3, 4 + random.below(5)] {
        bins.refill(all);
        let mut visitors: Vec<_> = workers::<Visitor>(&bins, threads).map(Box::new).collect();
        shared(ask, "sum forces", threads, pairs, || {
            pool(threads).install(|| sum_and_move(&mut visitors, &mut bins));
        });
        bins.refill(all);
        let mut workers: Vec<Moved> = workers(&bins, threads).map(Moved).collect();
        shared(ask, "move particles", threads, n, || {
            pool(threads).install(|| sum_and_move(&mut workers, &mut bins));
        });
    }
}
