//! Prefix sums of any length, from those of blocks, and a counting sort by them.

use device::{Bound, Gpu, GpuError, Kernel, Launch};
use wgpu::Buffer;

use super::kernels::SoftKernels;

/// Replaces the numbers in a buffer by their prefix sum, on the device.
pub struct Scan {
    /// Level 0 is the buffer itself, level 1 the sums of its blocks, level 2 the sums of blocks
    /// of those, and so on until one block holds a whole level.
    pub levels: Vec<Level>,
}

/// Numbers that are summed in blocks.
pub struct Level {
    /// Sums each block, and leaves the whole of it as a number of the next level.
    pub scan_blocks: Bound,
    /// Adds to each number what the next level holds for its block.
    pub add_sums: Bound,
    /// An invocation for each number.
    pub launch: Launch,
}

impl Scan {
    /// Prepares to sum the `len` numbers (u32) in `values`, by workgroups of `threads`, with the kernels `K`.
    ///
    /// # Errors
    /// The device refuses a kernel, its launch or its memory.
    pub fn new<K: SoftKernels>(
        gpu: &Gpu,
        values: &Buffer,
        len: u32,
        threads: u32,
    ) -> Result<Self, GpuError> {
        let sources = [K::scan()];
        let limits = gpu.limits();
        // Blocks of one number would never become fewer.
        let threads = threads.max(2);
        let kernel =
            |name| K::checked(gpu, name, || Kernel::new(gpu, name, &sources, threads, &[]));
        let (scan_blocks, add_sums) = (kernel("scan_blocks")?, kernel("add_sums")?);
        let mut levels = Vec::new();
        let (mut values, mut len) = (values.clone(), len);
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
            (values, len) = (sums, blocks);
        }
    }
}

/// The kernels of a counting sort, bound to their buffers.
pub struct Sort {
    /// First the number of particles in each bin, then where each begins: a u32 for each bin, and one more, which
    /// ends as the number of particles.
    pub starts: Buffer,
    /// Counts the particles of each bin in `starts`.
    pub count: Bound,
    /// The prefix sum of `starts`.
    pub scan: Scan,
    /// Gives each particle a slot in its bin.
    pub scatter: Bound,
    /// Copies each particle to its index among the sorted ones.
    pub order: Bound,
    /// An invocation for each particle.
    pub launch: Launch,
}
