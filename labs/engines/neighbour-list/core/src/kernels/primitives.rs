//! What the engine is built on.

use std::ops::Range;

use super::{Pair, Positions, ROOM, Signs};

/// The primitives of a neighbour-list engine: its three innermost loops, and the two decisions about its
/// list.
///
/// Lengths are in units of the box, positions as indices in the sorted order. The loops become part of
/// vector kernels ([`kernels`](crate::kernels)) only where they are always inlined: mark them
/// `#[inline(always)]`, and what they call.
pub trait Primitives: Default + Send + Sync + 'static {
    /// Moves one coordinate of consecutive particles by one step: `v += a dt`, then `x += v dt`. Returns
    /// whether any of them is now outside the walls, at 0 and at `size`.
    ///
    /// `v` and `a` are at least as long as `x`; what they hold beyond its length stays as it is.
    fn drift(x: &mut [f64], v: &mut [f64], a: &[f64], dt: f64, size: f64) -> bool;

    /// Writes a pair [i, j] for every particle j of `range` that is within `reach` of particle `i` (at
    /// `reach` is within) into `list`, in ascending order, and returns where the pairs now end.
    ///
    /// `list[..len]` are pairs found before; behind them is room for all of `range` and eight more. `i` is
    /// not in `range`, which may be empty.
    fn collect(
        list: &mut [Pair],
        len: usize,
        positions: Positions<'_>,
        i: usize,
        range: Range<usize>,
        reach: f64,
        signs: impl Signs,
    ) -> usize;

    /// Writes those of at most [`ROOM`] pairs whose squared distance is at most `squared` into `near`, in
    /// their order, and returns how many they are. What `near` holds behind them does not matter.
    fn filter(
        pairs: &[Pair],
        positions: Positions<'_>,
        squared: f64,
        near: &mut [Pair; ROOM],
    ) -> usize;

    /// Whether a list with this skin has expired when a particle may have gone as far as `displacement`
    /// since it was built: whether it may lack a pair within the cutoff.
    fn expired(displacement: f64, skin: f64) -> bool;

    /// The skin that makes a step cheapest, for `density` particles per area, of which the fastest goes
    /// `displacement` in a step. Positive.
    fn best_skin(density: f64, displacement: f64) -> f64;
}
