//! Tasks 4.5 and 4.6: bins are brought up to date without locks, after all particles have moved.

use common::soft::Particle;
use solution2::Grid;

use crate::{Bin, Change, Cut, Regions, remove};

/// Empties all bins and puts every particle into the bin that contains its position.
///
/// Bins keep their memory. Only one thread runs this. `particles[i]` has number i.
/// [`Regions::parts_mut`] returns the bins of each region, and [`Regions::bin_mut`] returns one
/// bin.
///
/// Book: chapter 4, *One thread*.
pub fn rebuild(regions: &mut Regions, grid: &Grid, particles: &[Particle]) {
    todo!("task 4.5: one thread empties the bins and fills them again")
}

/// Carries out the changes from all change `buffers`.
///
/// The order does not matter, because each particle has at most one change. Only one thread runs
/// this, so it takes no lock.
///
/// Book: chapter 4, *Change buffers*.
pub fn apply_all<'a>(regions: &mut Regions, buffers: impl Iterator<Item = &'a [Change]>) {
    todo!("task 4.6: one thread empties the change buffers")
}

/// Carries out the part of `changes` that concerns the bins of region `own`.
///
/// `bins` are the bins of region `own`. All threads run this at the same time, each with its own
/// region and with the changes of *all* threads. A particle may leave a bin of the region, arrive
/// in a bin of the region, or do both.
///
/// Book: chapter 4, *Change buffers*.
pub fn apply_own(cut: Cut, own: usize, bins: &mut [Bin], changes: impl Iterator<Item = Change>) {
    todo!("task 4.6b: every thread empties the change buffers into its own bins")
}
