//! Prefix sums of any length, and a counting sort that uses them.

use device::{Bound, Launch};
use wgpu::Buffer;

/// A prefix sum on the device, which replaces the numbers in a buffer.
pub struct Scan {
    /// The levels of the prefix sum, from the buffer up to a single block.
    ///
    /// Level 0 is the buffer, level 1 the sums of its blocks, level 2 the sums of their blocks, and
    /// so on.
    pub levels: Vec<Level>,
}

/// Numbers that are summed in blocks.
pub struct Level {
    /// Sums each block, and writes its total to the next level.
    pub scan_blocks: Bound,
    /// Adds the sum that the next level contains for a block to each number of the block.
    pub add_sums: Bound,
    /// A launch with an invocation for each number.
    pub launch: Launch,
}

/// The kernels of a counting sort, bound to their buffers.
pub struct Sort {
    /// A u32 for each bin, and a final u32.
    ///
    /// Before the prefix sum, they count the particles of each bin. Afterwards they are the starts
    /// of the bins, followed by the number of particles.
    pub starts: Buffer,
    /// Counts the particles of each bin in `starts`.
    pub count: Bound,
    /// Computes the prefix sum of `starts`.
    pub scan: Scan,
    /// Gives each particle a slot in its bin.
    pub scatter: Bound,
    /// Copies each particle to its index in the sorted order.
    pub order: Bound,
    /// A launch with an invocation for each particle.
    pub launch: Launch,
}
