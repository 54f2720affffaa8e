//! Distributes the entries of discs to strips.

use common::hard::Disc;

use super::cut::Cut;
use crate::broad_phase::BroadPhase;
use crate::entry::Entry;
use crate::geometry::{Square, Window, reach};

/// Number of discs after which the list of unused entries is cleared.
const PIECE: usize = 1024;

/// The entries of some discs: a list for each strip, and another list for unused entries.
#[derive(Default)]
pub(super) struct Deal {
    lists: Vec<Vec<Entry>>,
}

impl Deal {
    /// Makes the entries of all `discs` that are `free`. The first disc has number `first`.
    ///
    /// Nearly all boxes reach into one row or into two, and both cases are equally frequent. So the
    /// processor could not predict a branch, and a misprediction costs more than an entry.
    /// Therefore two entries are always made. If the box reaches into one row only, the second
    /// entry goes to a list that is never read.
    pub(super) fn deal<C: BroadPhase>(
        &mut self,
        discs: &[Disc],
        free: &[bool],
        first: usize,
        square: Square,
        window: Window,
        cut: &Cut,
    ) {
        let lattice = &cut.lattice;
        let nowhere = cut.strips();
        self.lists.iter_mut().for_each(Vec::clear);
        self.lists.resize_with(nowhere + 1, Vec::new);
        let reach = reach(square, lattice.fastest);
        for (k, (discs, free)) in discs.chunks(PIECE).zip(free.chunks(PIECE)).enumerate() {
            for (number, (disc, free)) in (first + k * PIECE..).zip(discs.iter().zip(free)) {
                if !free {
                    continue;
                }
                let x = C::span(disc.x, disc.vx, window, reach);
                let y = C::span(disc.y, disc.vy, window, reach);
                let lowest = lattice.row(y.low);
                let highest = lattice.row(y.high);
                let column = lattice.column(x.low);
                let further = lattice.column(x.high) - column;
                let mut enter = |strip: usize, row: u32| {
                    let cell = lattice.cell(row, column);
                    let entry = Entry::new(cell, further, number as u32, row == lowest);
                    self.lists[strip].push(entry);
                };
                enter(cut.strip(lowest), lowest);
                let second = highest.min(lowest + 1);
                enter([nowhere, cut.strip(second)][usize::from(second > lowest)], second);
                for row in lowest + 2..=highest {
                    enter(cut.strip(row), row);
                }
            }
            self.lists[nowhere].clear();
        }
    }

    /// Returns the entries of a strip.
    pub(super) fn entries(&self, strip: usize) -> &[Entry] {
        &self.lists[strip]
    }
}
