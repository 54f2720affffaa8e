//! A look at pairs: one disc and those of higher numbers.

use std::ops::Range;

use common::hard::Disc;

use crate::collisions::{Candidate, Collisions};

/// Whether two discs come near enough to touch at any time, past or future: `false` only where
/// [`Collisions::pair_hit`] gives none.
///
/// It asks first whether they approach each other. That is true of every second pair, so the
/// processor guesses wrong half of the time, and a wrong guess costs more than the rest of the
/// function. The answer here is nearly always no. The slack is for rounding: discs that overlap
/// pass it in exact numbers.
#[inline]
pub fn may_touch(a: &Disc, b: &Disc, radius: f64) -> bool {
    let velocity = b.velocity() - a.velocity();
    let cross = (b.position() - a.position()).cross(velocity);
    cross * cross <= 4.000_001 * radius * radius * velocity.norm_squared()
}

/// The pairs that a search looks at together where that pays, without a branch between them: they fill vector
/// registers.
pub const LANES: usize = 8;

/// Looks at the pairs of disc `a` with every disc in `partners`, all of higher numbers than `a`, and calls `found` with
/// the candidate of each pair that collides in this step.
///
/// `found` is called for these only. [`Vec::extend`] by an `Option` writes the list's length even if there is nothing
/// to add, and lists of two threads may share a line of the cache.
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

/// The same, with the candidates appended to `list`.
pub fn look_along<C: Collisions>(
    discs: &[Disc],
    a: usize,
    partners: Range<usize>,
    radius: f64,
    list: &mut Vec<Candidate>,
) {
    look_for::<C>(discs, a, partners, radius, |hit| list.push(hit));
}
