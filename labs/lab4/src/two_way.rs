//! Tasks 4.10 and 4.11: every pair once.

use common::Vec2;
use common::soft::Observer;
use solution1::pair_acceleration;
use solution2::SortedBins;

/// Adds to `accelerations` what the particles of `bins` do to each other, looking at every pair
/// once. `accelerations[i]` belongs to `bins.particles()[i]`.
///
/// If `a` is what j does to i ([`pair_acceleration`] of the vector from i to j), then −a is what i
/// does to j. To meet every pair once, each particle looks only at those that come after it in
/// the order of bins: the rest of its own bin and the bin to the right, and the three bins in the
/// row above ([`Grid::near`] of its column). Rows beyond those of `bins` are not looked at.
///
/// [`SortedBins::span`] gives the indices of neighbouring bins of a row: they are one range, and the
/// rest of the own bin with the bin to the right is one as well. Tell the observer for each particle
/// how many the two ranges have ([`Observer::tested`]), each pair once; and of every pair that touches
/// ([`Observer::seen`], with its squared distance) *twice*: once for i, once for j.
///
/// Book: chapter 4, *Every pair once*.
///
/// [`Grid::near`]: solution2::Grid::near
pub fn pairs_within<O: Observer>(bins: &SortedBins, accelerations: &mut [Vec2], observer: &mut O) {
    let (grid, particles) = (bins.grid(), bins.particles());
    for row in bins.rows() {
        for column in 0..grid.columns() {
            todo!("task 4.10: every pair of a thread's rows once")
        }
    }
}

/// Adds what the particles in the last row of `bins` and those in the first row of `next`, the
/// owner of the row above, do to each other.
///
/// The thread that owns `bins` runs this, and it alone, so the pair counts once. It may write its
/// own `accelerations`, but not the next owner's: its thread is writing there at the same time. So what
/// is done to particle k of the next owner's first row goes into `across[k]`, which is zero at
/// first, and the next owner adds it later. Indices in `next` begin with 0 in its first row. The observer
/// is told as in [`pairs_within`].
///
/// Book: chapter 4, *Every pair once*.
pub fn pairs_across<O: Observer>(
    bins: &SortedBins,
    next: &SortedBins,
    accelerations: &mut [Vec2],
    across: &mut [Vec2],
    observer: &mut O,
) {
    let grid = bins.grid();
    let (row, above) = (bins.rows().end - 1, next.rows().start);
    for column in 0..grid.columns() {
        todo!("task 4.11: the pair across a cut")
    }
}

/// Adds what came from across the cut to the accelerations of an owner's first row.
pub fn add_across(accelerations: &mut [Vec2], across: &[Vec2]) {
    for (a, from_below) in accelerations.iter_mut().zip(across) {
        *a += *from_below;
    }
}
