//! Tasks 9.6 and 9.7, on the host: the launches of a prefix sum and of a sort.

use device::Work;
use device_discs::soft::{Scan, SoftKernels, Sort};

use crate::Lab9;

impl SoftKernels for Lab9 {
    /// Adds the launches of a prefix sum to `work`.
    ///
    /// Each of `scan.levels` has the kernels `scan_blocks` and `add_sums`, and the `launch` on
    /// which they run.
    ///
    /// 1. On the way up, from level 0 to the last level, each level sums its blocks. So each level
    ///    can read the sums of the level below.
    /// 2. On the way down, the last level is already complete. Each level below it, from the last
    ///    but one to level 0, adds the sums of the level above to its blocks.
    ///
    /// Book: chapter 9, *A prefix sum of any length*.
    fn record_scan(scan: &Scan, work: &mut Work<'_>) {
        todo!("task 9.6b: a prefix sum of any length")
    }

    /// Records the launches that sort the particles by bin.
    ///
    /// The tags, positions and velocities of the last step are copied to the sorted arrays.
    /// `sort.starts` becomes the index at which each bin begins.
    ///
    /// - The kernel `count` counts the particles of each bin in `starts`, which must be zero at
    ///   first.
    /// - `scan` turns the counts into starts ([`record_scan`](Self::record_scan)).
    /// - `scatter` gives each particle a slot in its bin, and `order` copies the particle to its
    ///   index.
    ///
    /// The kernels `count`, `scatter` and `order` run once for each particle: `sort.launch`.
    ///
    /// Book: chapter 9, *A counting sort*.
    fn record_sort(sort: &Sort, work: &mut Work<'_>) {
        todo!("task 9.7d: the launches of a sort")
    }

    fn discs() -> &'static str {
        include_str!("discs.wgsl")
    }

    fn scan() -> &'static str {
        include_str!("scan.wgsl")
    }

    fn sort() -> &'static str {
        include_str!("sort.wgsl")
    }

    fn forces() -> &'static str {
        include_str!("forces.wgsl")
    }

    fn position_f32() -> &'static str {
        include_str!("position_f32.wgsl")
    }
}
