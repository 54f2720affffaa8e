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
        // task 9.3b: a list that grows
        let mut count = self.run(n, margins, rows.clone());
        if count > self.room {
            match self.grow(count) {
                Ok(()) => count = self.run(n, margins, rows),
                Err(error) if rows.len() < 2 => return Err(error),
                Err(_) => {
                    let middle = rows.start + rows.len() as u32 / 2;
                    self.collect(n, margins, rows.start..middle, found)?;
                    return self.collect(n, margins, middle..rows.end, found);
                }
            }
        }
        self.fetch(count, found);
        Ok(())
        // end 9.3b
    }

    /// Writes down the launches that find the candidates: the number of candidates starts at
    /// zero, and each of `self.bound` is run on `self.launch`.
    ///
    /// Book: chapter 9, *A list that grows*.
    pub(crate) fn record(&self, work: &mut Work<'_>) {
        // task 9.3c: count from zero
        work.clear(&self.count);
        for kernel in &self.bound {
            work.launch(kernel, self.launch);
        }
        // end 9.3c
    }
}

impl<R: Real> HardDiscs<R> {
    /// Fills `self.candidates` from `self.found`, what the device passed on: (a, b) with a < b, or
    /// (a, [`WALL`]). What [`pair_hit`] or [`wall_hit`] does not confirm is no candidate.
    ///
    /// Book: chapter 9, *The same bytes on every device*.
    pub(crate) fn check(&mut self) {
        // task 9.3d: the host has the last word
        let Self { discs, square, found, candidates, .. } = self;
        candidates.clear();
        candidates.extend(found.iter().filter_map(|&[a, b]| match b {
            WALL => wall_hit(a, &discs[a as usize], *square),
            b => pair_hit(discs, a, b, square.radius),
        }));
        // end 9.3d
    }
}
