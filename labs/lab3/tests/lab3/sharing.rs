//! Questions about work that the threads of a pool share: does every thread do a part of it?

use std::ops::{Deref, DerefMut};

use common::soft::{CUTOFF, NoStatistics, Observer, Particle, Statistics};
use lab3::{BLOCK, Vanilla, Worker, in_order, pool, sum_and_move, under_a_lock};
use oracle::scenes::anywhere;
use oracle::{Ask, Random, Share};
use parking_lot::Mutex;
use solution2::VecBins;

/// The meeting place of the threads that do some of the work.
static MEETING: Share = Share::new();

/// A lock that gives the meeting to one question at a time.
static IN_USE: Mutex<()> = Mutex::new(());

fn does(units: u64) {
    MEETING.does(rayon::current_num_threads(), units);
}

/// Asks whether the threads of a pool share `units` units of work. [`does`] counts each unit.
fn shared(ask: &mut impl Ask, doing: &str, threads: usize, units: usize, work: impl FnOnce()) {
    let _in_use = IN_USE.lock();
    let question = format!(
        "a pool of {threads} threads {doing}, {units} units of work: for each thread that did some of the work, (1) \
         the number of threads of its pool, (2) the number of units that it did"
    );
    let found = || MEETING.record(threads, units as u64, work);
    ask.judge(&question, found, |found| {
        let done: f64 = found.iter().skip(1).step_by(2).sum();
        if 2.0 * done > 3.0 * units as f64 {
            return Err(format!(
                "{done} units of work were done, but the work has only {units} units"
            ));
        }
        Share::judge(threads, found)
    });
}

/// An observer that counts each force and each addition for the thread that computes it.
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

/// Asks about all pairs. Each pair is within the cutoff.
pub(crate) fn all_pairs(random: &mut Random, ask: &mut impl Ask) {
    let n = 120 + random.below(100);
    let scene = anywhere(random, n, 0.7 * CUTOFF, 1.0);
    for threads in [2, 4 + random.below(4)] {
        shared(ask, "sums the forces of all pairs", threads, n * n, || {
            let mut engine = Vanilla::<Visitor>::new(threads);
            engine.load(&scene);
            engine.sum_forces();
        });
    }
}

/// Asks about parts under a lock. A thread that adds delays all others, so the lock decides how
/// much each thread adds.
pub(crate) fn locked_parts(random: &mut Random, ask: &mut impl Ask) {
    let parts = vec![Visitor; (20 + random.below(20)) * BLOCK];
    let threads = 2 + random.below(2);
    shared(ask, "adds parts under a lock", threads, parts.len(), || {
        pool(threads).install(|| under_a_lock(&parts));
    });
}

/// Asks about blocks of parts, and about the sums of the blocks.
pub(crate) fn blocks(random: &mut Random, ask: &mut impl Ask) {
    let blocks = 20 + random.below(20);
    let parts = vec![Visitor; blocks * BLOCK];
    for threads in [2, 4 + random.below(2)] {
        shared(ask, "sums blocks of parts in order", threads, parts.len() + blocks, || {
            pool(threads).install(|| in_order(&parts));
        });
    }
}

/// A worker that counts its particles for the thread that moves them.
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

/// Returns `count` workers that share the rows of the bins.
fn share_rows<O: Observer>(bins: &VecBins, count: usize) -> impl Iterator<Item = Worker<O>> {
    let rows = bins.grid().rows();
    (0..count).map(move |k| Worker::new(k * rows / count..(k + 1) * rows / count))
}

/// Asks about workers that sum forces, and about workers that move particles.
pub(crate) fn workers(random: &mut Random, ask: &mut impl Ask) {
    let n = 150 + random.below(100);
    let scene = anywhere(random, n, 9.5 * CUTOFF, 1.0);
    let all = scene.particles();
    let near = |p: &Particle, q: &Particle| p.to(q).norm_squared() <= CUTOFF * CUTOFF;
    let pairs = all.iter().map(|p| all.iter().filter(|q| near(p, q)).count() - 1).sum();
    let mut bins = VecBins::of_scene(&scene, 1.0);
    for threads in [2, 3, 4 + random.below(5)] {
        bins.refill(all);
        let mut visitors: Vec<_> = share_rows::<Visitor>(&bins, threads).map(Box::new).collect();
        shared(ask, "sums the forces of workers", threads, pairs, || {
            pool(threads).install(|| sum_and_move(&mut visitors, &mut bins));
        });
        bins.refill(all);
        let mut workers: Vec<Moved> = share_rows(&bins, threads).map(Moved).collect();
        shared(ask, "moves the particles of workers", threads, n, || {
            pool(threads).install(|| sum_and_move(&mut workers, &mut bins));
        });
    }
}
