//! Tasks 7.10 and 7.11: three ways to take the earliest candidates first.

use crate::{Candidate, Found, Hit, Workers, order, take, take_in_order};

/// How the candidates of a window are put in order. All three take the same ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// Put all in one list and sort it, as the report does (with quicksort).
    Sort,
    /// Every worker sorts its own list, then the lists are merged (the report's future work).
    Merge,
    /// Never sort: take, again and again, every candidate that is its discs' earliest.
    Select,
}

impl Choice {
    /// Takes the candidates in `found` that happen. See [`take_in_order`].
    pub fn take(
        self,
        workers: &Workers,
        found: &mut Found,
        free: &mut [bool],
        taken: &mut Vec<Candidate>,
    ) {
        let (first, others) = found.lists.split_first_mut().expect("there is a list");
        match self {
            Self::Sort => {
                others.iter_mut().for_each(|list| first.append(list));
                take_in_order(first, free, taken);
            }
            Self::Merge => {
                workers.for_few(&mut found.lists, |_, list| list.sort_by(order));
                for candidate in merge(&found.lists) {
                    take(&candidate, free, taken);
                }
            }
            Self::Select => {
                others.iter_mut().for_each(|list| first.append(list));
                take_earliest(first, free, taken);
            }
        }
    }
}

/// Merges sorted lists into one.
///
/// Merge two neighbouring lists at a time, (0, 1), (2, 3), …, and go on with half as many lists
/// until one is left: each candidate is then copied log₂(lists) times, not once per list.
///
/// Book: chapter 7, *Sorting, merging, selecting*.
pub fn merge(lists: &[Vec<Candidate>]) -> Vec<Candidate> {
    todo!("task 7.10: merge sorted lists")
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
    todo!("task 7.11: select instead of sorting")
}
