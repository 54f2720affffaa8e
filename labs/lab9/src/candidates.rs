//! Task 9.3, on the host: a list of candidates that grows, and the last word about each.

use std::ops::Range;

use solution7::{pair_hit, wall_hit};

use crate::gpu::{GpuError, Real, Work};
use crate::hard::{Finder, HardDiscs, Margins, WALL};

impl<R: Real> Finder<R> {
    /// Adds all candidates of some rows of work to `found`. The kernels number them; if there are
    /// more than `self.room`, the list has only the first `self.room` of them.
    ///
    /// - [`run`](Self::run) runs the kernels on the rows and returns how many candidates there are.
    /// - If there was room for all, [`fetch`](Self::fetch) adds them to `found`.
    /// - If not, [`grow`](Self::grow) makes room for that number, and the kernels must run again. Where
    ///   the device has too little memory, it returns an error: then do the first half of the
    ///   rows, and the second half, each for itself. The candidates of a single row are at most as
    ///   many as discs and always have room: if it is one row, pass the error on.
    ///
    /// Book: chapter 9, *A list that grows*.
    pub(crate) fn collect(
        &mut self,
        n: u32,
        margins: &Margins,
        rows: Range<u32>,
        found: &mut Vec<[u32; 2]>,
    ) -> Result<(), GpuError> {
        todo!("task 9.3b: a list that grows")
    }

    /// Writes down the launches that find the candidates: the number of candidates starts at
    /// zero, and each of `self.bound` is run on `self.launch`.
    ///
    /// Book: chapter 9, *A list that grows*.
    pub(crate) fn record(&self, work: &mut Work<'_>) {
        todo!("task 9.3c: count from zero")
    }
}

impl<R: Real> HardDiscs<R> {
    /// Fills `self.candidates` from `self.found`, what the device passed on: (a, b) with a < b, or
    /// (a, [`WALL`]). What [`pair_hit`] or [`wall_hit`] does not confirm is no candidate.
    ///
    /// Book: chapter 9, *The same bytes on every device*.
    pub(crate) fn check(&mut self) {
        todo!("task 9.3d: the host has the last word")
    }
}
