//! Blocks of particles with their pairs: an outer list until the next rebuild, an inner list for a
//! few steps.
//!
//! A block stores one list of pairs, not a list for each particle. A particle of the official scene
//! has two or three pairs, and the processor mispredicts the end of such a short loop.

use std::marker::PhantomData;
use std::ops::Range;

use pulp::NullaryFnOnce;

use crate::cells::Cells;
use crate::kernels::{EIGHT, Kernel, Pair, Positions, Primitives, ROOM, Signs, make_room};
use crate::particles::Bodies;

/// Number of particles that are moved together as soon as their forces are known. So few particles
/// stay in the second-level cache; shorter pieces interrupt the loops more often.
const PIECE: usize = 4000;

/// Consecutive particles of the sorted order with their pairs. One thread at a time works on a
/// block.
#[derive(Default)]
pub struct Block {
    /// The particles.
    pub particles: Range<usize>,
    /// All pairs within the cutoff plus the skin.
    pub outer: Pairs,
    /// The pairs that may touch within the next few steps.
    pub inner: Pairs,
    /// Whether `inner` is valid.
    pub has_inner: bool,
    /// Number of pairs that were tested to build `outer`.
    pub tested: u64,
}

/// Pairs of indices into the sorted order, the smaller index first. The first particle is in the
/// block.
#[derive(Default)]
pub struct Pairs {
    /// The pairs whose second particle is in the block as well.
    pub inside: Vec<Pair>,
    /// The pieces of the block, in order.
    pub pieces: Vec<Piece>,
    /// The pairs whose second particle is in a later block.
    pub across: Vec<Pair>,
}

/// The pairs of the particles of a piece.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    /// The end of these pairs in `inside`. They begin where the pairs of the previous piece end.
    pub pairs: usize,
    /// The index after the last particle of these pairs.
    pub ahead: usize,
}

impl Pairs {
    /// Returns the number of pairs.
    pub fn len(&self) -> usize {
        self.inside.len() + self.across.len()
    }

    /// Whether there are no pairs.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn clear(&mut self) {
        self.inside.clear();
        self.pieces.clear();
        self.across.clear();
    }
}

impl Block {
    /// Returns the pairs that a step computes: the inner list if it is valid, otherwise the outer
    /// list.
    pub fn pairs(&self) -> &Pairs {
        if self.has_inner { &self.inner } else { &self.outer }
    }

    /// Whether the block contains one of the particles `indices`, which are ascending.
    pub fn has_any(&self, indices: &[u32]) -> bool {
        let next = indices.partition_point(|&i| (i as usize) < self.particles.start);
        indices.get(next).is_some_and(|&i| (i as usize) < self.particles.end)
    }

    /// Returns the pieces of the block.
    pub(crate) fn pieces(&self) -> impl Iterator<Item = Range<usize>> + use<> {
        let Range { start, end } = self.particles;
        (start..end).step_by(PIECE).map(move |first| first..end.min(first + PIECE))
    }
}

/// Builds the outer list of a block: the pairs within `reach`, each listed with its first particle.
pub(crate) struct Collect<'a, P> {
    pub(crate) block: &'a mut Block,
    pub(crate) bodies: &'a Bodies,
    pub(crate) cells: &'a Cells,
    pub(crate) reach: f64,
    pub(crate) primitives: PhantomData<P>,
}

impl<P: Primitives> Kernel for Collect<'_, P> {
    type Output = ();

    #[inline(always)]
    fn run(self, signs: impl Signs) {
        let Self { block, bodies, cells, reach, .. } = self;
        block.has_inner = false;
        block.tested = 0;
        let pieces = block.pieces();
        let end = block.particles.end;
        let Pairs { inside, pieces: lists, across } = &mut block.outer;
        lists.clear();
        across.clear();
        let positions = bodies.positions();
        let mut len = 0;
        for piece in pieces {
            let mut ahead = piece.end;
            for i in piece {
                let before = len;
                let ranges = cells.ahead(i);
                let last = ranges[0].end.max(ranges[1].end);
                let most = ranges[0].len() + ranges[1].len();
                ahead = ahead.max(last);
                block.tested += most as u64;
                make_room(inside, len + most + 2 * EIGHT);
                for range in ranges {
                    len = P::collect(inside, len, positions, i, range, reach, signs);
                }
                if last > end {
                    let found = &inside[before..len];
                    let own = found.partition_point(|pair| (pair[1] as usize) < end);
                    across.extend_from_slice(&found[own..]);
                    len = before + own;
                }
            }
            lists.push(Piece { pairs: len, ahead: ahead.min(end) });
        }
        inside.truncate(len);
    }
}

/// Builds the inner list of a block from the outer pairs within `reach` and from `more`.
pub(crate) struct Filter<'a, P> {
    pub(crate) block: &'a mut Block,
    pub(crate) bodies: &'a Bodies,
    pub(crate) reach: f64,
    /// Further pairs of all blocks, in order.
    pub(crate) more: &'a [Pair],
    pub(crate) primitives: PhantomData<P>,
}

impl<P: Primitives> NullaryFnOnce for Filter<'_, P> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { block, bodies, reach, more, .. } = self;
        let positions = bodies.positions();
        let squared = reach * reach;
        let pieces = block.pieces();
        let end = block.particles.end;
        let Block { outer, inner, .. } = block;
        let before = |end: usize| more.partition_point(|pair| (pair[0] as usize) < end);
        let mut from = 0;
        inner.clear();
        for (piece, &Piece { pairs, mut ahead }) in pieces.zip(&outer.pieces) {
            keep_near::<P>(&outer.inside[from..pairs], positions, squared, &mut inner.inside);
            for pair in &more[before(piece.start)..before(piece.end)] {
                let next = pair[1] as usize + 1;
                if next > end {
                    inner.across.push(*pair);
                } else {
                    inner.inside.push(*pair);
                    ahead = ahead.max(next);
                }
            }
            inner.pieces.push(Piece { pairs: inner.inside.len(), ahead });
            from = pairs;
        }
        keep_near::<P>(&outer.across, positions, squared, &mut inner.across);
        inner.across.sort_unstable();
        block.has_inner = true;
    }
}

/// Appends to `near` the pairs whose squared distance is at most `squared`.
#[inline(always)]
fn keep_near<P: Primitives>(
    pairs: &[Pair],
    positions: Positions<'_>,
    squared: f64,
    near: &mut Vec<Pair>,
) {
    let mut some_near = [[0; 2]; ROOM];
    for some in pairs.chunks(ROOM) {
        let len = P::filter(some, positions, squared, &mut some_near);
        near.extend_from_slice(&some_near[..len]);
    }
}
