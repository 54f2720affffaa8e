//! Task 7.13: sorted occupied cells.

use std::ops::Range;

use hard_discs::Entry;

/// The entries behind entry `k` whose boxes share a column with its box: their indices.
///
/// `entries` are sorted by cell, so a row is a stretch of them, and within a row boxes stand in
/// the order of the columns where they begin. The boxes that begin in the columns of entry `k`, from
/// its own cell up to `further` columns on, follow it directly. The last column of a
/// row and the first of the next have neighbouring numbers, but no box goes on beyond the last column.
///
/// Over all k that is every two entries of the same row whose boxes share a column, once. A pair of discs may
/// share several rows and then comes up in each; the caller sorts that out.
///
/// Book: chapter 7, *Sorted occupied cells*.
#[inline(always)]
pub fn partners(entries: &[Entry], k: usize) -> Range<usize> {
    // task 7.13: boxes that share a column
    let last = entries[k].cell + u64::from(entries[k].further);
    let mut end = k + 1;
    while end < entries.len() && entries[end].cell <= last {
        end += 1;
    }
    k + 1..end
    // end 7.13
}
