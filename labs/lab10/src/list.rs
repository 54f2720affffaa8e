//! The neighbour list: who might touch whom until the next rebuild.
//!
//! It is a list of pairs, not a list for each particle. A particle of the official scene has two
//! or three of them, and a loop over so few ends where the processor does not expect it.

use std::ops::Range;

use pulp::NullaryFnOnce;

use crate::cells::Ahead;
use crate::{Bodies, Cells};

/// The pairs of a band of particles, one after another.
#[derive(Default)]
pub struct Block {
    /// The particles, in sorted order.
    pub particles: Range<usize>,
    /// Its pieces, in order.
    pub pieces: Vec<Piece>,
    /// Pairs as places in the sorted order, piece by piece; the first of a pair is of this block and
    /// comes before the second.
    pub pairs: Vec<[u32; 2]>,
    /// How many pairs were looked at to find them.
    pub tested: u64,
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
struct Filling<'a> {
    block: &'a mut Block,
    bodies: &'a Bodies,
    reach: f64,
    /// Pairs found so far.
    len: usize,
    ahead: usize,
}

impl Ahead for Filling<'_> {
    #[inline(always)]
    fn visit(&mut self, i: usize, end: usize, next: Range<usize>) {
        let Self { block: Block { pairs, tested, .. }, bodies, reach, len, ahead } = self;
        let most = end - i - 1 + next.len();
        *tested += most as u64;
        *ahead = (*ahead).max(end).max(next.end);
        if pairs.len() < *len + most {
            pairs.resize((2 * *len).max(*len + most), [0; 2]);
        }
        *len = collect(pairs, *len, bodies, i, i + 1..end, *reach);
        *len = collect(pairs, *len, bodies, i, next, *reach);
    }
}

/// Writes a pair [i, j] for every particle j of `range` that is within `reach` of particle `i` (at
/// `reach` is within) into `list`, in ascending order, and brings back where the pairs now end.
///
/// - `list`: `list[..len]` are pairs found before; behind them is room for all of `range`.
/// - `i` and `range`: places in the sorted order; `i` is not in `range`.
///
/// A branch on the distance would be guessed wrong about as often as not. Write every candidate
/// down, and let the next one overwrite it if it was too far: then there is nothing to guess.
///
/// Book: chapter 10, *A list that lasts*.
#[inline(always)]
pub fn collect(
    list: &mut [[u32; 2]],
    len: usize,
    bodies: &Bodies,
    i: usize,
    range: Range<usize>,
    reach: f64,
) -> usize {
    todo!("task 10.2: the neighbours of one particle")
}

impl Block {
    /// Lists the pairs within `reach` of the particles in `pieces`, ranges of stored cells that
    /// follow each other: of each pair the particle that comes first has the other.
    #[inline(always)]
    pub fn fill(&mut self, bodies: &Bodies, all: &Cells, pieces: &[Range<usize>], reach: f64) {
        let ends = pieces.iter().map(|cells| all.particles(cells));
        let start = ends.clone().next().map_or(0, |first| first.start);
        self.particles = start..ends.clone().next_back().map_or(start, |last| last.end);
        self.pieces.clear();
        self.tested = 0;
        let mut filling = Filling { block: self, bodies, reach, len: 0, ahead: 0 };
        for (cells, particles) in pieces.iter().zip(ends) {
            filling.ahead = particles.end;
            all.for_each_ahead(cells.clone(), &mut filling);
            let piece =
                Piece { particles: particles.end, pairs: filling.len, ahead: filling.ahead };
            filling.block.pieces.push(piece);
        }
        let len = filling.len;
        self.pairs.truncate(len);
    }
}

/// Lists the pairs of a block.
pub(crate) struct Fill<'a> {
    pub(crate) block: &'a mut Block,
    pub(crate) bodies: &'a Bodies,
    pub(crate) cells: &'a Cells,
    pub(crate) pieces: &'a [Range<usize>],
    pub(crate) reach: f64,
}

impl NullaryFnOnce for Fill<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.block.fill(self.bodies, self.cells, self.pieces, self.reach);
    }
}
