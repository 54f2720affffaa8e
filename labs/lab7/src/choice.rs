//! Task 7.4: which candidates happen.

use hard_discs::Candidate;

use crate::candidate::order;

/// Sorts the candidates and takes those that happen.
///
/// In the order of [`order`], take each candidate whose discs are all still `free` in this step,
/// append it to `taken`, and mark its discs as not free any more. A candidate with a disc that is
/// not free does not happen, and its other disc stays as it was.
///
/// `free[i]` tells of disc i; discs may come in that are not free because an earlier part of the
/// step has taken them. The candidates are left in any order.
///
/// Book: chapter 7, *The earliest first*.
pub fn take_in_order(candidates: &mut [Candidate], free: &mut [bool], taken: &mut Vec<Candidate>) {
    todo!("task 7.4: take the candidates in order")
}

/// Takes one candidate if its discs are free.
pub fn take(candidate: &Candidate, free: &mut [bool], taken: &mut Vec<Candidate>) {
    todo!("task 7.4b: take one candidate")
}
