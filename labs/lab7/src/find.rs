//! What the ways to find candidate pairs have in common.

use common::hard::Disc;

use crate::{Candidate, Square};

/// A part of the step: the times from `from` up to, but without, `to`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Where it begins, as a part λ of the step.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
}

impl Window {
    /// The whole step, its end included.
    pub const STEP: Self = Self { from: 0.0, to: f64::INFINITY };

    /// Window `k` of `count` equal ones. The last one includes the end of the step.
    pub fn part(k: usize, count: usize) -> Self {
        let at = |k: usize| k as f64 / count as f64;
        let to = if k + 1 == count { f64::INFINITY } else { at(k + 1) };
        Self { from: at(k), to }
    }

    /// Whether a time lies in it.
    #[inline]
    pub fn contains(&self, time: f64) -> bool {
        self.from <= time && time < self.to
    }
}

/// What was found, and what it took.
#[derive(Debug, Default)]
pub struct Found {
    /// The candidates, in lists of any lengths and orders: one for each worker that found some.
    pub lists: Vec<Vec<Candidate>>,
    /// How many pairs were looked at.
    pub pair_tests: u64,
}

impl Found {
    /// Forgets the candidates, keeps the memory, and makes sure that there are `lists` lists.
    pub fn clear(&mut self, lists: usize) {
        self.lists.iter_mut().for_each(Vec::clear);
        if self.lists.len() < lists {
            self.lists.resize_with(lists, Vec::new);
        }
    }
}

/// A way to find the pairs that collide: what the variants of this lab differ in.
pub trait Find {
    /// Called at the start of every step: into how many windows of equal length the finder wants
    /// it cut. Nearly all want one.
    fn windows(&mut self, discs: &[Disc], square: Square) -> usize {
        let _ = (discs, square);
        1
    }

    /// Adds to `found` every pair of discs that are both `free` and that [`pair_time`] says
    /// collide at a time in `window`. It must not miss one, nor find one twice.
    ///
    /// Discs stand where they are at the start of the *step*, whatever the window.
    ///
    /// [`pair_time`]: crate::pair_time
    fn find(
        &mut self,
        discs: &[Disc],
        free: &[bool],
        square: Square,
        window: Window,
        found: &mut Found,
    );
}
