//! Ways to put the candidates of a window in order.

use crate::collisions::{Candidate, Collisions};
use crate::find::Found;
use workers::Workers;

/// A way to put the candidates of a window in order. The way does not change which candidates are
/// taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// All candidates go into one list, and the list is sorted. The report does the same, with
    /// quicksort.
    Sort,
    /// All workers sort the list together. The sort in [`Collisions::take_in_order`] then finds it
    /// sorted.
    SortTogether,
    /// Every worker sorts its own list. The library's merge sort then finds and merges sorted runs.
    /// The report names this as future work.
    Merge,
}

impl Choice {
    /// Takes the candidates in `found` that really happen. See [`Collisions::take_in_order`].
    pub fn take<C: Collisions>(
        self,
        workers: &Workers,
        found: &mut Found,
        free: &mut [bool],
        taken: &mut Vec<Candidate>,
    ) {
        found.candidates += found.lists.iter().map(|list| list.len() as u64).sum::<u64>();
        if self == Self::Merge {
            workers
                .map(found.lists.iter_mut().collect(), |list: &mut Vec<_>| list.sort_by(C::order));
        }
        let (first, rest) = found.lists.split_first_mut().expect("there is a list");
        rest.iter_mut().for_each(|list| first.append(list));
        match self {
            Self::Sort => {}
            Self::SortTogether => workers.sort(first, C::order),
            Self::Merge => first.sort_by(C::order),
        }
        C::take_in_order(first, free, taken);
    }
}
