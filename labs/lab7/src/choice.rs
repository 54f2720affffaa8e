//! Tasks 7.4, 7.11 and 7.12: which candidates happen, found in three ways.

use crate::{Candidate, Hit, order};

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

/// Takes one candidate if its discs are free: the step that all ways to order have in common.
pub fn take(candidate: &Candidate, free: &mut [bool], taken: &mut Vec<Candidate>) {
    todo!("task 7.4b: take one candidate")
}

/// Merges sorted lists into one.
///
/// Merge two neighbouring lists at a time, (0, 1), (2, 3), …, and go on with half as many lists
/// until one is left: each candidate is then copied log₂(lists) times, not once per list.
///
/// Book: chapter 7, *Sorting, merging, selecting*.
pub fn merge(lists: &[Vec<Candidate>]) -> Vec<Candidate> {
    todo!("task 7.11: merge sorted lists")
}

/// Takes the same candidates as [`take_in_order`], without a sort.
///
/// A candidate that is the earliest of all that its discs are in must happen: nothing can take its
/// discs away before. So go in rounds. Drop the candidates with a disc that is not free; note for
/// each disc the earliest candidate that it is in; take every candidate that both its discs
/// have noted. At least the earliest of all is taken in each round, mostly a good part of them.
///
/// It appends to `taken` in an order of its own.
///
/// Book: chapter 7, *Sorting, merging, selecting*.
pub fn take_earliest(
    candidates: &mut Vec<Candidate>,
    free: &mut [bool],
    taken: &mut Vec<Candidate>,
) {
    todo!("task 7.12: select instead of sorting")
}
