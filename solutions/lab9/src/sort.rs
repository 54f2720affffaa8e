//! Tasks 9.6 and 9.7, on the host: the launches of a prefix sum and of a sort.

use device::Work;
use device_discs::soft::{Scan, SoftKernels, Sort};

use crate::Lab9;

impl SoftKernels for Lab9 {
    /// Adds the launches of a prefix sum to `work`.
    ///
    /// Each level in `scan.levels` has the kernels `scan_blocks` and `add_sums`. Launch both with
    /// the `launch` of their level, which has an invocation for each number.
    ///
    /// 1. On the way up, launch `scan_blocks` for every level, from level 0 to the last level. The
    ///    launch of a level also writes the sums of its blocks, which are the numbers of the next
    ///    level.
    /// 2. On the way down, launch `add_sums` for every level except the last, from the last but one
    ///    to level 0. The launch of a level adds the numbers of the next level to its blocks. The
    ///    last level is a single block, so it is already complete.
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

    /// Records the launches that sort the particles by bin.
    ///
    /// The sorted arrays receive copies of the tags, positions and velocities of the last step.
    /// `sort.starts` receives the index at which each bin begins.
    ///
    /// - The kernel `count` adds the number of particles in each bin to `starts`. At first,
    ///   `starts` contains the numbers of the previous sort: clear it.
    /// - `scan` turns the counts into starts ([`record_scan`](Self::record_scan)).
    /// - `scatter` writes the index of each particle in the unsorted arrays (not its id) to a slot
    ///   of its bin. The slots of a bin are in the order of arrival.
    /// - `order` copies each particle to the sorted arrays. There the particles of a bin are in the
    ///   order of their ids.
    ///
    /// Launch the kernels `count`, `scatter` and `order` with `sort.launch`, which has an
    /// invocation for each particle.
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
