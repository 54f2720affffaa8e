//! A neighbour list of a neighbour list: the pairs that may matter within the next few steps.

use pulp::NullaryFnOnce;

use crate::Bodies;
use crate::filter::{ROOM, filter};
use crate::search::Pair;

/// Keeps those of `pairs` that are within `reach` in `near`.
///
/// A list that lasts for ten steps is long, and most of its pairs are too far apart for the next
/// three. So they are looked at once in three steps, and the others at each.
pub(crate) struct Shortlist<'a> {
    pub(crate) pairs: &'a [Pair],
    pub(crate) bodies: &'a Bodies,
    pub(crate) reach: f64,
    pub(crate) near: &'a mut Vec<Pair>,
}

impl NullaryFnOnce for Shortlist<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { pairs, bodies, reach, near } = self;
        let mut some_near = [[0; 2]; ROOM];
        near.clear();
        for some in pairs.chunks(ROOM) {
            let len = filter(some, &bodies.x, &bodies.y, reach * reach, &mut some_near);
            near.extend_from_slice(&some_near[..len]);
        }
    }
}
