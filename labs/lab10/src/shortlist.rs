//! A neighbour list of a neighbour list: the pairs that may matter within the next few steps.
//!
//! A list that lasts for ten steps is long, and most of its pairs are too far apart for the next
//! three. So they are looked at once in three steps, and the others at each.

use common::soft::CUTOFF;
use pulp::NullaryFnOnce;

use crate::filter::{Places, ROOM, filter};
use crate::search::Pair;
use crate::{Block, Bodies, Piece};

/// Keeps those pairs of a block that are within `reach`, and adds its `own` of some more.
pub(crate) struct Shorten<'a> {
    pub(crate) block: &'a mut Block,
    pub(crate) bodies: &'a Bodies,
    pub(crate) reach: f64,
    /// In order, of all blocks.
    pub(crate) more: &'a [Pair],
}

impl NullaryFnOnce for Shorten<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { block, bodies, reach, more } = self;
        let Block { all, near, particles, is_short, .. } = block;
        let mut some_near = [[0; 2]; ROOM];
        let before = |end: usize| more.partition_point(|pair| (pair[0] as usize) < end);
        let (mut from, mut done) = (0, before(particles.start));
        near.pieces.clear();
        near.pairs.clear();
        for piece in &all.pieces {
            for some in all.pairs[from..piece.pairs].chunks(ROOM) {
                let len = filter(some, Places::of(bodies), reach * reach, &mut some_near);
                near.pairs.extend_from_slice(&some_near[..len]);
            }
            let own = &more[done..before(piece.particles)];
            near.pairs.extend_from_slice(own);
            let ahead = own.iter().fold(piece.ahead, |ahead, pair| ahead.max(pair[1] as usize + 1));
            near.pieces.push(Piece { pairs: near.pairs.len(), ahead, ..*piece });
            (from, done) = (piece.pairs, done + own.len());
        }
        *is_short = true;
    }
}

/// Steps that a short list should last of a list that looks `skin` beyond the cutoff, if a step
/// takes nobody further than `way` and it has to look `ahead` by as much more; none if it is cheaper
/// to look at all pairs at each step.
pub(crate) fn lasting(skin: f64, way: f64, ahead: f64) -> Option<f64> {
    let share = |steps: f64| {
        let reach = CUTOFF + 2.0 * (ahead + (steps - 1.0) * way);
        1.0 / steps + (reach / (CUTOFF + skin)).powi(2)
    };
    let steps = (2..12).map(f64::from).min_by(|a, b| share(*a).total_cmp(&share(*b)))?;
    (share(steps) < 0.9).then_some(steps)
}
