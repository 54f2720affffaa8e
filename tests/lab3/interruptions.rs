//! Questions about additions with atomics while another thread comes in between.

use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};

use common::soft::Statistics;
use lab3::{AtomicStatistics, Word};
use oracle::{Ask, Random};

use super::reductions::numbers;

/// Another thread comes in few and many times.
pub(crate) fn additions(_: &mut Random, ask: &mut impl Ask) {
    for times in [1, 2, 3, 40, 1000] {
        let question = format!(
            "dmin 0.5, davg 0.5, navg 1 and 4 pair tests are added twice, and another thread comes in {times} times \
             between two operations on each number. It lowers dmin to 0.125, and adds 0.25 to davg and 2 to each \
             count: dmin, davg, navg, pair tests of the sum"
        );
        ask.judge(&question, || numbers(&interrupted(times)), |found| nothing_lost(times, found));
    }
}

/// Whether the other thread's additions and the own ones are all in a sum.
fn nothing_lost(times: u32, found: &[f64]) -> Result<(), String> {
    let others = f64::from(2 * times);
    let right = [0.125, 1.0 + 0.125 * others, 2.0 + others, 8.0 + others];
    // Nobody can come into an addition that is one operation; then only a reading is interrupted.
    let fewest = [right[0], right[1], 4.0, 10.0];
    let is_right = |k: usize| found[k] == right[k] || found[k] == fewest[k];
    if found.len() == 4 && (0..4).all(is_right) {
        return Ok(());
    }
    Err(format!("     found: {found:?}\n  expected: {right:?}"))
}

/// The sum of two additions while another thread comes in `times` times.
fn interrupted(times: u32) -> Statistics {
    let total = AtomicStatistics {
        dmin: Word::new(1.0_f64.to_bits()).interrupted(at_first(times, lower)),
        davg: Word::new(0.0_f64.to_bits()).interrupted(at_first(times, add_quarter)),
        navg: Word::new(0).interrupted(at_first(times, add_two)),
        pair_tests: Word::new(0).interrupted(at_first(times, add_two)),
    };
    let part = Statistics { dmin: 0.5, davg: 0.5, navg: 1, pair_tests: 4 };
    // The first reading of each word may be that of `sum`.
    total.add(&part);
    total.sum();
    total.add(&part);
    total.sum()
}

/// What another thread does to a word, the first `times` times that it can.
pub(crate) fn at_first(times: u32, by: fn(&AtomicU64)) -> impl Fn(&AtomicU64) {
    let done = AtomicU32::new(0);
    move |bits| {
        if done.fetch_add(1, Ordering::Relaxed) < times {
            by(bits);
        }
    }
}

fn lower(bits: &AtomicU64) {
    bits.store(0.125_f64.to_bits(), Ordering::Relaxed);
}

pub(crate) fn add_quarter(bits: &AtomicU64) {
    let sum = f64::from_bits(bits.load(Ordering::Relaxed)) + 0.25;
    bits.store(sum.to_bits(), Ordering::Relaxed);
}

fn add_two(bits: &AtomicU64) {
    bits.fetch_add(2, Ordering::Relaxed);
}
