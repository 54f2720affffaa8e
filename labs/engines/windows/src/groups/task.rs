//! The particles and pairs that are grouped together.

use std::ops::Range;

use neighbour_list::kernels::Pair;

/// Particles and pairs that are to be grouped.
pub(crate) struct Task<'a> {
    /// The indices that the particles may have in the sorted order.
    pub(crate) range: Range<usize>,
    /// The pairs.
    pub(crate) pairs: &'a [Pair],
    /// Particles that are in a crowd even if they are in no pair or in one.
    pub(crate) alone: &'a [u32],
    /// Particles in pairs that are grouped elsewhere.
    pub(crate) elsewhere: &'a [u32],
}
