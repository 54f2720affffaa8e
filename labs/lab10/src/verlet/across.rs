//! Pairs across the ends of blocks.

use std::ops::Range;

use common::soft::Observer;

use super::contacts::Contacts;
use crate::kernels::{Pair, Places};
use crate::list::Block;

/// The pairs within the cutoff whose particles are in two blocks, in ascending order of the first particle.
#[derive(Default)]
pub(crate) struct Across {
    contacts: Contacts,
    /// Each with the acceleration of its first particle.
    pub(super) pairs: Vec<(Pair, [f64; 2])>,
}

impl Across {
    /// Finds them, before any block moves.
    pub(crate) fn find<O: Observer>(
        &mut self,
        blocks: &[Block],
        places: Places<'_>,
        observer: &mut O,
    ) {
        self.pairs.clear();
        for block in blocks {
            let Self { contacts, pairs } = self;
            contacts.for_each(&block.pairs().across, places, |pair, a, r2| {
                pairs.push((pair, a));
                observer.seen(r2);
                observer.seen(r2);
            });
        }
    }

    /// The pairs whose first particle is in `range`.
    pub(super) fn from(&self, range: &Range<usize>) -> &[(Pair, [f64; 2])] {
        let before = |end| self.pairs.partition_point(|(pair, _)| (pair[0] as usize) < end);
        &self.pairs[before(range.start)..before(range.end)]
    }
}
