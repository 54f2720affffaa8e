//! Questions about changes of bins under locks.

use std::panic::resume_unwind;
use std::sync::Arc;
use std::thread::{self, ScopedJoinHandle};

use common_threads::{LockOrder, Watch};
use lab4::{Bin, Change, Meter, Regions, change_bin};
use oracle::{Ask, Random, integers};

use super::bins::{filled, regions_of};

pub(crate) const BINS: usize = 12;

/// Draws changes of 132 of the 360 particles of 12 bins, from each bin to each other bin, in any
/// order.
fn drawn(random: &mut Random) -> Vec<Change> {
    let mut all = Vec::new();
    for from in 0..BINS {
        let mut numbers: Vec<u32> = (0..30).map(|k| (30 * from + k) as u32).collect();
        random.shuffle(&mut numbers);
        let targets = (0..BINS).filter(|to| *to != from);
        all.extend(targets.zip(numbers).map(|(to, particle)| Change { particle, from, to }));
    }
    random.shuffle(&mut all);
    all
}

/// Returns the bin of each of the 360 particles of 12 bins (-1 for no bin), and the number of
/// particles in all bins.
fn bins_of(regions: &mut Regions) -> Vec<f64> {
    let mut found = vec![-1.0; 30 * BINS];
    let mut all = 0;
    for (bin, inside) in (0..).zip(regions.parts_mut().flatten()) {
        all += inside.len();
        inside.iter().for_each(|particle| found[*particle as usize] = f64::from(bin));
    }
    [found, integers([all])].concat()
}

/// Asks for the bins of all particles. `right` returns the correct bin of each particle.
pub(crate) fn ask_bins(
    ask: &mut impl Ask,
    name: &str,
    regions: &mut Regions,
    right: impl Fn(u32) -> usize,
) {
    let question = format!(
        "{name}: (1) the bin of each of 360 particles, -1 for none, (2) the number of particles in all bins together"
    );
    ask.judge(
        &question,
        || bins_of(regions),
        |found| {
            for (particle, bin) in (0..360).zip(found) {
                let right = right(particle);
                if *bin != right as f64 {
                    return Err(format!(
                        "the bin of particle {particle}\n     found: {bin}\n  expected: {right}"
                    ));
                }
            }
            match found.get(360) {
                Some(360.0) => Ok(()),
                all => Err(format!(
                    "the number of particles in all bins together\n     found: {all:?}\n  expected: 360"
                )),
            }
        },
    );
}

/// Asks about changes one after the other: the locks that they take, and the bins of the particles.
pub(crate) fn one_by_one(random: &mut Random, ask: &mut impl Ask) {
    for each in [1, 3, 12] {
        let mut regions = filled(BINS, each);
        let order = Arc::new(LockOrder::default());
        let watch: Arc<dyn Watch> = order.clone();
        regions.watch(&watch);
        let mut meter = Meter::default();
        let changes = drawn(random);
        changes.iter().for_each(|change| change_bin(&regions, &mut meter, *change));
        let name = format!("12 bins in regions of {each}; 132 changes");
        let question =
            format!("{name}: (1) locks taken, (2) locks waited for, (3) most locks held at once");
        let counts =
            || integers([meter.locks as usize, meter.contended as usize, order.most_held()]);
        ask.exact(&question, counts, || {
            let two = changes.iter().filter(|change| change.from / each != change.to / each);
            integers([132 + two.count(), 0, if each == 12 { 1 } else { 2 }])
        });
        ask_bins(ask, &name, &mut regions, |particle| {
            let change = changes.iter().find(|change| change.particle == particle);
            change.map_or(particle as usize / 30, |change| change.to)
        });
    }
}

/// Asks about a bin and a particle with large numbers.
pub(crate) fn large_numbers(_: &mut Random, ask: &mut impl Ask) {
    let from = 65_537;
    let to = 69_999;
    let particle = u32::MAX - 1;
    let mut bins = vec![Bin::new(); 70_000];
    bins[from] = vec![5, particle];
    let mut regions = regions_of(7, &bins);
    let mut meter = Meter::default();
    change_bin(&regions, &mut meter, Change { particle, from, to });
    let found = || {
        let all: Vec<&mut Bin> = regions.parts_mut().flatten().collect();
        let inside = [&all[from], &all[to]].into_iter().flat_map(|bin| bin.iter());
        [meter.locks as f64].into_iter().chain(inside.map(|p| f64::from(*p))).collect()
    };
    let question = format!(
        "there are 70000 bins, and particle {particle} changes from bin {from} to bin {to}. Particle 5 is in the old \
         bin too: (1) number of locks taken, (2) the particles in the two bins"
    );
    ask.exact(&question, found, || vec![2.0, 5.0, f64::from(particle)]);
}

/// Asks about changes by several threads at the same time.
pub(crate) fn many_threads(random: &mut Random, ask: &mut impl Ask) {
    for each in [1, 3, 12] {
        let threads = 3 + random.below(9);
        let times = 20 + random.below(12);
        let Sent { mut regions, locks } = Sent::by(threads, times as u32, each);
        let name = format!(
            "12 bins in regions of {each}; {threads} threads together change the bin of each of 360 particles {times} \
             times"
        );
        let question = format!("{name}: locks taken");
        ask.exact(
            &question,
            || vec![locks as f64],
            || integers([if each == 12 { 360 * times } else { 720 * times }]),
        );
        ask_bins(ask, &name, &mut regions, |particle| sent_on(particle, times as u32));
    }
}

/// Returns the bin of a particle that began in bin p / 30 and was moved `times` times, by five bins
/// each time.
fn sent_on(particle: u32, times: u32) -> usize {
    ((particle / 30 + 5 * times) % 12) as usize
}

/// Twelve bins whose particles were moved repeatedly.
struct Sent {
    regions: Regions,
    /// Number of locks that all threads took.
    locks: u64,
}

impl Sent {
    /// Moves particles `times` times on each of `threads` threads. Each thread moves its part of
    /// the particles.
    fn by(threads: usize, times: u32, bins_each: usize) -> Self {
        let mut regions = filled(BINS, bins_each);
        let watch: Arc<dyn Watch> = Arc::new(LockOrder::default());
        regions.watch(&watch);
        let shared = &regions;
        let send = move |number: usize| {
            let mut meter = Meter::default();
            for round in 0..times {
                for particle in (number as u32..360).step_by(threads) {
                    let from = sent_on(particle, round);
                    let to = sent_on(particle, round + 1);
                    change_bin(shared, &mut meter, Change { particle, from, to });
                }
            }
            meter.locks
        };
        let locks = thread::scope(|scope| {
            let threads: Vec<_> =
                (0..threads).map(|number| scope.spawn(move || send(number))).collect();
            threads.into_iter().map(joined).sum()
        });
        Self { regions, locks }
    }
}

/// Returns a thread's result. A panic is passed on unchanged.
fn joined<T>(thread: ScopedJoinHandle<'_, T>) -> T {
    thread.join().unwrap_or_else(|panic| resume_unwind(panic))
}
