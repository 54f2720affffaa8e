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
    // task 7.4: take the candidates in order
    candidates.sort_unstable_by(order);
    for candidate in candidates {
        take(candidate, free, taken);
    }
    // end 7.4
}

/// Takes one candidate if its discs are free: the step that all ways to order have in common.
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
/// Book: chapter 7, *Sorting, merging, selecting*.
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
    // task 7.12: select instead of sorting
    let mut earliest: Vec<Option<Candidate>> = vec![None; free.len()];
    let discs = |hit: Hit| [Some(hit.first()), hit.second()].into_iter().flatten();
    loop {
        candidates.retain(|c| discs(c.hit).all(|disc| free[disc as usize]));
        if candidates.is_empty() {
            return;
        }
        for candidate in candidates.iter() {
            for disc in discs(candidate.hit) {
                let noted = &mut earliest[disc as usize];
                if noted.is_none_or(|noted| order(candidate, &noted).is_lt()) {
                    *noted = Some(*candidate);
                }
            }
        }
        for candidate in candidates.iter() {
            if discs(candidate.hit).all(|disc| earliest[disc as usize] == Some(*candidate)) {
                take(candidate, free, taken);
            }
        }
        for candidate in candidates.iter() {
            discs(candidate.hit).for_each(|disc| earliest[disc as usize] = None);
        }
    }
    // end 7.12
}
