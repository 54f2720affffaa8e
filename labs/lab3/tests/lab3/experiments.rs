//! Experiments that print tables for the book. They run only if they are named.

use std::collections::HashSet;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use common::soft::Observer;
use crossbeam_utils::CachePadded;
use lab3::{Barrier, in_order, pool, under_a_lock, with_atomics};
use oracle::nanoseconds_each;
use solution1::Tally;

use super::reductions::{parts, statistics};

#[test]
#[ignore = "an experiment: prints a table"]
fn experiment_reductions() {
    const COUNT: usize = 1 << 18;
    let tallies = parts(COUNT);
    let statistics: Vec<_> = tallies.iter().map(statistics).collect();
    println!("threads  one lock  atomics  in order   [ns a part]   different sums in 9 rounds");
    for threads in [1, 2, 4, 8] {
        let pool = pool(threads);
        let mut sums: [HashSet<u64>; 3] = Default::default();
        let davg = |tally: Tally| {
            tally.statistics().expect("the engine was built with statistics").davg.to_bits()
        };
        let times = [
            nanoseconds_each(COUNT, || {
                sums[0].insert(davg(pool.install(|| under_a_lock(&tallies))));
            }),
            nanoseconds_each(COUNT, || {
                sums[1].insert(pool.install(|| with_atomics(&statistics)).davg.to_bits());
            }),
            nanoseconds_each(COUNT, || {
                sums[2].insert(davg(pool.install(|| in_order(&tallies))));
            }),
        ];
        let [lock, atomics, order] = times;
        let sums = sums.map(|sums| sums.len().to_string()).join(", ");
        println!("{threads:>7}  {lock:>8.2}  {atomics:>7.2}  {order:>8.2}                 {sums}");
    }
}

// ANCHOR: false_sharing
/// Counts to `COUNT` in every counter, each counter on its own thread.
fn count<C: AsRef<AtomicU64> + Sync>(counters: &[C]) {
    thread::scope(|scope| {
        for counter in counters {
            scope.spawn(|| {
                for _ in 0..COUNT {
                    counter.as_ref().fetch_add(1, Ordering::Relaxed);
                }
            });
        }
    });
}
// ANCHOR_END: false_sharing

const COUNT: usize = 5_000_000;

struct Packed(AtomicU64);
struct Padded(CachePadded<AtomicU64>);

impl AsRef<AtomicU64> for Packed {
    fn as_ref(&self) -> &AtomicU64 {
        &self.0
    }
}

impl AsRef<AtomicU64> for Padded {
    fn as_ref(&self) -> &AtomicU64 {
        &self.0
    }
}

#[test]
#[ignore = "an experiment: prints a table"]
fn experiment_false_sharing() {
    println!("threads  packed  padded   [ns a count]");
    for threads in [1, 2] {
        let packed: Vec<_> = (0..threads).map(|_| Packed(AtomicU64::new(0))).collect();
        let padded: Vec<_> =
            (0..threads).map(|_| Padded(CachePadded::new(AtomicU64::new(0)))).collect();
        let times = [
            nanoseconds_each(COUNT, || count(&packed)),
            nanoseconds_each(COUNT, || count(&padded)),
        ];
        println!("{threads:>7}  {:>6.2}  {:>6.2}", times[0], times[1]);
    }
}

/// Times two ways of waiting: threads are started and joined, or permanent threads meet at a
/// barrier.
#[test]
#[ignore = "an experiment: prints a table"]
fn experiment_threads() {
    const TIMES: usize = 10_000;
    println!("threads  started and joined  at a barrier   [us]");
    for threads in [1, 2, 4] {
        let team = |part: &(dyn Fn() + Sync)| {
            thread::scope(|scope| (0..threads).for_each(|_| drop(scope.spawn(part))));
        };
        let started = nanoseconds_each(TIMES, || (0..TIMES).for_each(|_| team(&|| ())));
        let barrier = Barrier::new(threads);
        let met = nanoseconds_each(TIMES, || team(&|| (0..TIMES).for_each(|_| barrier.wait())));
        println!("{threads:>7}  {:>18.2}  {:>12.2}", started / 1e3, met / 1e3);
    }
}
