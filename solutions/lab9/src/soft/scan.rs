//! Task 9.6: prefix sums of any length, from those of blocks.

use wgpu::Buffer;

use super::wgsl;
use crate::gpu::{Bound, Gpu, GpuError, Kernel, Launch, Work};

/// Replaces the numbers in a buffer by their prefix sum, on the device.
pub struct Scan {
    /// Level 0 is the buffer itself, level 1 the sums of its blocks, level 2 the sums of blocks
    /// of those, and so on until one block holds a whole level.
    levels: Vec<Level>,
}

struct Level {
    scan_blocks: Bound,
    add_sums: Bound,
    launch: Launch,
}

impl Scan {
    /// Prepares to sum the `len` numbers (u32) in `values`, by workgroups of `threads`.
    ///
    /// # Errors
    /// The device refuses a kernel, its launch or its memory.
    pub fn new(gpu: &Gpu, values: &Buffer, len: u32, threads: u32) -> Result<Self, GpuError> {
        let sources = [wgsl::scan()];
        let limits = gpu.limits();
        // Blocks of one number would never become fewer.
        let threads = threads.max(2);
        let scan_blocks = Kernel::new(gpu, "scan_blocks", &sources, threads, &[])?;
        let add_sums = Kernel::new(gpu, "add_sums", &sources, threads, &[])?;
        let mut levels = Vec::new();
        let (mut values, mut len) = (values.clone(), len);
        loop {
            let blocks = len.div_ceil(threads);
            let sums = gpu.storage("sums of blocks", u64::from(blocks) * 4)?;
            let buffers = [(0, &values), (1, &sums)];
            levels.push(Level {
                scan_blocks: scan_blocks.bind(gpu, &buffers),
                add_sums: add_sums.bind(gpu, &buffers),
                launch: Launch::over(len, threads, &limits)?,
            });
            if blocks <= 1 {
                return Ok(Self { levels });
            }
            (values, len) = (sums, blocks);
        }
    }

    /// Adds the launches to `work`.
    ///
    /// On the way up each level's blocks are summed, from level 0 to the last, so that each level
    /// finds the sums of the one below. On the way down the last level is done already; each level
    /// below it, from the last but one to level 0, adds the sums to its blocks.
    ///
    /// Book: chapter 9, *A prefix sum of any length*.
    pub fn record(&self, work: &mut Work<'_>) {
        // task 9.6b: a prefix sum of any length
        for level in &self.levels {
            work.launch(&level.scan_blocks, level.launch);
        }
        for level in self.levels.iter().rev().skip(1) {
            work.launch(&level.add_sums, level.launch);
        }
        // end 9.6b
    }
}
