//! Tasks 4.10 and 4.11: every pair once.

use common::Vec2;
use common::soft::Observer;
use solution1::pair_acceleration;
use solution2::SortedBins;

/// Adds the accelerations of all pairs within `bins` to `accelerations`. Looks at each pair once.
///
/// `accelerations[i]` belongs to `bins.particles()[i]`. If j accelerates i by `a`
/// ([`pair_acceleration`] of the vector from i to j), then i accelerates j by −a.
///
/// To meet every pair once, each particle looks only at the particles that come after it in the
/// order of bins. These are in two ranges of indices, which [`SortedBins::span`] returns for
/// neighbouring bins of a row:
///
/// - the rest of its own bin, and the bin to the right;
/// - the three bins in the row above ([`Grid::near`] of the particle's column). If `bins` does not
///   contain that row, this range is empty.
///
/// Report every pair once as [`tested`](Observer::tested): for each particle, report the number of
/// particles in the two ranges together. For a pair that touches, call [`seen`](Observer::seen) *twice*
/// with the squared distance: once for i and once for j.
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

/// Adds the accelerations of the pairs across the cut between `bins` and `next`.
///
/// A pair consists of a particle i in the last row of `bins` and a particle k in the first row of
/// `next`, which is the row above. Only the thread that owns `bins` runs this, so each pair is
/// computed once.
///
/// - Add the acceleration of particle i to `accelerations[i]`.
/// - Add the acceleration of particle k of the next owner's first row to `across[k]`. `across` is
///   zero at first, and the next owner adds it later. (The next owner's thread writes its own
///   accelerations at the same time, so you may not write there.)
/// - Indices into `next` start at 0, with the first particle of its first row.
/// - Report the pairs to the observer as in [`pairs_within`].
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

/// Adds the accelerations from across the cut to the accelerations of an owner's first row.
pub fn add_across(accelerations: &mut [Vec2], across: &[Vec2]) {
    for (a, from_below) in accelerations.iter_mut().zip(across) {
        *a += *from_below;
    }
}
