//! Discs as a structure of arrays, for pair tests in vector registers.

use std::array::from_fn;
use std::ops::Range;

use common::hard::Disc;

use crate::pairs::LANES;

/// The positions and velocities of discs, in the caller's order.
#[derive(Default)]
pub(super) struct Paths {
    x: Vec<f64>,
    y: Vec<f64>,
    vx: Vec<f64>,
    vy: Vec<f64>,
}

impl Paths {
    /// Copies these discs.
    pub(super) fn copy<'a>(&mut self, discs: impl ExactSizeIterator<Item = &'a Disc>) {
        let Self { x, y, vx, vy } = self;
        // The last lanes also read elements after the last disc, but the pairs of these elements
        // are never used.
        for array in [&mut *x, y, vx, vy] {
            array.resize(discs.len() + LANES, 0.0);
        }
        for (k, disc) in discs.enumerate() {
            x[k] = disc.x;
            y[k] = disc.y;
            vx[k] = disc.vx;
            vy[k] = disc.vy;
        }
    }

    /// Tests the pairs of disc `a` with the discs in `others` until one [may
    /// touch](crate::may_touch).
    ///
    /// The function tests [`LANES`] pairs at a time.
    ///
    /// Returns the first index of the [`LANES`] pairs that were tested last, or `None` if no pair
    /// may touch.
    #[inline(always)]
    pub(super) fn next_that_may_touch(
        &self,
        a: usize,
        others: Range<usize>,
        radius: f64,
    ) -> Option<usize> {
        let limit = 4.000_001 * radius * radius;
        // All slices have the same length, so the compiler tests only once whether the lanes are in
        // bounds.
        let n = self.x.len();
        let all = [&self.x[..n], &self.y[..n], &self.vx[..n], &self.vy[..n]];
        let from = all.map(|of| of[a]);
        let mut first = others.start;
        while first < others.end {
            let [x, y, vx, vy] = from_fn(|k| differences(all[k], first, from[k]));
            let mut any = false;
            for lane in 0..LANES {
                let cross = x[lane] * vy[lane] - y[lane] * vx[lane];
                let speed = vx[lane] * vx[lane] + vy[lane] * vy[lane];
                any |= cross * cross <= limit * speed;
            }
            if any {
                return Some(first);
            }
            first += LANES;
        }
        None
    }
}

/// Returns the [`LANES`] numbers from index `first` on, each minus `from`.
#[inline(always)]
fn differences(numbers: &[f64], first: usize, from: f64) -> [f64; LANES] {
    let to = &numbers[first..first + LANES];
    from_fn(|lane| to[lane] - from)
}
