//! Sorted occupied cells, window by window, strip by strip.

use std::ops::Range;

use common::hard::Disc;

use super::{Find, Found, Strip};
use crate::{Lattice, Square, Survey, Window, Workers, choose_windows, expected_work};

/// Strips are cut so that each has as many discs as another, counted in so many slices.
const SLICES: usize = 1024;

/// The fastest of this lab: it surveys the scene, plans the step, and then looks only at pairs
/// whose boxes meet.
///
/// Workers share nothing: each has a strip of rows, makes the entries of its own rows and searches
/// them. Every worker reads all discs, which is cheap beside what it saves.
pub struct Planned {
    workers: Workers,
    /// The number of windows that the user wants, if any.
    fixed: Option<usize>,
    survey: Survey,
    lattice: Option<Lattice>,
    windows: usize,
    strips: Vec<(Range<u32>, Strip)>,
    /// Pairs tested in this step, and how many times as many as expected in the last.
    step_tests: u64,
    crowding: f64,
}

impl Planned {
    /// A finder for `workers`, with a `fixed` number of windows or with one that fits the scene.
    pub fn new(workers: Workers, fixed: Option<usize>) -> Self {
        Self {
            workers,
            fixed,
            survey: Survey::default(),
            lattice: None,
            windows: 1,
            strips: Vec::new(),
            step_tests: 0,
            crowding: 1.0,
        }
    }

    /// Gives every worker rows with an equal number of discs.
    fn cut_strips(&mut self, discs: &[Disc], rows: u32, row: impl Fn(f64) -> u32) {
        let workers = self.workers.count();
        self.strips.resize_with(workers, Default::default);
        let slice = |row: u32| (u64::from(row) * SLICES as u64 / u64::from(rows)) as usize;
        let mut slices = [0_usize; SLICES];
        for disc in discs.iter().filter(|_| workers > 1) {
            slices[slice(row(disc.y))] += 1;
        }
        let mut discs_below = 0;
        let mut ends = Vec::with_capacity(workers);
        for (k, count) in slices.iter().enumerate() {
            discs_below += count;
            while ends.len() + 1 < workers && discs_below * workers > (ends.len() + 1) * discs.len()
            {
                ends.push(((k as u64 + 1) * u64::from(rows) / SLICES as u64) as u32);
            }
        }
        ends.resize(workers, rows);
        let mut start = 0;
        for ((strip, _), end) in self.strips.iter_mut().zip(ends) {
            *strip = start..end;
            start = end;
        }
    }
}

impl Find for Planned {
    fn windows(&mut self, discs: &[Disc], square: Square) -> usize {
        if self.lattice.is_some() && self.fixed.is_none() {
            let (_, expected) = expected_work(&self.survey, square, self.windows);
            self.crowding = (self.step_tests as f64 / expected.max(1.0)).max(1.0);
        }
        self.step_tests = 0;
        self.survey = Survey::of(discs, square);
        self.windows =
            self.fixed.unwrap_or_else(|| choose_windows(&self.survey, square, self.crowding));
        let lattice = Lattice::new(&self.survey, square, self.windows);
        self.cut_strips(discs, lattice.rows(), |y| lattice.row(y));
        self.lattice = Some(lattice);
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
        let lattice = self.lattice.expect("windows() has planned the step");
        self.workers.for_few(&mut self.strips, |_, (rows, strip)| {
            strip.search(discs, free, square, window, &lattice, rows.clone());
        });
        found.clear(self.strips.len());
        for (list, (_, strip)) in found.lists.iter_mut().zip(&mut self.strips) {
            std::mem::swap(list, &mut strip.list);
            found.pair_tests += strip.pair_tests;
            self.step_tests += strip.pair_tests;
        }
    }
}
