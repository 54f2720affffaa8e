//! The finder that plans a step, and then searches window by window and strip by strip.

use std::marker::PhantomData;

use common::hard::Disc;
use workers::Workers;

use super::cut::Cut;
use super::deal::Deal;
use super::lattice::Lattice;
use super::strip::Searcher;
use super::work::expected_work;
use crate::broad_phase::BroadPhase;
use crate::collisions::Collisions;
use crate::find::{Find, Found};
use crate::geometry::{Square, Window};
use crate::survey::Survey;
use crate::threads::SharedCount;

/// The fastest search: it surveys the scene, plans the step, and then tests only pairs whose boxes
/// meet.
///
/// Workers share the work of a window in two ways. First each worker makes the entries of a part of
/// the discs, and appends them to its lists, one for each strip. Then each worker takes a strip,
/// collects its entries from the lists of all workers, searches them, and takes the next strip.
pub struct Planned<C> {
    rules: PhantomData<C>,
    workers: Workers,
    /// The number of windows that the user chose, or `None` if it depends on the scene.
    fixed: Option<usize>,
    /// Whether a window is decided before the next window is searched.
    decided: bool,
    survey: Survey,
    plan: Option<Cut>,
    windows: usize,
    deals: Vec<Deal>,
    searchers: Vec<Searcher>,
    /// Pair tests in this step. `crowding` is the number in the last step as a multiple of the
    /// expected number.
    step_tests: u64,
    crowding: f64,
}

impl<C> Planned<C> {
    /// Makes a finder for `workers`, with a `fixed` number of windows or with a number that fits
    /// the scene.
    pub fn new(workers: Workers, fixed: Option<usize>) -> Self {
        let count = workers.count();
        Self {
            rules: PhantomData,
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

    /// Returns the finder for an engine that may search later windows before the first window is
    /// decided.
    ///
    /// This finder does not expect fewer free discs in later windows.
    pub fn undecided(self) -> Self {
        Self { decided: false, ..self }
    }
}

impl<C: Collisions + BroadPhase> Find for Planned<C> {
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
            self.fixed.unwrap_or_else(|| C::choose_windows(&self.survey, square, self.crowding));
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
        let work = self.deals.iter_mut().enumerate().collect();
        self.workers.map(work, |(worker, deal): (usize, &mut Deal)| {
            let part = (worker * share).min(discs.len())..((worker + 1) * share).min(discs.len());
            let free = &free[part.clone()];
            deal.deal::<C>(&discs[part.clone()], free, part.start, square, window, cut);
        });

        let deals = &self.deals;
        let next = SharedCount::default();
        self.workers.map(self.searchers.iter_mut().collect(), |searcher: &mut Searcher| {
            searcher.list.clear();
            searcher.pair_tests = 0;
            let strips = std::iter::repeat_with(|| next.fetch_add(1));
            for strip in strips.take_while(|&strip| strip < cut.strips()) {
                searcher.search::<C>(deals, strip, cut, discs, square, window);
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
