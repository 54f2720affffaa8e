//! The listed pairs that are near, without a branch.

use neighbour_list_core::kernels::{Pair, Positions, ROOM};

/// Writes the near pairs of `pairs` into `near`, in the same order, and returns their number.
///
/// - `pairs`: at most [`ROOM`] pairs [i, j] of indices in the sorted order.
/// - `positions`: the positions of consecutive particles; particle i is at
///   `positions.x[i - positions.first]`.
/// - `squared`: the square of the greatest distance of a near pair, in squared units of length. A pair
///   at exactly this distance is near.
/// - `near`: room for the pairs. The entries after the near pairs may have any value.
///
/// Of a hundred listed pairs, three touch. The processor mispredicts a branch on the distance for each of
/// these three pairs. Write every pair instead, and let the next pair overwrite a pair that is not
/// near.
///
/// Book: chapter 10, *A list within the list*.
#[inline(always)]
pub fn filter(
    pairs: &[Pair],
    positions: Positions<'_>,
    squared: f64,
    near: &mut [Pair; ROOM],
) -> usize {
    todo!("task 10.4: the pairs that are near")
}
