//! Sums of accelerations.

use std::ops::Range;

use super::across::Across;

/// The accelerations of consecutive particles.
#[derive(Default)]
pub(crate) struct Sums {
    /// The first particle.
    first: usize,
    x: Vec<f64>,
    y: Vec<f64>,
}

impl Sums {
    /// Begins anew with particle `first`.
    pub(crate) fn begin(&mut self, first: usize) {
        self.first = first;
        self.x.clear();
        self.y.clear();
    }

    /// Begins with zero for the particles after the last, up to particle `end`; if there are as many,
    /// nothing happens.
    #[inline(always)]
    pub(crate) fn reach(&mut self, end: usize) {
        let len = end - self.first;
        if len > self.x.len() {
            self.x.resize(len, 0.0);
            self.y.resize(len, 0.0);
        }
    }

    /// Forgets the particles before `first`.
    #[inline(always)]
    pub(crate) fn drop_until(&mut self, first: usize) {
        let k = first - self.first;
        for sums in [&mut self.x, &mut self.y] {
            sums.copy_within(k.., 0);
            sums.truncate(sums.len() - k);
        }
        self.first = first;
    }

    /// Of the particles up to `end`.
    #[inline(always)]
    pub(crate) fn until(&self, end: usize) -> (&[f64], &[f64]) {
        let len = end - self.first;
        (&self.x[..len], &self.y[..len])
    }

    #[inline(always)]
    pub(crate) fn add(&mut self, i: u32, ax: f64, ay: f64) {
        let i = i as usize - self.first;
        self.x[i] += ax;
        self.y[i] += ay;
    }

    /// Adds the accelerations of the block's particles by particles of earlier blocks.
    #[inline(always)]
    pub(crate) fn add_from_before(&mut self, across: &Across, block: &Range<usize>) {
        for &([_, j], [ax, ay]) in &across.pairs {
            if block.contains(&(j as usize)) {
                self.reach(j as usize + 1);
                self.add(j, -ax, -ay);
            }
        }
    }

    /// Adds the accelerations of the particles of `piece` by particles of later blocks.
    #[inline(always)]
    pub(crate) fn add_from_behind(&mut self, across: &Across, piece: &Range<usize>) {
        for &([i, _], [ax, ay]) in across.from(piece) {
            self.add(i, ax, ay);
        }
    }
}
