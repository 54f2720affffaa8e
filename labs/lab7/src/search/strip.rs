//! A search in sorted occupied cells.

use std::ops::Range;

use common::hard::Disc;

use crate::{
    Candidate, Entry, Hit, Lattice, Square, Window, for_each_meeting, may_touch, pair_time, reach,
    span,
};

/// A digit has at most so many bits: its counts should stay in the nearest cache.
const MOST_BITS: u32 = 12;

/// Below this length the counts cost more than they save.
const FEW: usize = 128;

/// Some rows of the lattice, for one worker: the entries of its rows and what was found there.
#[derive(Default)]
pub struct Strip {
    entries: Vec<Entry>,
    spare: Vec<Entry>,
    counts: Vec<u32>,
    /// The candidates of the last search.
    pub list: Vec<Candidate>,
    /// Pairs tested in the last search.
    pub pair_tests: u64,
}

impl Strip {
    /// Finds the candidates of `window` among the discs that are free, in the rows `rows`.
    pub fn search(
        &mut self,
        discs: &[Disc],
        free: &[bool],
        square: Square,
        window: Window,
        lattice: &Lattice,
        rows: Range<u32>,
    ) {
        self.enter(discs, free, square, window, lattice, rows);
        let limit = lattice.cells();
        sort_by_cell(&mut self.entries, limit, &mut self.spare, &mut self.counts);

        let Self { entries, list, .. } = self;
        list.clear();
        let mut tests = 0;
        for_each_meeting(entries, |a, b| {
            tests += 1;
            // Of all rows that the boxes share, the lowest is the first row of one of them.
            if !(a.is_first() || b.is_first()) {
                return;
            }
            let (a, b) = (a.disc().min(b.disc()), a.disc().max(b.disc()));
            if !may_touch(&discs[a as usize], &discs[b as usize], square.radius) {
                return;
            }
            let time = pair_time(&discs[a as usize], &discs[b as usize], square.radius);
            if let Some(time) = time.filter(|&time| window.contains(time)) {
                list.push(Candidate { time, hit: Hit::Pair(a, b) });
            }
        });
        self.pair_tests = tests;
    }

    /// Makes the entries of all free discs in `rows`.
    fn enter(
        &mut self,
        discs: &[Disc],
        free: &[bool],
        square: Square,
        window: Window,
        lattice: &Lattice,
        rows: Range<u32>,
    ) {
        let reach = reach(square, lattice.fastest);
        self.entries.clear();
        for (number, (disc, free)) in discs.iter().zip(free).enumerate() {
            if !free {
                continue;
            }
            let box_y = span(disc.y, disc.vy, window, reach);
            let (lowest, highest) = (lattice.row(box_y.low), lattice.row(box_y.high));
            let shared = lowest.max(rows.start)..(highest + 1).min(rows.end);
            if shared.is_empty() {
                continue;
            }
            let box_x = span(disc.x, disc.vx, window, reach);
            let column = lattice.column(box_x.low);
            let further = lattice.column(box_x.high) - column;
            for row in shared {
                let cell = lattice.cell(row, column);
                self.entries.push(Entry::new(cell, further, number as u32, row == lowest));
            }
        }
    }
}

/// Sorts `items`, whose cells are all below `limit`, by cell. `spare` and `counts` are memory that
/// is kept from call to call.
///
/// This is a counting sort digit by digit, the lowest first, with as few digits as the limit
/// allows. It reads and writes each item once a digit, in time linear in their number; a sort
/// by comparison would also have to do log₂ n comparisons each, half of them mispredicted.
fn sort_by_cell(items: &mut Vec<Entry>, limit: u64, spare: &mut Vec<Entry>, counts: &mut Vec<u32>) {
    let Some(&filler) = items.first() else { return };
    if items.len() < FEW {
        items.sort_unstable_by_key(|entry| entry.cell);
        return;
    }
    let bits = (u64::BITS - limit.leading_zeros()).max(1);
    let digits = bits.div_ceil(MOST_BITS);
    let width = bits.div_ceil(digits);
    spare.resize(items.len(), filler);
    for digit in 0..digits {
        let shift = digit * width;
        let digit = |item: &Entry| (item.cell >> shift) as usize & ((1 << width) - 1);
        counts.clear();
        counts.resize(1 << width, 0);
        for item in items.iter() {
            counts[digit(item)] += 1;
        }
        let mut sum = 0;
        for count in counts.iter_mut() {
            sum += std::mem::replace(count, sum);
        }
        for item in items.iter() {
            let next = &mut counts[digit(item)];
            spare[*next as usize] = *item;
            *next += 1;
        }
        std::mem::swap(items, spare);
    }
}
