//! Task 4.1: bins shared by all threads, and their locks.

use std::sync::Arc;

use common_threads::{Lock, Watch};

/// A bin: the numbers of the particles in it, in any order.
pub type Bin = Vec<u32>;

/// The division of a box into regions, which are runs of `bins_each` bins.
#[derive(Clone, Copy, Debug)]
pub struct Cut {
    /// The number of bins in each region. The last region may have fewer.
    pub bins_each: usize,
}

impl Cut {
    /// Returns the number of the region that contains bin `bin`, and the bin's index in the region.
    ///
    /// Region 0 begins with bin 0.
    ///
    /// Book: chapter 4, *Regions and their locks*.
    #[inline]
    pub fn find(self, bin: usize) -> (usize, usize) {
        todo!("task 4.1: which region a bin lies in")
    }
}

/// All bins of a box, divided into regions, with a lock for each region.
///
/// The lock of a region owns the bins of the region. While other threads have access to the
/// regions, the bins can be reached only through the lock.
pub struct Regions {
    /// The division of the bins into regions.
    pub cut: Cut,
    /// The locks of the regions: lock r guards region r.
    pub locks: Vec<Lock<Vec<Bin>>>,
}

impl Regions {
    /// Makes `bins` empty bins, in order, in at most `count` regions.
    ///
    /// - Every region has the same number of bins. Only the last region may have fewer.
    /// - Choose the smallest number of bins per region for which `count` regions suffice.
    /// - Every region has at least one bin.
    /// - Lock r guards the bins of region r.
    ///
    /// Book: chapter 4, *Regions and their locks*.
    pub fn new(bins: usize, count: usize) -> Self {
        todo!("task 4.1b: make the regions and their locks")
    }

    /// Makes `watch` observe every lock.
    pub fn watch(&mut self, watch: &Arc<dyn Watch>) {
        self.locks.iter_mut().for_each(|lock| lock.watch(Arc::clone(watch)));
    }

    /// The bins of each region, while no other thread has access to them. This takes no lock.
    pub fn parts_mut(&mut self) -> impl Iterator<Item = &mut Vec<Bin>> {
        self.locks.iter_mut().map(Lock::get_mut)
    }

    /// Returns a view of all bins, for all threads to read. This takes no lock. No thread can take
    /// a lock while the view exists.
    pub fn view(&mut self) -> View<'_> {
        View { cut: self.cut, regions: self.parts_mut().map(|bins| &bins[..]).collect() }
    }

    /// Returns a bin, while no other thread has access to it.
    pub fn bin_mut(&mut self, bin: usize) -> &mut Bin {
        let (region, index) = self.cut.find(bin);
        &mut self.locks[region].get_mut()[index]
    }
}

/// A read-only view of all bins.
pub struct View<'a> {
    cut: Cut,
    regions: Vec<&'a [Bin]>,
}

impl View<'_> {
    /// The numbers of the particles in a bin.
    #[inline]
    pub fn bin(&self, bin: usize) -> &[u32] {
        let (region, index) = self.cut.find(bin);
        &self.regions[region][index]
    }
}
