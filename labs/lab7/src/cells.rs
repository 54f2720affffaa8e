//! Task 7.14: sorted occupied cells.

use std::ops::Range;

use common::hard::Disc;

use crate::radix::{Keyed, sort_by_key};
use crate::{Candidate, Hit, Lattice, Square, Window, may_touch, pair_time, reach, span};

/// A disc in a row of cells that its box reaches into.
///
/// A disc is entered in every row that its box touches, but only once in each: in the column
/// where the box begins. Only cells where a box begins exist at all, so that memory grows with the
/// number of discs and not with the square.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The cell where the box begins in this row: row × columns + column.
    pub cell: u64,
    /// In how many further columns the box goes on.
    pub further: u32,
    /// The disc's number; the highest bit says that this is not the first row that it is in.
    disc: u32,
}

const NOT_FIRST: u32 = 1 << 31;

impl Entry {
    /// An entry of disc number `disc`; `first` if it is in no row below.
    pub fn new(cell: u64, further: u32, disc: u32, first: bool) -> Self {
        Self { cell, further, disc: disc | if first { 0 } else { NOT_FIRST } }
    }

    /// The disc's number.
    #[inline]
    pub fn disc(&self) -> u32 {
        self.disc & !NOT_FIRST
    }

    /// Whether this is the lowest row that the disc is in.
    #[inline]
    pub fn is_first(&self) -> bool {
        self.disc & NOT_FIRST == 0
    }
}

impl Keyed for Entry {
    #[inline]
    fn key(&self) -> u64 {
        self.cell
    }
}

/// Calls `meet(a, b)` for every two entries of the same row whose boxes share a column.
///
/// `entries` are sorted by cell, so a row is a stretch of them, and within a row boxes stand in
/// the order of the columns where they begin. Go through them: whoever begins in the columns of an
/// entry, from its own cell up to `further` columns on, follows it directly. The last column
/// of a row and the first of the next have neighbouring numbers, but no box goes on beyond the last
/// column.
///
/// A pair may share several rows and then comes up in each; the caller sorts that out.
///
/// Book: chapter 7, *Sorted occupied cells*.
#[inline]
pub fn for_each_meeting(entries: &[Entry], mut meet: impl FnMut(&Entry, &Entry)) {
    todo!("task 7.14: who shares a column")
}

/// Some rows of the lattice, for one worker: the entries of its rows and what was found there.
#[derive(Default)]
pub struct Strip {
    entries: Vec<Entry>,
    spare: Vec<Entry>,
    counts: Vec<u32>,
    /// The candidates of the last search.
    pub list: Vec<Candidate>,
    /// Pairs looked at in the last search.
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
        sort_by_key(&mut self.entries, limit, &mut self.spare, &mut self.counts);

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
