//! Prefix sums of any length, from those of blocks, and a counting sort by them.

use device::{Bound, Launch};
use wgpu::Buffer;

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
