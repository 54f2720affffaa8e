//! The neighbours of one particle, without a branch.

use std::ops::Range;

use neighbour_list_core::kernels::{EIGHT, Pair, Positions, Signs, pack};

/// Writes a pair [i, j] for every particle j of `range` that is within `reach` of particle `i` (at
/// `reach` is within) into `list`, in ascending order, and returns where the pairs now end.
///
/// - `list`: `list[..len]` are pairs found before; behind them is room for all of `range` and
///   eight more.
/// - `positions`: of all particles, in units of length.
/// - `i` and `range`: indices in the sorted order; `i` is not in `range`. The range may be empty,
///   and mostly it is shorter than eight.
/// - `signs`: says which of eight numbers have a minus sign, a bit for each.
///
/// A branch on the distance would often be mispredicted. So would the end of a loop over `range`, which
/// is short. Compare eight at a time, also where the range has fewer; a longer range in pieces of eight. Write down those that are in the
/// range and within reach. [`Positions::eight`] fetches eight, and [`pack`] writes some of eight down.
///
/// [`Signs::negative`] takes eight `f32`. Compute in `f64`, and convert only the difference, as the last
/// thing: that keeps its sign, however small it is, and a difference of 0 is +0.
///
/// Book: chapter 10, *The neighbours of a particle*.
#[inline(always)]
pub fn collect(
    list: &mut [Pair],
    len: usize,
    positions: Positions<'_>,
    i: usize,
    range: Range<usize>,
    reach: f64,
    signs: impl Signs,
) -> usize {
    todo!("task 10.2: the neighbours of one particle")
}
