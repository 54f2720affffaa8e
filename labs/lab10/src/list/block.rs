//! The neighbour list: pairs that might touch until the next rebuild.
//!
//! It is a list of pairs, not a list for each particle. A particle of the official scene has two
//! or three of them, and a loop over so few ends where the processor does not expect it.

use std::ops::Range;

use pulp::NullaryFnOnce;

use crate::cells::{Ahead, Cells};
use crate::collect::collect;
use crate::filter::filter;
use crate::kernels::{EIGHT, Kernel, Pair, ROOM, Signs};
use crate::particles::{Bodies, Inner};

/// A band of particles and their pairs.
#[derive(Default)]
pub struct Block {
    /// The particles, in sorted order.
    pub particles: Range<usize>,
    /// All pairs within the reach of the list.
    pub all: Pairs,
    /// The pairs that may touch within the next few steps.
    pub near: Pairs,
    /// Whether `near` is known.
    pub is_short: bool,
    /// How many pairs were looked at to find all.
    pub tested: u64,
}

/// Pairs as places in the sorted order; the first of a pair comes before the second.
#[derive(Default)]
pub struct Pairs {
    /// The pieces of a block, in order.
    pub pieces: Vec<Piece>,
    /// Piece by piece, the pairs whose first particle it holds.
    pub pairs: Vec<Pair>,
}

/// What is computed and moved together: few enough to stay in the cache meanwhile.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    /// Where its particles end; they begin where those of the piece before end.
    pub particles: usize,
    /// Where its pairs end.
    pub pairs: usize,
    /// No particle of its pairs comes at or after this place.
    pub ahead: usize,
}

/// A piece that is being filled.
struct Filling<'a, S> {
    block: &'a mut Block,
    bodies: &'a Bodies,
    reach: f64,
    signs: S,
    /// Pairs found so far.
    len: usize,
    ahead: usize,
}

impl<S: Signs> Ahead for Filling<'_, S> {
    #[inline(always)]
    fn visit(&mut self, i: usize, end: usize, next: Range<usize>) {
        let Self { block, bodies, reach, signs, len, ahead } = self;
        let pairs = &mut block.all.pairs;
        let most = end - i - 1 + next.len();
        block.tested += most as u64;
        *ahead = (*ahead).max(end).max(next.end);
        let room = *len + most + 2 * EIGHT;
        if pairs.len() < room {
            // Not much more: what is not used was written in vain.
            pairs.resize(room + *len / 8, [0; 2]);
        }
        for range in [i + 1..end, next] {
            *len = if range.end + EIGHT <= bodies.len() {
                collect(pairs, *len, &Inner(bodies), i, range, *reach, *signs)
            } else {
                at_the_end(pairs, *len, bodies, i, range, *reach, *signs)
            };
        }
    }
}

/// [`collect`] for particles behind which there are no eight.
#[cold]
fn at_the_end(
    list: &mut [Pair],
    len: usize,
    bodies: &Bodies,
    i: usize,
    range: Range<usize>,
    reach: f64,
    signs: impl Signs,
) -> usize {
    collect(list, len, bodies, i, range, reach, signs)
}

impl Block {
    /// The pairs to look at: the short list, if there is one.
    pub fn pairs(&self) -> &Pairs {
        if self.is_short { &self.near } else { &self.all }
    }

    /// Where the particles end that its pairs push.
    pub fn ahead(&self) -> usize {
        let ahead = self.pairs().pieces.iter().map(|piece| piece.ahead);
        ahead.fold(self.particles.end, usize::max)
    }
}

/// Lists the pairs within `reach` of the particles in `pieces`, ranges of stored cells that follow
/// each other: of each pair the particle that comes first has the other.
pub(crate) struct Fill<'a> {
    pub(crate) block: &'a mut Block,
    pub(crate) bodies: &'a Bodies,
    pub(crate) cells: &'a Cells,
    pub(crate) pieces: &'a [Range<usize>],
    pub(crate) reach: f64,
}

impl Kernel for Fill<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self, signs: impl Signs) {
        let Self { block, bodies, cells, pieces, reach } = self;
        let ends = pieces.iter().map(|piece| cells.particles(piece));
        let start = ends.clone().next().map_or(0, |first| first.start);
        block.particles = start..ends.clone().next_back().map_or(start, |last| last.end);
        block.all.pieces.clear();
        (block.is_short, block.tested) = (false, 0);
        let mut filling = Filling { block, bodies, reach, signs, len: 0, ahead: 0 };
        for (piece, particles) in pieces.iter().zip(ends) {
            filling.ahead = particles.end;
            cells.for_each_ahead(piece.clone(), &mut filling);
            let piece =
                Piece { particles: particles.end, pairs: filling.len, ahead: filling.ahead };
            filling.block.all.pieces.push(piece);
        }
        let len = filling.len;
        block.all.pairs.truncate(len);
    }
}

/// Keeps the pairs of a block that are within `reach`, and adds its `own` of some more.
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
                let len = filter(some, bodies.places(), reach * reach, &mut some_near);
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
