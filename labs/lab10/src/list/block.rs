//! The neighbour list: pairs that might touch until the next rebuild.
//!
//! It is a list of pairs, not a list for each particle. A particle of the official scene has two
//! or three of them, and a loop over so few ends where the processor does not expect it.

use std::ops::Range;

use pulp::NullaryFnOnce;

use crate::cells::{Ahead, Cells};
use crate::collect::collect;
use crate::filter::filter;
use crate::kernels::{EIGHT, Kernel, Pair, Places, ROOM, Signs};
use crate::particles::{Bodies, Inner};

/// Consecutive particles of the sorted order and their pairs.
#[derive(Default)]
pub struct Block {
    /// The particles.
    pub particles: Range<usize>,
    /// All pairs within the reach of the list.
    pub outer: Pairs,
    /// The pairs that may touch within the next few steps.
    pub inner: Pairs,
    /// Whether `inner` is known.
    pub has_inner: bool,
    /// How many pairs were tested to find all.
    pub tested: u64,
}

/// Pairs of a block as indices into the sorted order, the smaller index first. The block has the first particle.
#[derive(Default)]
pub struct Pairs {
    /// The pieces of the block, in order.
    pub pieces: Vec<Piece>,
    /// Piece by piece, the pairs whose second particle is in the block as well.
    pub inside: Vec<Pair>,
    /// The pairs whose second particle is in a later block.
    pub across: Vec<Pair>,
}

/// What is computed and moved together: few enough to stay in the cache meanwhile.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    /// Where its particles end; they begin where those of the piece before end.
    pub particles: usize,
    /// Where its pairs end.
    pub pairs: usize,
    /// No particle of its pairs comes at or after this index.
    pub ahead: usize,
}

impl Pairs {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.inside.len() + self.across.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl Block {
    /// The pairs to look at: the inner list, if there is one.
    pub fn pairs(&self) -> &Pairs {
        if self.has_inner { &self.inner } else { &self.outer }
    }

    /// Whether a particle of `indices`, ascending, is in the block.
    pub fn has_any(&self, indices: &[u32]) -> bool {
        let next = indices.partition_point(|&i| (i as usize) < self.particles.start);
        indices.get(next).is_some_and(|&i| (i as usize) < self.particles.end)
    }
}

/// Lists the pairs within `reach` of the particles in `pieces`, ranges of stored cells that follow
/// each other: of each pair the particle that comes first has the other.
pub(crate) struct Collect<'a> {
    pub(crate) block: &'a mut Block,
    pub(crate) bodies: &'a Bodies,
    pub(crate) cells: &'a Cells,
    pub(crate) pieces: &'a [Range<usize>],
    pub(crate) reach: f64,
}

impl Kernel for Collect<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self, signs: impl Signs) {
        let Self { block, bodies, cells, pieces, reach } = self;
        let ends = pieces.iter().map(|piece| cells.particles(piece));
        let start = ends.clone().next().map_or(0, |first| first.start);
        block.particles = start..ends.clone().next_back().map_or(start, |last| last.end);
        block.outer.pieces.clear();
        block.outer.across.clear();
        (block.has_inner, block.tested) = (false, 0);
        let mut collecting = Collecting { block, bodies, reach, signs, len: 0, ahead: 0 };
        for (piece, particles) in pieces.iter().zip(ends) {
            collecting.ahead = particles.end;
            cells.for_each_ahead(piece.clone(), &mut collecting);
            let Collecting { len: pairs, ahead, .. } = collecting;
            let ahead = ahead.min(collecting.block.particles.end);
            let piece = Piece { particles: particles.end, pairs, ahead };
            collecting.block.outer.pieces.push(piece);
        }
        let len = collecting.len;
        block.outer.inside.truncate(len);
    }
}

/// A block whose pairs are being listed.
struct Collecting<'a, S> {
    block: &'a mut Block,
    bodies: &'a Bodies,
    reach: f64,
    signs: S,
    /// Pairs inside found so far.
    len: usize,
    /// Where the particles end that pairs of the piece may have.
    ahead: usize,
}

impl<S: Signs> Ahead for Collecting<'_, S> {
    #[inline(always)]
    fn visit(&mut self, i: usize, end: usize, next: Range<usize>) {
        let Self { block, bodies, reach, signs, len, ahead } = self;
        let Pairs { inside, across, .. } = &mut block.outer;
        let most = end - i - 1 + next.len();
        block.tested += most as u64;
        let (before, last) = (*len, end.max(next.end));
        *ahead = (*ahead).max(last);
        let room = before + most + 2 * EIGHT;
        if inside.len() < room {
            // Not much more: what is not used was written in vain.
            inside.resize(room + before / 8, [0; 2]);
        }
        for range in [i + 1..end, next] {
            *len = if range.end + EIGHT <= bodies.len() {
                collect(inside, *len, &Inner(bodies), i, range, *reach, *signs)
            } else {
                at_the_end(inside, *len, bodies, i, range, *reach, *signs)
            };
        }
        if last > block.particles.end {
            let found = &inside[before..*len];
            let own = found.partition_point(|pair| (pair[1] as usize) < block.particles.end);
            across.extend_from_slice(&found[own..]);
            *len = before + own;
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

/// Makes the inner list of a block: its pairs that are within `reach`, and its own of some more.
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
        let Block { outer, inner: Pairs { pieces, inside, across }, particles, .. } = block;
        let (places, squared) = (bodies.places(), reach * reach);
        let before = |end: usize| more.partition_point(|pair| (pair[0] as usize) < end);
        let (mut from, mut done) = (0, before(particles.start));
        pieces.clear();
        inside.clear();
        across.clear();
        for piece in &outer.pieces {
            keep_near(&outer.inside[from..piece.pairs], places, squared, inside);
            let (own, mut ahead) = (&more[done..before(piece.particles)], piece.ahead);
            for pair in own {
                let last = pair[1] as usize;
                if last < particles.end {
                    inside.push(*pair);
                    ahead = ahead.max(last + 1);
                } else {
                    across.push(*pair);
                }
            }
            pieces.push(Piece { pairs: inside.len(), ahead, ..*piece });
            (from, done) = (piece.pairs, done + own.len());
        }
        keep_near(&outer.across, places, squared, across);
        across.sort_unstable();
        block.has_inner = true;
    }
}

/// Appends the pairs that are near to `near`.
#[inline(always)]
fn keep_near(pairs: &[Pair], places: Places<'_>, squared: f64, near: &mut Vec<Pair>) {
    let mut some_near = [[0; 2]; ROOM];
    for some in pairs.chunks(ROOM) {
        let len = filter(some, places, squared, &mut some_near);
        near.extend_from_slice(&some_near[..len]);
    }
}
