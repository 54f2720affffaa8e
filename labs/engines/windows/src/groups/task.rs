//! The input of grouping.

use std::ops::Range;

use neighbour_list::kernels::Pair;

/// Particles and pairs that are to be grouped.
pub(crate) struct Task<'a> {
    /// The range of the particles' indices in the sorted order.
    pub(crate) range: Range<usize>,
    /// The pairs, as indices in the sorted order.
    pub(crate) pairs: &'a [Pair],
    /// Particles that are in a crowd even if they are in at most one pair, because they may reach a
    /// wall.
    pub(crate) alone: &'a [u32],
    /// Particles in pairs that are grouped elsewhere.
    pub(crate) elsewhere: &'a [u32],
}
