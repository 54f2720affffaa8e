//! The levels of a prefix sum, from the numbers up to a level of a single block.

use device::{Gpu, GpuError};
use wgpu::Buffer;

use super::kernels::SoftKernels;
use super::scan::{Level, Scan};

impl Scan {
    /// Prepares the prefix sum of the `len` numbers (u32) in `values`. Workgroups of `threads` run
    /// the kernels `K`.
    ///
    /// # Errors
    /// The device refuses a kernel, its launch or its memory.
    pub fn new<K: SoftKernels>(
        gpu: &Gpu,
        values: &Buffer,
        len: u32,
        threads: u32,
    ) -> Result<Self, GpuError> {
        let sources = [K::scan(), include_str!("shared.wgsl")];
        let limits = gpu.limits();
        // With blocks of one number, the next level would have as many numbers as this one.
        let threads = threads.max(2);
        let scan_blocks = K::compiled(gpu, "scan_blocks", &sources, threads, &[])?;
        let add_sums = K::compiled(gpu, "add_sums", &sources, threads, &[])?;
        let mut levels = Vec::new();
        let mut values = values.clone();
        let mut len = len;
        loop {
            let blocks = len.div_ceil(threads);
            let sums = gpu.storage("sums of blocks", u64::from(blocks) * 4)?;
            let buffers = [(0, &values), (1, &sums)];
            levels.push(Level {
                scan_blocks: scan_blocks.bind(gpu, &buffers),
                add_sums: add_sums.bind(gpu, &buffers),
                launch: K::launch_over(len, threads, &limits)?,
            });
            if blocks <= 1 {
                return Ok(Self { levels });
            }
            values = sums;
            len = blocks;
        }
    }
}
