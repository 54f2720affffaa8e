//! Tasks 7.4 and 7.11: which candidates happen, and sorted lists merged.

use crate::{Candidate, order};

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
    // task 7.4: take the candidates in order
    candidates.sort_unstable_by(order);
    for candidate in candidates {
        take(candidate, free, taken);
    }
    // end 7.4
}

/// Takes one candidate if its discs are free: the step that both ways to sort have in common.
pub fn take(candidate: &Candidate, free: &mut [bool], taken: &mut Vec<Candidate>) {
    // task 7.4b: take one candidate
    let first = candidate.hit.first() as usize;
    let second = candidate.hit.second().map_or(first, |b| b as usize);
    if free[first] && free[second] {
        free[first] = false;
        free[second] = false;
        taken.push(*candidate);
    }
    // end 7.4b
}

/// Merges sorted lists into one.
///
/// Merge two neighbouring lists at a time, (0, 1), (2, 3), …, and go on with half as many lists
/// until one is left: each candidate is then copied log₂(lists) times, not once per list.
///
/// Book: chapter 7, *Sorting and merging*.
pub fn merge(lists: &[Vec<Candidate>]) -> Vec<Candidate> {
    // task 7.11: merge sorted lists
    let mut lists = lists.to_vec();
    while lists.len() > 1 {
        lists = lists
            .chunks(2)
            .map(|pair| match pair {
                [a, b] => merge_two(a, b),
                rest => rest.concat(),
            })
            .collect();
    }
    lists.pop().unwrap_or_default()
    // end 7.11
}

// answer only
fn merge_two(mut a: &[Candidate], mut b: &[Candidate]) -> Vec<Candidate> {
    let mut merged = Vec::with_capacity(a.len() + b.len());
    while let (Some(first), Some(second)) = (a.first(), b.first()) {
        if order(first, second).is_le() {
            merged.push(*first);
            a = &a[1..];
        } else {
            merged.push(*second);
            b = &b[1..];
        }
    }
    merged.extend_from_slice(a);
    merged.extend_from_slice(b);
    merged
}
// end answer only
