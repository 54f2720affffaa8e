//! Searches a strip: sorts its entries by cell, and tests the pairs whose boxes meet.

use std::marker::PhantomData;
use std::ops::Range;

use common::hard::Disc;
use pulp::{Arch, NullaryFnOnce};

use super::cut::Cut;
use super::deal::Deal;
use super::paths::Paths;
use crate::broad_phase::BroadPhase;
use crate::collisions::{Candidate, Collisions};
use crate::entry::Entry;
use crate::geometry::{Square, Window};
use crate::pairs::{LANES, may_touch};

/// Greatest number of bits in a digit, so that its counts stay in the nearest cache.
const MOST_BITS: u32 = 12;

/// Number of entries below which counting digits costs more time than it saves.
const LEAST_ENTRIES: usize = 128;

/// The working memory of a worker that searches strips, and its results.
#[derive(Default)]
pub(super) struct Searcher {
    entries: Vec<Entry>,
    scratch: Vec<Entry>,
    counts: Vec<u32>,
    paths: Paths,
    /// The candidates that were found.
    pub(super) list: Vec<Candidate>,
    /// Number of pairs that were tested.
    pub(super) pair_tests: u64,
}

impl Searcher {
    /// Adds the candidates of `window` in a strip, for which all workers have made the entries.
    pub(super) fn search<C: Collisions + BroadPhase>(
        &mut self,
        deals: &[Deal],
        strip: usize,
        cut: &Cut,
        discs: &[Disc],
        square: Square,
        window: Window,
    ) {
        self.sort(deals, strip, cut.cells(strip));
        let Self { entries, paths, list, pair_tests, .. } = self;
        let mut meeting = Meeting::<C> { rules: PhantomData, entries, discs, square, window, list };
        if cut.lattice.in_lanes {
            paths.copy(entries.iter().map(|entry| &discs[entry.disc() as usize]));
            Arch::new().dispatch(Look { meeting, paths, pair_tests });
            return;
        }
        for k in 0..entries.len() {
            let others = C::partners(entries, k);
            *pair_tests += others.len() as u64;
            others.for_each(|l| meeting.ask(k, l));
        }
    }

    /// Collects the entries of a strip, sorted by cell.
    ///
    /// This is a radix sort from the lowest digit, with as few digits as the number of cells
    /// allows. The sort reads and writes each entry once per digit, so its time is linear in the
    /// number of entries. A comparison sort would also need log₂ n comparisons for each entry, and
    /// the processor would mispredict half of these.
    fn sort(&mut self, deals: &[Deal], strip: usize, cells: Range<u64>) {
        let Self { entries, scratch, counts, .. } = self;
        let dealt = deals.iter().flat_map(|deal| deal.entries(strip));
        let n = deals.iter().map(|deal| deal.entries(strip).len()).sum::<usize>();
        if n < LEAST_ENTRIES {
            entries.clear();
            entries.extend(dealt);
            entries.sort_unstable_by_key(|entry| entry.cell);
            return;
        }
        let bits = u64::BITS - (cells.end - cells.start).leading_zeros();
        let digits = bits.div_ceil(MOST_BITS.min(n.ilog2() + 1));
        let width = bits.div_ceil(digits);
        let digit = |entry: &Entry, k: u32| {
            ((entry.cell - cells.start) >> (k * width)) as usize & ((1 << width) - 1)
        };
        let filler = Entry::new(0, 0, 0, true);
        entries.resize(n, filler);
        scratch.resize(n, filler);
        counts.resize(1 << width, 0);
        scatter(dealt, entries, counts, |entry| digit(entry, 0));
        for k in 1..digits {
            scatter(entries.iter(), scratch, counts, |entry| digit(entry, k));
            std::mem::swap(entries, scratch);
        }
    }
}

/// The entries whose pairs are tested, and the list for their candidates.
struct Meeting<'a, C> {
    rules: PhantomData<C>,
    entries: &'a [Entry],
    discs: &'a [Disc],
    square: Square,
    window: Window,
    list: &'a mut Vec<Candidate>,
}

impl<C: Collisions> Meeting<'_, C> {
    /// Adds the candidate of entries `k` and `l`, if there is one.
    #[inline]
    fn ask(&mut self, k: usize, l: usize) {
        let p = &self.entries[k];
        let q = &self.entries[l];
        let a = p.disc().min(q.disc());
        let b = p.disc().max(q.disc());
        // The result is nearly always false, so the processor predicts it. The unpredictable test
        // comes later.
        if !may_touch(&self.discs[a as usize], &self.discs[b as usize], self.square.radius) {
            return;
        }
        if let Some(hit) = C::pair_hit(self.discs, a, b, self.square.radius)
            && self.window.contains(hit.time)
            // The lowest row that both boxes share is the first row of one of them.
            && (p.is_first() || q.is_first())
        {
            self.list.push(hit);
        }
    }

    /// Tests some partners of entry `k`. This is rare, so this function is not inlined into the
    /// loop that calls it.
    #[inline(never)]
    fn ask_some(&mut self, k: usize, partners: Range<usize>) {
        partners.for_each(|l| self.ask(k, l));
    }
}

/// A vector kernel that tests all pairs of a strip, several at a time.
struct Look<'a, C> {
    meeting: Meeting<'a, C>,
    paths: &'a Paths,
    pair_tests: &'a mut u64,
}

impl<C: Collisions + BroadPhase> NullaryFnOnce for Look<'_, C> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { mut meeting, paths, pair_tests } = self;
        let radius = meeting.square.radius;
        for k in 0..meeting.entries.len() {
            let mut others = C::partners(meeting.entries, k);
            *pair_tests += others.len() as u64;
            while let Some(first) = paths.next_that_may_touch(k, others.clone(), radius) {
                others.start = others.end.min(first + LANES);
                meeting.ask_some(k, first..others.start);
            }
        }
    }
}

/// Writes entries to `out` in the order of their digits. Entries with the same digit keep their
/// order.
fn scatter<'a>(
    entries: impl Iterator<Item = &'a Entry> + Clone,
    out: &mut [Entry],
    counts: &mut [u32],
    digit: impl Fn(&Entry) -> usize,
) {
    counts.fill(0);
    entries.clone().for_each(|entry| counts[digit(entry)] += 1);
    let mut sum = 0;
    for count in counts.iter_mut() {
        sum += std::mem::replace(count, sum);
    }
    entries.for_each(|entry| {
        let next = &mut counts[digit(entry)];
        out[*next as usize] = *entry;
        *next += 1;
    });
}
