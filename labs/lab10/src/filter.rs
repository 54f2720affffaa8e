//! The listed pairs that are near, without a branch.

use crate::kernels::{Pair, Places, ROOM};

/// Writes the pairs of `pairs` that are near into `near`, in their order, and brings back how many
/// they are.
///
/// - `pairs`: at most [`ROOM`] pairs [i, j] of places in the sorted order.
/// - `places`: where consecutive particles are; particle i is at `places.x[i - places.first]`.
/// - `squared`: the square of the greatest distance that is near, in squared units of length; a pair
///   at this very distance is near.
/// - `near`: room for the pairs. What stands behind the near ones does not matter.
///
/// Of a hundred listed pairs three touch. Asking each, with a branch, costs a wrong guess of the
/// processor for each that does. Write each pair down, and let the next one overwrite it unless it
/// is near.
///
/// Book: chapter 10, *A short list*.
#[inline(always)]
pub fn filter(pairs: &[Pair], places: Places<'_>, squared: f64, near: &mut [Pair; ROOM]) -> usize {
    todo!("task 10.5: the pairs that are near")
}
