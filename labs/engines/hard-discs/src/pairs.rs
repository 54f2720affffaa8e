//! Tests pairs of one disc and discs with higher numbers.

use std::ops::Range;

use common::hard::Disc;

use crate::collisions::{Candidate, Collisions};

/// Whether two discs come near enough to touch at any time, past or future.
///
/// It is `false` only if [`Collisions::pair_hit`] returns `None`. The collision test first asks
/// whether the discs approach each other. Half of all pairs do, so the processor mispredicts many
/// of these tests. That costs more than the rest of the function. The result here is nearly always
/// `false`. The factor is 4.000001 and not 4 because of rounding; in exact arithmetic, 4 would be
/// enough.
#[inline]
pub fn may_touch(a: &Disc, b: &Disc, radius: f64) -> bool {
    let velocity = b.velocity() - a.velocity();
    let cross = (b.position() - a.position()).cross(velocity);
    cross * cross <= 4.000_001 * radius * radius * velocity.norm_squared()
}

/// Number of pairs that a search tests together without a branch, so that they fill vector
/// registers.
pub const LANES: usize = 8;

/// Tests the pairs of disc `a` with `partners`, and calls `found` with each candidate of this step.
///
/// All `partners` have higher numbers than `a`. [`Vec::extend`] with an `Option` is not used here,
/// because it would write the list's length for every pair. That is slow if the lengths of two
/// threads' lists share a cache line.
#[inline]
pub fn look_for<C: Collisions>(
    discs: &[Disc],
    a: usize,
    partners: Range<usize>,
    radius: f64,
    mut found: impl FnMut(Candidate),
) {
    for b in partners {
        if let Some(hit) = C::pair_hit(discs, a as u32, b as u32, radius) {
            found(hit);
        }
    }
}

/// Tests the pairs of disc `a` with `partners`, and appends the candidates of this step to `list`.
pub fn look_along<C: Collisions>(
    discs: &[Disc],
    a: usize,
    partners: Range<usize>,
    radius: f64,
    list: &mut Vec<Candidate>,
) {
    look_for::<C>(discs, a, partners, radius, |hit| list.push(hit));
}
