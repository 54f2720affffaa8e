//! How the candidates of a window are put in order.

use crate::{Candidate, Found, Workers, merge, order, take, take_earliest, take_in_order};

/// How the candidates of a window are put in order. All take the same ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// Put all in one list and sort it, as the report does (with quicksort).
    Sort,
    /// The same, but all workers sort the list together. The sort that follows finds nothing to do.
    SortTogether,
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
        found.candidates += found.lists.iter().map(|list| list.len() as u64).sum::<u64>();
        let (first, rest) = found.lists.split_first_mut().expect("there is a list");
        match self {
            Self::Sort => {
                rest.iter_mut().for_each(|list| first.append(list));
                take_in_order(first, free, taken);
            }
            Self::SortTogether => {
                rest.iter_mut().for_each(|list| first.append(list));
                workers.sort(first, order);
                take_in_order(first, free, taken);
            }
            Self::Merge => {
                workers.for_few(&mut found.lists, |_, list| list.sort_by(order));
                for candidate in merge(&found.lists) {
                    take(&candidate, free, taken);
                }
            }
            Self::Select => {
                rest.iter_mut().for_each(|list| first.append(list));
                take_earliest(first, free, taken);
            }
        }
    }
}
