//! A search in sorted occupied cells.

use std::ops::Range;

use common::hard::Disc;

use super::{Cut, Deal};
use crate::{Candidate, Entry, Hit, Square, Window, for_each_meeting, may_touch, pair_time};

/// A digit has at most so many bits: its counts should stay in the nearest cache.
const MOST_BITS: u32 = 12;

/// Below this length the counts cost more than they save.
const FEW: usize = 128;

/// What a worker needs to search strips, one after the other, and what it finds there.
#[derive(Default)]
pub struct Searcher {
    entries: Vec<Entry>,
    spare: Vec<Entry>,
    counts: Vec<u32>,
    /// The candidates that it has found.
    pub list: Vec<Candidate>,
    /// How many pairs it has tested.
    pub pair_tests: u64,
}

impl Searcher {
    /// Adds the candidates of `window` in a strip, whose entries all workers have dealt out.
    pub fn search(
        &mut self,
        deals: &[Deal],
        strip: usize,
        cut: &Cut,
        discs: &[Disc],
        square: Square,
        window: Window,
    ) {
        self.sort(deals, strip, cut.cells(strip));
        let Self { entries, list, .. } = self;
        let mut tests = 0;
        for_each_meeting(entries, |p, q| {
            tests += 1;
            let (p_disc, q_disc) = (&discs[p.disc() as usize], &discs[q.disc() as usize]);
            // Nearly always no, and so foreseen by the processor. What it cannot foresee is asked later.
            if !may_touch(p_disc, q_disc, square.radius) {
                return;
            }
            let (a, b) = (p.disc().min(q.disc()), p.disc().max(q.disc()));
            let time = pair_time(&discs[a as usize], &discs[b as usize], square.radius);
            if let Some(time) = time.filter(|&time| window.contains(time))
                // Of all rows that the boxes share, the lowest is the first row of one of them.
                && (p.is_first() || q.is_first())
            {
                list.push(Candidate { time, hit: Hit::Pair(a, b) });
            }
        });
        self.pair_tests += tests;
    }

    /// Collects the entries of a strip, sorted by cell.
    ///
    /// This is a counting sort digit by digit, the lowest first, with as few digits as the number of
    /// cells allows. It reads and writes each entry once a digit, in time linear in their number; a sort
    /// by comparison would also have to do log₂ n comparisons each, half of them mispredicted.
    fn sort(&mut self, deals: &[Deal], strip: usize, cells: Range<u64>) {
        let Self { entries, spare, counts, .. } = self;
        let dealt = deals.iter().flat_map(|deal| deal.entries(strip));
        let n = deals.iter().map(|deal| deal.entries(strip).len()).sum::<usize>();
        if n < FEW {
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
        spare.resize(n, filler);
        counts.resize(1 << width, 0);
        scatter(dealt, entries, counts, |entry| digit(entry, 0));
        for k in 1..digits {
            scatter(entries.iter(), spare, counts, |entry| digit(entry, k));
            std::mem::swap(entries, spare);
        }
    }
}

/// Writes entries to `out` in the order of their digits; those of the same digit keep their order.
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
