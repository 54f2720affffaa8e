//! Task 7.13: sorted occupied cells.

use std::ops::Range;

use hard_discs::Entry;

/// Returns the indices of the entries after `k` whose boxes share a column with the box of `k`.
///
/// `entries` are sorted by cell. So the entries of a row are adjacent, in the order of the columns
/// where their boxes begin. Directly after entry `k` come the entries whose boxes begin in its own
/// column or in the `further` columns after it. The last column of a row and the first column of
/// the next row have consecutive numbers, but no box extends beyond the last column.
/// So the partners of an entry are never in the next row.
///
/// Over all k, this yields exactly once every pair of entries in a row whose boxes share a column.
/// Two discs may share several rows. The pair is then found in each of these rows, and the caller
/// removes the duplicates.
///
/// Book: chapter 7, *Sorted occupied cells*.
#[inline(always)]
pub fn partners(entries: &[Entry], k: usize) -> Range<usize> {
    todo!("task 7.13: boxes that share a column")
}
