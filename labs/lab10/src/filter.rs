//! The listed pairs that are near, without a branch.

use neighbour_list_core::kernels::{Pair, Positions, ROOM};

/// Writes the pairs of `pairs` that are near into `near`, in their order, and returns how many
/// they are.
///
/// - `pairs`: at most [`ROOM`] pairs [i, j] of indices in the sorted order.
/// - `positions`: of consecutive particles; particle i is at `positions.x[i - positions.first]`.
/// - `squared`: the square of the greatest distance that is near, in squared units of length; a pair
///   at this very distance is near.
/// - `near`: room for the pairs. What stands behind the near ones does not matter.
///
/// Of a hundred listed pairs three touch. A branch on the distance is mispredicted for each of them. Write
/// each pair down instead, and let the next one overwrite it unless it is near.
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
