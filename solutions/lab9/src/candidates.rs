//! Task 9.3, on the host: a list of candidates that grows, and the last word about each.

use std::ops::Range;

use common::hard::Disc;
use device::{GpuError, Work};
use device_discs::hard::{HardKernels, Launches, Search, WALL};
use solution7::{Candidate, Square, pair_hit, wall_hit};

use crate::Lab9;

impl HardKernels for Lab9 {
    /// Adds all candidates of some rows of work to `found`. The kernels number them; if there are
    /// more than `finder.capacity()`, the list has only the first of them.
    ///
    /// - `finder.run(rows)` runs the kernels on the rows and returns how many candidates there are.
    /// - If there was room for all, `finder.fetch(count, found)` adds them to `found`.
    /// - If not, `finder.grow(count)` makes room for that number, and the kernels must run again. Where
    ///   the device has too little memory, it returns an error: then do the first half of the
    ///   rows, and the second half, each for itself. The candidates of a single row are at most as
    ///   many as discs and always have room: if it is one row, pass the error on.
    ///
    /// Book: chapter 9, *A list that grows*.
    fn collect(
        finder: &mut dyn Search,
        rows: Range<u32>,
        found: &mut Vec<[u32; 2]>,
    ) -> Result<(), GpuError> {
        // task 9.3b: a list that grows
        let mut count = finder.run(rows.clone());
        if count > finder.capacity() {
            match finder.grow(count) {
                Ok(()) => count = finder.run(rows),
                Err(error) if rows.len() < 2 => return Err(error),
                Err(_) => {
                    let middle = rows.start + rows.len() as u32 / 2;
                    Self::collect(finder, rows.start..middle, found)?;
                    return Self::collect(finder, middle..rows.end, found);
                }
            }
        }
        finder.fetch(count, found);
        Ok(())
        // end 9.3b
    }

    /// Writes down the launches that find the candidates: the number of candidates, `finder.count()`,
    /// starts at zero, and each of `finder.kernels()` is run on `finder.launch()`.
    ///
    /// Book: chapter 9, *A list that grows*.
    fn record(finder: Launches<'_>, work: &mut Work<'_>) {
        // task 9.3c: count from zero
        work.clear(finder.count());
        for kernel in finder.kernels() {
            work.launch(kernel, finder.launch());
        }
        // end 9.3c
    }

    /// Fills `candidates` from `found`, what the device passed on: (a, b) with a < b, or
    /// (a, [`WALL`]). What [`pair_hit`] or [`wall_hit`] does not confirm is no candidate.
    ///
    /// Book: chapter 9, *The same bytes on every device*.
    fn confirm(
        discs: &[Disc],
        square: Square,
        found: &[[u32; 2]],
        candidates: &mut Vec<Candidate>,
    ) {
        // task 9.3d: the host has the last word
        candidates.clear();
        candidates.extend(found.iter().filter_map(|&[a, b]| match b {
            WALL => wall_hit(a, &discs[a as usize], square),
            b => pair_hit(discs, a, b, square.radius),
        }));
        // end 9.3d
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
