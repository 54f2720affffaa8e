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
    // task 10.4: the pairs that are near
    let Positions { x, y, first } = positions;
    let y = &y[..x.len()];
    let mut len = 0;
    for &pair in pairs {
        let [i, j] = pair.map(|i| i as usize - first);
        let (dx, dy) = (x[j] - x[i], y[j] - y[i]);
        // `len` is less than `ROOM`. The compiler does not know that, and would check the index.
        near[len & (ROOM - 1)] = pair;
        len += usize::from(dx * dx + dy * dy <= squared);
    }
    len
    // end 10.4
}
