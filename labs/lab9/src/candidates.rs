//! Task 9.3, on the host: a list of candidates that grows, and the host's check of each candidate.

use std::ops::Range;

use common::hard::Disc;
use device::{GpuError, Work};
use device_discs::hard::{HardKernels, Launches, Search, WALL};
use solution7::{Candidate, Square, pair_hit, wall_hit};

use crate::Lab9;

impl HardKernels for Lab9 {
    /// Adds all candidates of the rows `rows` to `found`.
    ///
    /// A row is a part of the search: the pairs of one disc with all discs after it, or one row of
    /// the rectangle of pairs. The kernels count the candidates. If there are more candidates than
    /// `finder.capacity()`, the device's list contains only some of them.
    ///
    /// - `finder.run(rows)` runs the kernels on the rows, and returns the number of candidates.
    /// - If the list had room for all candidates, `finder.fetch(count, found)` adds them to
    ///   `found`.
    /// - Otherwise, `finder.grow(count)` makes room for this number of candidates, and the kernels
    ///   must run again.
    /// - `finder.grow` returns an error if the device has too little memory. Then collect the first
    ///   half of the rows and the second half separately. If there is only one row, return the
    ///   error. (The list always has room for the candidates of one row: there are at most as many
    ///   as discs.)
    ///
    /// Book: chapter 9, *A list that grows*.
    fn collect(
        finder: &mut dyn Search,
        rows: Range<u32>,
        found: &mut Vec<[u32; 2]>,
    ) -> Result<(), GpuError> {
        todo!("task 9.3b: a list that grows")
    }

    /// Records the launches that find the candidates.
    ///
    /// Set the number of candidates, `finder.count()`, to zero. Then launch each of
    /// `finder.kernels()` with `finder.launch()`.
    ///
    /// Book: chapter 9, *A list that grows*.
    fn record(finder: Launches<'_>, work: &mut Work<'_>) {
        todo!("task 9.3c: count from zero")
    }

    /// Replaces `candidates` with the pairs in `found` that the host confirms.
    ///
    /// The device found these pairs. A pair is (a, b) with a < b, or (a, [`WALL`]). It is confirmed
    /// if [`pair_hit`] or [`wall_hit`] returns a candidate.
    ///
    /// Book: chapter 9, *The same bytes on every device*.
    fn confirm(
        discs: &[Disc],
        square: Square,
        found: &[[u32; 2]],
        candidates: &mut Vec<Candidate>,
    ) {
        todo!("task 9.3d: the host has the last word")
    }

    fn filter() -> &'static str {
        include_str!("filter.wgsl")
    }

    fn basic() -> &'static str {
        include_str!("basic.wgsl")
    }

    fn balanced() -> &'static str {
        include_str!("balanced.wgsl")
    }

    fn choose() -> &'static str {
        include_str!("choose.wgsl")
    }
}
