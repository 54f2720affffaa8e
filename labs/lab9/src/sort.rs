//! Tasks 9.6 and 9.7, on the host: the launches of a prefix sum and of a sort.

use crate::gpu::Work;
use crate::soft::{Loaded, Precision, Scan};

impl Scan {
    /// Adds the launches to `work`.
    ///
    /// On the way up each level's blocks are summed, from level 0 to the last, so that each level
    /// finds the sums of the one below. On the way down the last level is done already; each level
    /// below it, from the last but one to level 0, adds the sums to its blocks.
    ///
    /// Book: chapter 9, *A prefix sum of any length*.
    pub fn record(&self, work: &mut Work<'_>) {
        todo!("task 9.6b: a prefix sum of any length")
    }
}

impl<P: Precision> Loaded<P> {
    /// Writes down the launches that sort the particles: the tags, positions and velocities of the
    /// last step go to the sorted arrays, and `starts` says where each bin begins.
    ///
    /// - `starts` is counted up from zero by the kernel `count`;
    /// - `scan` turns the counts into starts ([`Scan::record`]);
    /// - `scatter` gives each particle a slot in its bin, `order` copies it to its index.
    ///
    /// All three kernels run once for each particle: `self.launch`.
    ///
    /// Book: chapter 9, *A counting sort*.
    pub(crate) fn record_sort(&self, work: &mut Work<'_>) {
        todo!("task 9.7d: the launches of a sort")
    }
}
