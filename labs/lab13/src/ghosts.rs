//! Task 13.3: ghosts, chosen when a list is made.

use std::ops::Range;

use neighbour_list::kernels::{Pair, Positions};

/// The particles that a partner needs: the indices into `y`, in ascending order, of all that are no
/// further than `width` from its `strip` (at `width` is not further).
///
/// - `y`: where the own particles are, in the engine's order. All lie in the own strip, before or
///   after the partner's.
/// - `strip`: the partner's; an end of it may be infinite.
///
/// Which particles are ghosts is decided here once for all steps until the next list. The partner
/// then knows each of them by its index in what is sent, and nothing but positions need be sent.
///
/// Book: chapter 13, *What is sent when*.
pub fn choose(y: &[f64], strip: &Range<f64>, width: f64) -> Vec<u32> {
    todo!("task 13.3: the particles that a partner needs")
}

/// The pairs of an own particle and a ghost that are within `reach` (at `reach` is within): [own,
/// ghost], indices into `own` and into `ghosts`, ascending in the first; pairs of the same own
/// particle in any order that depends on the positions alone.
///
/// The other rank lists the same pair with its own particle first. Each of the two accelerates its own
/// particle and no other, so no force has to be sent.
///
/// There are thousands on both sides, and most are far apart along x. Sort the ghosts by x, and
/// look for each own particle only at the ghosts from x − `reach` to x + `reach`.
///
/// Book: chapter 13, *Pairs across*.
pub fn pairs_across(own: Positions<'_>, ghosts: Positions<'_>, reach: f64) -> Vec<Pair> {
    todo!("task 13.3b: pairs of own particles and ghosts")
}
