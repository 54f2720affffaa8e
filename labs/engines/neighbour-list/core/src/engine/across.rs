//! Forces on a block from outside: from pairs across its ends, and from particles of other
//! processes.

use std::ops::Range;

use common::soft::Observer;

use crate::kernels::{Contacts, Pair, Positions, Primitives};
use crate::list::Block;

/// The pairs within the cutoff whose particles are in two blocks, ordered by the first particle.
#[derive(Default)]
pub(crate) struct Across<P> {
    contacts: Contacts<P>,
    /// Each pair, with the acceleration of its first particle.
    pairs: Vec<(Pair, [f64; 2])>,
}

impl<P: Primitives> Across<P> {
    /// Finds the pairs and computes their accelerations. Call this before any block moves.
    pub(super) fn find(
        &mut self,
        blocks: &[Block],
        positions: Positions<'_>,
        observer: &mut impl Observer,
    ) {
        self.pairs.clear();
        for block in blocks {
            let Self { contacts, pairs } = self;
            contacts.for_each(&block.pairs().across, positions, |pair, a, r2| {
                pairs.push((pair, a));
                observer.seen(r2);
                observer.seen(r2);
            });
        }
    }

    /// Returns the particles of `block` that come second in a pair, each with the acceleration of
    /// the first particle.
    pub(super) fn into(&self, block: &Range<usize>) -> impl Iterator<Item = (u32, [f64; 2])> {
        let pairs = self.pairs.iter().map(|&([_, j], a)| (j, a));
        pairs.filter(|(j, _)| block.contains(&(*j as usize)))
    }

    /// Returns the particles of `piece` that come first in a pair, with their accelerations.
    pub(super) fn from(&self, piece: &Range<usize>) -> impl Iterator<Item = (u32, [f64; 2])> {
        let before = |end| self.pairs.partition_point(|(pair, _)| (pair[0] as usize) < end);
        self.pairs[before(piece.start)..before(piece.end)].iter().map(|&([i, _], a)| (i, a))
    }
}

/// Accelerations of some of the engine's particles due to particles outside the engine, in one
/// step.
#[derive(Clone, Copy, Default)]
pub struct External<'a> {
    /// The particles as indices into the engine's order, ascending.
    pub indices: &'a [u32],
    /// The accelerations of these particles along x.
    pub x: &'a [f64],
    /// The accelerations of these particles along y.
    pub y: &'a [f64],
}

impl External<'_> {
    /// Returns the index and the acceleration of each listed particle in `range`.
    pub(super) fn among(&self, range: &Range<usize>) -> impl Iterator<Item = (u32, [f64; 2])> {
        let before = |end: usize| self.indices.partition_point(|&i| (i as usize) < end);
        let part = before(range.start)..before(range.end);
        part.map(|k| (self.indices[k], [self.x[k], self.y[k]]))
    }
}
