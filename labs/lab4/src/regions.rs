//! Task 4.2: bins under locks.

use common::soft::Particle;
use parking_lot::Mutex;

/// All bins of a box, cut into regions of consecutive bins, with a lock for each region.
///
/// It borrows the bins for the time of rebinning. While it lives nobody gets at them without a
/// lock; afterwards everybody reads them without one.
#[derive(Debug)]
pub struct Regions<'a> {
    bins_each: usize,
    regions: Vec<Mutex<&'a mut [Vec<Particle>]>>,
}

impl<'a> Regions<'a> {
    /// Cuts `bins` into at most `count` regions, all of the same number of bins but the last,
    /// which may have less.
    pub fn new(bins: &'a mut [Vec<Particle>], count: usize) -> Self {
        let bins_each = bins.len().div_ceil(count);
        Self { bins_each, regions: bins.chunks_mut(bins_each).map(Mutex::new).collect() }
    }

    /// The region that bin number `bin` lies in, and the bin's place in it.
    ///
    /// The first region begins with bin 0. All regions but the last have `bins_each` bins.
    ///
    /// Book: chapter 4, *Many locks*.
    #[inline]
    pub fn find(&self, bin: usize) -> (&Mutex<&'a mut [Vec<Particle>]>, usize) {
        todo!("task 4.2: which region a bin lies in")
    }

    /// How many regions there are.
    pub fn count(&self) -> usize {
        self.regions.len()
    }
}
