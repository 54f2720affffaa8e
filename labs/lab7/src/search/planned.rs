//! Sorted occupied cells, window by window, strip by strip.

use common::hard::Disc;

use super::{Cut, Find, Found, Lattice, Searcher, expected_work};
use crate::{Entry, SharedCount, Square, Survey, Window, Workers, choose_windows, reach, span};

/// The fastest of this lab: it surveys the scene, plans the step, and then looks only at pairs
/// whose boxes meet.
///
/// Workers share the work of a window twice. First each has a part of the discs and deals their entries out to
/// the strips, into lists of its own. Then each takes a strip, collects its entries from the lists
/// of all workers and searches it, and takes the next one.
pub struct Planned {
    workers: Workers,
    /// The number of windows that the user wants, if any.
    fixed: Option<usize>,
    /// Whether a window is decided before the next one is searched.
    decided: bool,
    survey: Survey,
    plan: Option<Cut>,
    windows: usize,
    deals: Vec<Deal>,
    searchers: Vec<Searcher>,
    /// Pairs tested in this step, and how many times as many as expected in the last.
    step_tests: u64,
    crowding: f64,
}

impl Planned {
    /// A finder for `workers`, with a `fixed` number of windows or with one that fits the scene.
    pub fn new(workers: Workers, fixed: Option<usize>) -> Self {
        let count = workers.count();
        Self {
            workers,
            fixed,
            decided: true,
            survey: Survey::default(),
            plan: None,
            windows: 1,
            deals: (0..count).map(|_| Deal::default()).collect(),
            searchers: (0..count).map(|_| Searcher::default()).collect(),
            step_tests: 0,
            crowding: 1.0,
        }
    }

    /// The same for an engine that may have to search later windows before it knows which discs collide in the first:
    /// it does not count on fewer discs there.
    pub fn undecided(self) -> Self {
        Self { decided: false, ..self }
    }
}

impl Find for Planned {
    fn home(&self) -> Workers {
        self.workers.clone()
    }

    fn windows(&mut self, discs: &[Disc], square: Square) -> usize {
        if self.plan.is_some() && self.fixed.is_none() {
            let expected = expected_work(&self.survey, square, self.windows);
            self.crowding = (self.step_tests as f64 / expected.pairs.max(1.0)).max(1.0);
        }
        self.step_tests = 0;
        self.survey = Survey::by(&self.workers, discs, square);
        if !self.decided {
            self.survey.meetings = 0.0;
        }
        self.windows =
            self.fixed.unwrap_or_else(|| choose_windows(&self.survey, square, self.crowding));
        let lattice = Lattice::new(&self.survey, square, self.windows);
        self.plan = Some(Cut::new(lattice, discs));
        self.windows
    }

    fn find(
        &mut self,
        discs: &[Disc],
        free: &[bool],
        square: Square,
        window: Window,
        found: &mut Found,
    ) {
        let cut = self.plan.as_ref().expect("windows() has planned the step");
        let share = discs.len().div_ceil(self.deals.len()).max(1);
        self.workers.for_few(&mut self.deals, |worker, deal| {
            let part = (worker * share).min(discs.len())..((worker + 1) * share).min(discs.len());
            let (discs, free) = (&discs[part.clone()], &free[part.clone()]);
            deal.deal(discs, free, part.start, square, window, cut);
        });

        let (deals, next) = (&self.deals, SharedCount::default());
        self.workers.for_few(&mut self.searchers, |_, searcher| {
            searcher.list.clear();
            searcher.pair_tests = 0;
            let strips = std::iter::repeat_with(|| next.fetch_add(1));
            for strip in strips.take_while(|&strip| strip < cut.strips()) {
                searcher.search(deals, strip, cut, discs, square, window);
            }
        });
        found.clear(self.searchers.len());
        for (list, searcher) in found.lists.iter_mut().zip(&mut self.searchers) {
            std::mem::swap(list, &mut searcher.list);
            found.pair_tests += searcher.pair_tests;
            self.step_tests += searcher.pair_tests;
        }
    }
}

/// After so many discs the list of entries that do not exist is emptied.
const PIECE: usize = 1024;

/// The entries of some discs: a list for each strip, and one more for entries that do not exist.
#[derive(Default)]
pub struct Deal {
    lists: Vec<Vec<Entry>>,
}

impl Deal {
    /// Makes the entries of those of `discs` that are `free`. The first of them has number `first`.
    ///
    /// Nearly all boxes reach into one row or two, either as often as the other. So the processor
    /// could not guess a branch, and a wrong guess costs more than an entry: there are always two,
    /// and where the box reaches into one row only the second goes to a list that nobody reads.
    pub fn deal(
        &mut self,
        discs: &[Disc],
        free: &[bool],
        first: usize,
        square: Square,
        window: Window,
        cut: &Cut,
    ) {
        let (lattice, nowhere) = (&cut.lattice, cut.strips());
        self.lists.iter_mut().for_each(Vec::clear);
        self.lists.resize_with(nowhere + 1, Vec::new);
        let reach = reach(square, lattice.fastest);
        for (k, (discs, free)) in discs.chunks(PIECE).zip(free.chunks(PIECE)).enumerate() {
            for (number, (disc, free)) in (first + k * PIECE..).zip(discs.iter().zip(free)) {
                if !free {
                    continue;
                }
                let (x, y) =
                    (span(disc.x, disc.vx, window, reach), span(disc.y, disc.vy, window, reach));
                let (lowest, highest) = (lattice.row(y.low), lattice.row(y.high));
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

    /// The entries of a strip.
    pub fn entries(&self, strip: usize) -> &[Entry] {
        &self.lists[strip]
    }
}
