//! A counting sort of particles into bins.

use device::{Bound, Launch};
use wgpu::Buffer;

use super::scan::Scan;

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
