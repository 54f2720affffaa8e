//! Tasks 4.5 and 4.6: without locks, when all have moved.

use common::soft::Particle;
use solution2::Grid;

use crate::{Bin, Change, Cut, Regions, remove};

/// Empties all bins, which keep their memory, and puts every particle into the one that it lies in. Only one
/// thread runs this.
///
/// `particles[i]` has number i. [`Regions::parts_mut`] are the bins of each region,
/// [`Regions::bin_mut`] is one bin.
///
/// Book: chapter 4, *One thread*.
pub fn rebuild(regions: &mut Regions, grid: &Grid, particles: &[Particle]) {
    todo!("task 4.5: one thread empties the bins and fills them again")
}

/// Makes the changes of all change `buffers`, in any order: no particle has two. Only one thread runs
/// this.
///
/// Book: chapter 4, *Change buffers*.
pub fn apply_all<'a>(regions: &mut Regions, buffers: impl Iterator<Item = &'a [Change]>) {
    todo!("task 4.6: one thread empties the change buffers")
}

/// Makes that part of the changes in `changes` which concerns the bins of region `own`.
///
/// `bins` are those of the region; all threads run this at the same time, each with a region of its
/// own and the changes of *all* threads. A particle may leave an own bin, arrive in one, or both.
///
/// Book: chapter 4, *Change buffers*.
pub fn apply_own(cut: Cut, own: usize, bins: &mut [Bin], changes: impl Iterator<Item = Change>) {
    todo!("task 4.6b: every thread empties the change buffers into its own bins")
}
