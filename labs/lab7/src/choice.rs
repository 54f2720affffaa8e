//! Task 7.4: the candidates that happen.

use hard_discs::Candidate;

use crate::candidate::order;

/// Sorts the candidates, and appends to `taken` the candidates that happen.
///
/// - Go through the candidates in the order of [`order`].
/// - A candidate happens if all its discs are still `free` in this step. Append it to `taken`, and
///   mark its discs as not free.
/// - A candidate with a disc that is not free does not happen. Its other disc stays as it was.
/// - `free[i]` belongs to disc i. An earlier part of the step may already have taken some discs.
/// - Afterwards, `candidates` may be in any order.
///
/// Book: chapter 7, *The earliest first*.
pub fn take_in_order(candidates: &mut [Candidate], free: &mut [bool], taken: &mut Vec<Candidate>) {
    todo!("task 7.4: take the candidates in order")
}

/// Takes one candidate if its discs are free.
pub fn take(candidate: &Candidate, free: &mut [bool], taken: &mut Vec<Candidate>) {
    todo!("task 7.4b: take one candidate")
}
