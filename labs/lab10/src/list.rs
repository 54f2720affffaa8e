//! The neighbour list: who might touch whom until the next rebuild.

use std::ops::Range;

use crate::cells::Ahead;
use crate::contacts::Push;
use crate::{Bodies, Cells};

/// The neighbours of a range of particles, one after another.
#[derive(Default)]
pub struct Block {
    /// The particles, in sorted order.
    pub particles: Range<usize>,
    /// Where the list of each of them ends in `neighbours`.
    pub ends: Vec<u32>,
    /// Their neighbours' places in the sorted order; each pair stands in the list of the first.
    pub neighbours: Vec<u32>,
    /// How many pairs were looked at to find them.
    pub tested: u64,
    /// What this block's particles do to those of other blocks.
    pub(crate) pushes: Vec<Push>,
}

/// A block that is being filled.
struct Filling<'a> {
    block: &'a mut Block,
    bodies: &'a Bodies,
    reach: f64,
}

impl Ahead for Filling<'_> {
    #[inline(always)]
    fn visit(&mut self, i: usize, end: usize, next: Range<usize>) {
        let Self { block, bodies, reach } = self;
        block.tested += (end - i - 1 + next.len()) as u64;
        collect(&mut block.neighbours, bodies, i, i + 1..end, *reach);
        collect(&mut block.neighbours, bodies, i, next, *reach);
        block.ends.push(block.neighbours.len() as u32);
    }
}

/// Appends to `list` every particle of `range` but `i` itself that is within `reach` of particle
/// `i` (at `reach` is within). All are places in the sorted order.
///
/// A branch on the distance would be guessed wrong about as often as not. Make room for all of
/// `range` first, write every candidate down, and let the next one overwrite it if it was too
/// far: then there is nothing to guess.
///
/// Book: chapter 10, *A list that lasts*.
#[inline(always)]
pub fn collect(list: &mut Vec<u32>, bodies: &Bodies, i: usize, range: Range<usize>, reach: f64) {
    todo!("task 10.2: the neighbours of one particle")
}

impl Block {
    /// Lists the neighbours within `reach` of the particles in `cells`, a range of stored cells:
    /// of each pair the particle that comes first lists the other.
    #[inline(always)]
    pub fn fill(&mut self, bodies: &Bodies, all: &Cells, cells: Range<usize>, reach: f64) {
        self.particles = all.particles(&cells);
        self.ends.clear();
        self.neighbours.clear();
        self.tested = 0;
        all.for_each_ahead(cells, &mut Filling { block: self, bodies, reach });
    }
}
