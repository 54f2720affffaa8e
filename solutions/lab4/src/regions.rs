//! Task 4.1: bins that all threads share, and their locks.

use std::sync::Arc;

use common_threads::{Lock, Watch};

/// The particles in a bin, by their numbers, in any order.
pub type Bin = Vec<u32>;

/// How the bins of a box are cut into regions: runs of `bins_each` bins.
#[derive(Clone, Copy, Debug)]
pub struct Cut {
    /// Bins in each region; the last may have less.
    pub bins_each: usize,
}

impl Cut {
    /// The number of the region that bin `bin` lies in, and the bin's index in it.
    ///
    /// Region 0 begins with bin 0.
    ///
    /// Book: chapter 4, *Regions and their locks*.
    #[inline]
    pub fn find(self, bin: usize) -> (usize, usize) {
        // task 4.1: which region a bin lies in
        (bin / self.bins_each, bin % self.bins_each)
        // end 4.1
    }
}

/// All bins of a box in regions, with a lock for each.
///
/// The lock of a region owns its bins: while other threads can see them, there is no other way to
/// them.
pub struct Regions {
    /// How they are cut.
    pub cut: Cut,
    /// Region r is guarded by lock number r.
    pub locks: Vec<Lock<Vec<Bin>>>,
}

impl Regions {
    /// `bins` empty bins in `count` regions or less, in the order of their numbers.
    ///
    /// All regions have the same number of bins, as few as will do; the last may have less, and no
    /// region has none. Lock number r guards the bins of region r.
    ///
    /// Book: chapter 4, *Regions and their locks*.
    pub fn new(bins: usize, count: usize) -> Self {
        // task 4.1b: make the regions and their locks
        let bins_each = bins.div_ceil(count);
        let region = |number: usize| {
            let first = number * bins_each;
            Lock::new(number, vec![Bin::new(); bins_each.min(bins - first)])
        };
        let locks = (0..bins.div_ceil(bins_each)).map(region).collect();
        Self { cut: Cut { bins_each }, locks }
        // end 4.1b
    }

    /// Tells `watch` of every lock.
    pub fn watch(&mut self, watch: &Arc<dyn Watch>) {
        self.locks.iter_mut().for_each(|lock| lock.watch(Arc::clone(watch)));
    }

    /// The bins of each region, while no other thread sees them: no lock is taken.
    // ANCHOR: parts
    pub fn parts_mut(&mut self) -> impl Iterator<Item = &mut Vec<Bin>> {
        self.locks.iter_mut().map(Lock::get_mut)
    }

    /// All bins, to be read by all threads: no lock is taken, and none can be while this lives.
    pub fn view(&mut self) -> View<'_> {
        View { cut: self.cut, regions: self.parts_mut().map(|bins| &bins[..]).collect() }
    }
    // ANCHOR_END: parts

    /// A bin, while no other thread sees it.
    pub fn bin_mut(&mut self, bin: usize) -> &mut Bin {
        let (region, index) = self.cut.find(bin);
        &mut self.locks[region].get_mut()[index]
    }
}

/// The bins for reading.
pub struct View<'a> {
    cut: Cut,
    regions: Vec<&'a [Bin]>,
}

impl View<'_> {
    /// The particles in a bin.
    #[inline]
    pub fn bin(&self, bin: usize) -> &[u32] {
        let (region, index) = self.cut.find(bin);
        &self.regions[region][index]
    }
}
