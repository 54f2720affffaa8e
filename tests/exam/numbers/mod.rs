//! Computed numbers of the exam questions' answers: for each question the numbers in bold, in their
//! order.

mod discs;
mod engines;
mod messages;
mod threads;

use std::collections::BTreeMap;

use oracle::integers;

/// A question and its numbers.
type Numbers = (&'static str, Vec<f64>);

pub(crate) fn all() -> BTreeMap<&'static str, Vec<f64>> {
    [threads::numbers(), messages::numbers(), discs::numbers(), engines::numbers()]
        .concat()
        .into_iter()
        .collect()
}

/// Returns for each number the sum of all numbers before it.
fn starts(counts: &[usize]) -> Vec<usize> {
    let sum = |sum: &mut usize, count: &usize| Some(std::mem::replace(sum, *sum + count));
    counts.iter().scan(0, sum).collect()
}

/// Rounds to three significant digits, as the machine of some questions does.
fn three_digits(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap()
}
