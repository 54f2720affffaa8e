//! The interface between the engine and its primitives.

use std::ops::Range;

use super::{Pair, Positions, ROOM, Signs};

/// The primitives of a neighbour-list engine: its three innermost loops, and two decisions about
/// its list.
///
/// Lengths are in units of the box. Particles are indices in the sorted order. The loops become
/// part of vector kernels ([`kernels`](crate::kernels)) only if they are always inlined: mark them,
/// and the functions that they call, with `#[inline(always)]`.
pub trait Primitives: Default + Send + Sync + 'static {
    /// Moves one coordinate of consecutive particles by one step: `v += a dt`, then `x += v dt`.
    ///
    /// Returns whether any particle is now outside the walls, which are at 0 and at `size`. `v` and
    /// `a` are at least as long as `x`; their elements beyond that length do not change.
    fn drift(x: &mut [f64], v: &mut [f64], a: &[f64], dt: f64, size: f64) -> bool;

    /// Appends a pair [i, j] to `list` for every particle j of `range` within `reach` of particle
    /// `i`.
    ///
    /// The pairs are in ascending order, and a distance of exactly `reach` counts as within.
    /// `list[..len]` contains the pairs that were found before; after these pairs there is room for
    /// all of `range` and eight more pairs. `i` is not in `range`, and `range` may be empty.
    /// Returns the new number of pairs.
    fn collect(
        list: &mut [Pair],
        len: usize,
        positions: Positions<'_>,
        i: usize,
        range: Range<usize>,
        reach: f64,
        signs: impl Signs,
    ) -> usize;

    /// Copies to `near`, in order, the pairs whose squared distance is at most `squared`.
    ///
    /// There are at most [`ROOM`] pairs. Returns the number of pairs that were copied. Later
    /// elements of `near` have no meaning.
    fn filter(
        pairs: &[Pair],
        positions: Positions<'_>,
        squared: f64,
        near: &mut [Pair; ROOM],
    ) -> usize;

    /// Whether a list with this `skin` may lack a pair within the cutoff, and so has expired.
    ///
    /// Since the list was built, no particle has moved further than `displacement`.
    fn expired(displacement: f64, skin: f64) -> bool;

    /// Returns the skin that makes a step cheapest. The skin is positive.
    ///
    /// There are `density` particles per unit area, and the fastest particle moves a distance of
    /// `displacement` in a step.
    fn best_skin(density: f64, displacement: f64) -> f64;
}
