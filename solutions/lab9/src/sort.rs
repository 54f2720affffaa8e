//! Tasks 9.6 and 9.7, on the host: the launches of a prefix sum and of a sort.

use device::Work;
use device_discs::soft::{Scan, SoftKernels, Sort};

use crate::Lab9;

impl SoftKernels for Lab9 {
    /// Adds the launches of a prefix sum to `work`: each of `scan.levels` has the kernels `scan_blocks` and
    /// `add_sums`, and the `launch` that they run on.
    ///
    /// On the way up each level's blocks are summed, from level 0 to the last, so that each level
    /// finds the sums of the one below. On the way down the last level is done already; each level
    /// below it, from the last but one to level 0, adds the sums to its blocks.
    ///
    /// Book: chapter 9, *A prefix sum of any length*.
    fn record_scan(scan: &Scan, work: &mut Work<'_>) {
        // task 9.6b: a prefix sum of any length
        for level in &scan.levels {
            work.launch(&level.scan_blocks, level.launch);
        }
        for level in scan.levels.iter().rev().skip(1) {
            work.launch(&level.add_sums, level.launch);
        }
        // end 9.6b
    }

    /// Writes down the launches that sort the particles: the tags, positions and velocities of the
    /// last step go to the sorted arrays, and `sort.starts` says where each bin begins.
    ///
    /// - `starts` is counted up from zero by the kernel `count`;
    /// - `scan` turns the counts into starts ([`record_scan`](Self::record_scan));
    /// - `scatter` gives each particle a slot in its bin, `order` copies it to its index.
    ///
    /// All three kernels run once for each particle: `sort.launch`.
    ///
    /// Book: chapter 9, *A counting sort*.
    fn record_sort(sort: &Sort, work: &mut Work<'_>) {
        // task 9.7d: the launches of a sort
        work.clear(&sort.starts);
        work.launch(&sort.count, sort.launch);
        Self::record_scan(&sort.scan, work);
        work.launch(&sort.scatter, sort.launch);
        work.launch(&sort.order, sort.launch);
        // end 9.7d
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
