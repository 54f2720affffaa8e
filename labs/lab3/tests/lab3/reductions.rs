//! Questions about a sum by several threads. The additions are under a lock, with atomics (also
//! while another thread interrupts), or in a fixed order.

use std::sync::atomic::{AtomicU32, AtomicU64, AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use common::soft::{CUTOFF, Observer, Statistics};
use lab3::{AtomicStatistics, BLOCK, Word, in_order, pool, under_a_lock, with_atomics};
use oracle::{Ask, Near, Random, integers};
use solution1::Tally;

/// Returns `count` statistics whose sum depends, in its last digits, on the order of the additions.
pub(crate) fn parts(count: usize) -> Vec<Tally> {
    let part = |i: usize| {
        let mut tally = Tally::default();
        tally.tested(i as u64);
        tally.seen(CUTOFF * CUTOFF * (0.02 + 0.9 * (i as f64 * 0.618).fract()));
        tally
    };
    (0..count).map(part).collect()
}

pub(crate) fn statistics(tally: &Tally) -> Statistics {
    tally.statistics().expect("a tally returns statistics")
}

/// Returns dmin, davg, navg and pair tests.
pub(crate) fn numbers(s: &Statistics) -> Vec<f64> {
    vec![s.dmin, s.davg, s.navg as f64, s.pair_tests as f64]
}

/// Draws statistics with counts of any size, and with a least distance and a sum of any magnitude.
pub(crate) fn drawn(random: &mut Random) -> Statistics {
    let mut count = || random.bits() >> (12 + random.below(50));
    let navg = count();
    let pair_tests = count();
    let dmin = random.magnitude(1e-12, 1.0);
    let davg = random.magnitude(1e-9, 1e9);
    Statistics { dmin, davg, navg, pair_tests }
}

/// Asks for the sum of parts that one thread adds to atomic numbers.
pub(crate) fn one_after_another(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..200 {
        let parts: Vec<Statistics> = (0..random.below(9)).map(|_| drawn(random)).collect();
        let found = || {
            let total = AtomicStatistics::default();
            parts.iter().for_each(|part| total.add(part));
            numbers(&total.sum())
        };
        let count = parts.len();
        let question = format!(
            "case {case}, {count} parts added by one thread: dmin, davg, navg, pair tests of the sum"
        );
        ask.exact(&question, found, || {
            let mut sum = Statistics::default();
            for part in &parts {
                sum.dmin = sum.dmin.min(part.dmin);
                sum.davg += part.davg;
                sum.navg += part.navg;
                sum.pair_tests += part.pair_tests;
            }
            numbers(&sum)
        });
    }
}

/// Asks for the sum of few and many parts on few and many threads.
fn on_any_threads<A: Ask>(
    ask: &mut A,
    how: &str,
    reduce: impl Fn(&[Tally]) -> Statistics + Sync,
    compare: fn(&mut A, &str, Vec<f64>, &[Tally]),
) {
    for count in [0, 1, BLOCK - 1, BLOCK, BLOCK + 1, 1000, 70_000] {
        let parts = parts(count);
        for threads in [1, 2, 3, 4, 8] {
            let found = pool(threads).install(|| reduce(&parts));
            let question = format!(
                "{count} parts {how} on {threads} threads: dmin, davg, navg, pair tests of the sum"
            );
            compare(ask, &question, numbers(&found), &parts);
        }
    }
}

/// Returns the sum block by block, in order.
fn by_blocks(parts: &[Tally]) -> Statistics {
    let mut blocks = vec![Tally::default(); parts.len().div_ceil(BLOCK)];
    parts.iter().enumerate().for_each(|(i, part)| blocks[i / BLOCK].merge(part));
    let mut sum = Tally::default();
    blocks.iter().for_each(|block| sum.merge(block));
    statistics(&sum)
}

/// Compares up to rounding, because the additions may happen in any order.
fn up_to_rounding<A: Ask>(ask: &mut A, question: &str, found: Vec<f64>, parts: &[Tally]) {
    ask.near(
        question,
        || found,
        || {
            let sum = by_blocks(parts);
            // Only the sum of distances is rounded.
            let scales = [0.0, sum.davg, 0.0, 0.0];
            let near = |(right, scale)| Near { right, scale };
            numbers(&sum).into_iter().zip(scales).map(near).collect()
        },
    );
}

fn to_the_bit<A: Ask>(ask: &mut A, question: &str, found: Vec<f64>, parts: &[Tally]) {
    ask.exact(question, || found, || numbers(&by_blocks(parts)));
}

pub(crate) fn locked(_: &mut Random, ask: &mut impl Ask) {
    on_any_threads(ask, "under a lock", |parts| statistics(&under_a_lock(parts)), up_to_rounding);
}

pub(crate) fn atomic(_: &mut Random, ask: &mut impl Ask) {
    let add = |parts: &[Tally]| with_atomics(&parts.iter().map(statistics).collect::<Vec<_>>());
    on_any_threads(ask, "with atomics", add, up_to_rounding);
}

pub(crate) fn ordered(_: &mut Random, ask: &mut impl Ask) {
    let how = format!("in order, in blocks of {BLOCK},");
    on_any_threads(ask, &how, |parts| statistics(&in_order(parts)), to_the_bit);
}

/// The number of observers that are being merged at this moment.
static MERGING: AtomicUsize = AtomicUsize::new(0);

/// The greatest number of observers that were being merged at the same moment.
static MOST: AtomicUsize = AtomicUsize::new(0);

/// The number of merges that have waited for another merge.
static WAITS: AtomicUsize = AtomicUsize::new(0);

/// A count whose merge takes some milliseconds, or ends when another thread merges too.
#[derive(Clone, Default)]
struct Slow(u64);

impl Observer for Slow {
    fn tested(&mut self, pairs: u64) {
        self.0 += pairs;
    }
    fn seen(&mut self, _r2: f64) {}
    fn merge(&mut self, other: &Self) {
        let merging = 1 + MERGING.fetch_add(1, Ordering::SeqCst);
        MOST.fetch_max(merging, Ordering::SeqCst);
        if WAITS.fetch_add(1, Ordering::SeqCst) < 20 {
            let until = Instant::now() + Duration::from_millis(20);
            while MERGING.load(Ordering::SeqCst) < 2 && Instant::now() < until {
                thread::yield_now();
            }
        }
        self.0 += other.0;
        MERGING.fetch_sub(1, Ordering::SeqCst);
    }
    fn statistics(&self) -> Option<Statistics> {
        Some(Statistics { pair_tests: self.0, ..Statistics::default() })
    }
}

/// Asks for the sum of slow additions, and whether one lock separates all of them.
pub(crate) fn slow(_: &mut Random, ask: &mut impl Ask) {
    let found = || {
        MOST.store(0, Ordering::SeqCst);
        let total = pool(4).install(|| under_a_lock(&vec![Slow(1); 100])).0;
        integers([total as usize, MOST.load(Ordering::SeqCst)])
    };
    let question = "100 parts of 1 are added under a lock by four threads, slowly: (1) the total, (2) the greatest \
                    number of additions at the same moment. A total below 100 means that one thread overwrote what \
                    another had added. If two additions happen at the same moment, they are not under the same lock";
    ask.exact(question, found, || integers([100, 1]));
}

/// Asks for the sum when another thread interrupts few and many times.
pub(crate) fn interrupted(_: &mut Random, ask: &mut impl Ask) {
    // The other thread's dmin is less than the part's, or it is greater and must be replaced.
    for (times, least) in [1, 2, 3, 40, 1000].into_iter().flat_map(|t| [(t, 0.125), (t, 0.6)]) {
        let question = format!(
            "two parts with dmin 0.5, davg 0.5, navg 1 and 4 pair tests are added. A second thread interrupts each of \
             the four numbers {times} times, between two operations. Each time it lowers dmin towards {least}, adds \
             0.25 to davg, and adds 2 to navg and to the pair tests: dmin, davg, navg, pair tests of the sum"
        );
        let found = || numbers(&sum_of_two(times, least));
        ask.judge(&question, found, |found| nothing_lost(times, least, found));
    }
}

/// Checks that a sum contains the other thread's additions and the thread's own additions.
fn nothing_lost(times: u32, least: f64, found: &[f64]) -> Result<(), String> {
    let others = f64::from(2 * times);
    let right = [least.min(0.5), 1.0 + 0.125 * others, 2.0 + others, 8.0 + others];
    // An addition in one operation cannot be interrupted; then only a reading is interrupted.
    let fewest = [right[0], right[1], 4.0, 10.0];
    let is_right = |k: usize| found[k] == right[k] || found[k] == fewest[k];
    if found.len() == 4 && (0..4).all(is_right) {
        return Ok(());
    }
    Err(format!("     found: {found:?}\n  expected: {right:?}"))
}

/// Returns the sum of two additions while another thread interrupts `times` times. It lowers dmin to
/// a small `least`. A `least` above the part's 0.5 is approached, so that every interruption changes
/// dmin.
fn sum_of_two(times: u32, least: f64) -> Statistics {
    let lower = move |bits: &AtomicU64| {
        let old = f64::from_bits(bits.load(Ordering::Relaxed));
        let new = if least < 0.5 { least } else { 0.5 * (old + least) };
        bits.fetch_min(new.to_bits(), Ordering::Relaxed);
    };
    let total = AtomicStatistics {
        dmin: Word::new(1.0_f64.to_bits()).interrupted(at_first(times, lower)),
        davg: Word::new(0.0_f64.to_bits()).interrupted(at_first(times, add_quarter)),
        navg: Word::new(0).interrupted(at_first(times, add_two)),
        pair_tests: Word::new(0).interrupted(at_first(times, add_two)),
    };
    let part = Statistics { dmin: 0.5, davg: 0.5, navg: 1, pair_tests: 4 };
    // The first reading of each word may belong to `sum`.
    total.add(&part);
    total.sum();
    total.add(&part);
    total.sum()
}

/// Returns a function by which another thread changes a word with `by`, at the first `times`
/// opportunities.
pub(crate) fn at_first(times: u32, by: impl Fn(&AtomicU64)) -> impl Fn(&AtomicU64) {
    let done = AtomicU32::new(0);
    move |bits| {
        if done.fetch_add(1, Ordering::Relaxed) < times {
            by(bits);
        }
    }
}

pub(crate) fn add_quarter(bits: &AtomicU64) {
    let sum = f64::from_bits(bits.load(Ordering::Relaxed)) + 0.25;
    bits.store(sum.to_bits(), Ordering::Relaxed);
}

fn add_two(bits: &AtomicU64) {
    bits.fetch_add(2, Ordering::Relaxed);
}
