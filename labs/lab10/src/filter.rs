//! Which of many pairs are near, without a branch.
//!
//! Of a hundred listed pairs three touch. Asking each, with a branch, costs a wrong guess of the
//! processor for each that does; here the pair is written down and the next one overwrites it
//! unless it is near.

use crate::Bodies;
use crate::search::Pair;

/// Pairs that are filtered together.
pub(crate) const ROOM: usize = 256;

/// Where consecutive particles are.
#[derive(Clone, Copy)]
pub(crate) struct Places<'a> {
    pub(crate) x: &'a [f64],
    pub(crate) y: &'a [f64],
    /// The place of the first of them in the sorted order.
    pub(crate) first: usize,
}

impl<'a> Places<'a> {
    /// Of all particles.
    pub(crate) fn of(bodies: &'a Bodies) -> Self {
        Self { x: &bodies.x, y: &bodies.y, first: 0 }
    }
}

/// Writes those of `pairs`, at most [`ROOM`], whose squared distance is at most `squared` to
/// `near`, in their order, and brings back how many they are.
#[inline(always)]
pub(crate) fn filter(
    pairs: &[Pair],
    places: Places<'_>,
    squared: f64,
    near: &mut [Pair; ROOM],
) -> usize {
    let Places { x, y, first } = places;
    let y = &y[..x.len()];
    let mut len = 0;
    for &pair in pairs {
        let [i, j] = pair.map(|i| i as usize - first);
        let (dx, dy) = (x[j] - x[i], y[j] - y[i]);
        // Never beyond the end, and this way the compiler knows.
        near[len & (ROOM - 1)] = pair;
        len += usize::from(dx * dx + dy * dy <= squared);
    }
    len
}
