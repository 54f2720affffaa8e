//! Computes the numbers in bold in the answers to the exam questions.

mod discs;
pub mod draw;
mod engines;
mod messages;
mod threads;

use std::collections::BTreeMap;

use draw::Inputs;
use oracle::integers;

/// A question and its numbers.
type Numbers = (&'static str, Vec<f64>);

/// Computes the numbers of all answers, from the numbers that the questions print.
pub fn all(inputs: &mut Inputs) -> BTreeMap<&'static str, Vec<f64>> {
    [
        threads::numbers(inputs),
        messages::numbers(inputs),
        discs::numbers(inputs),
        engines::numbers(inputs),
    ]
    .concat()
    .into_iter()
    .collect()
}

/// Returns, for each number, the sum of the numbers before it.
fn starts(counts: &[usize]) -> Vec<usize> {
    let sum = |sum: &mut usize, count: &usize| Some(std::mem::replace(sum, *sum + count));
    counts.iter().scan(0, sum).collect()
}

/// Rounds to three significant digits, as the machine of some questions does.
fn three_digits(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap()
}
