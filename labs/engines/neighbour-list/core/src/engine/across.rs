//! What acts on a block from outside: pairs across its ends, and particles elsewhere.

use std::ops::Range;

use common::soft::Observer;

use crate::kernels::{Contacts, Pair, Positions, Primitives};
use crate::list::Block;

/// The pairs within the cutoff whose particles are in two blocks, in ascending order of the first particle.
#[derive(Default)]
pub(crate) struct Across<P> {
    contacts: Contacts<P>,
    /// Each with the acceleration of its first particle.
    pairs: Vec<(Pair, [f64; 2])>,
}

impl<P: Primitives> Across<P> {
    /// Finds them, before any block moves.
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

    /// The particles of `block` that stand second in a pair, with the acceleration of the first.
    pub(super) fn into(&self, block: &Range<usize>) -> impl Iterator<Item = (u32, [f64; 2])> {
        let pairs = self.pairs.iter().map(|&([_, j], a)| (j, a));
        pairs.filter(|(j, _)| block.contains(&(*j as usize)))
    }

    /// The particles of `piece` that stand first, with their accelerations.
    pub(super) fn from(&self, piece: &Range<usize>) -> impl Iterator<Item = (u32, [f64; 2])> {
        let before = |end| self.pairs.partition_point(|(pair, _)| (pair[0] as usize) < end);
        self.pairs[before(piece.start)..before(piece.end)].iter().map(|&([i, _], a)| (i, a))
    }
}

/// The accelerations of some of an engine's particles in a step by particles elsewhere.
#[derive(Clone, Copy, Default)]
pub struct External<'a> {
    /// The particles as indices into the engine's order, ascending.
    pub indices: &'a [u32],
    /// Their accelerations along x.
    pub x: &'a [f64],
    /// Their accelerations along y.
    pub y: &'a [f64],
}

impl External<'_> {
    /// Those of the particles of `range`: the index and the acceleration.
    pub(super) fn among(&self, range: &Range<usize>) -> impl Iterator<Item = (u32, [f64; 2])> {
        let before = |end: usize| self.indices.partition_point(|&i| (i as usize) < end);
        let part = before(range.start)..before(range.end);
        part.map(|k| (self.indices[k], [self.x[k], self.y[k]]))
    }
}
