//! Prefix sums of any length, from those of blocks.

use wgpu::Buffer;

use crate::gpu::{Bound, Gpu, GpuError, Kernel};
use crate::{Launch, kernels};

/// Replaces the numbers in a buffer by their prefix sum, on the device.
pub struct Scan {
    /// Level 0 is the buffer itself, level 1 the sums of its blocks, level 2 the sums of blocks
    /// of those, and so on until one block holds a whole level.
    pub(crate) levels: Vec<Level>,
}

pub(crate) struct Level {
    pub(crate) scan_blocks: Bound,
    pub(crate) add_sums: Bound,
    pub(crate) launch: Launch,
}

impl Scan {
    /// Prepares to sum the `len` numbers (u32) in `values`, by workgroups of `threads`.
    ///
    /// # Errors
    /// The device refuses a kernel, its launch or its memory.
    pub fn new(gpu: &Gpu, values: &Buffer, len: u32, threads: u32) -> Result<Self, GpuError> {
        let sources = [kernels::scan()];
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
}
