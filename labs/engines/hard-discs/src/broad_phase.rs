//! The broad phase: which pairs need not be looked at.

use std::ops::Range;

use crate::entry::Entry;
use crate::geometry::{Span, Square, Window};
use crate::survey::Survey;

/// Swept boxes, and what a search does with them.
pub trait BroadPhase {
    /// The swept box along one axis: what a disc with centre `x` and velocity `v` can touch in `window`, and
    /// `reach` beyond the path of its centre.
    fn span(x: f64, v: f64, window: Window, reach: f64) -> Span;

    /// The smallest block of the [`Grid`](crate::Grid) that a box fits into.
    fn block_of(x: Span, y: Span, side: f64) -> usize;

    /// Calls `look` with the discs that the disc at `index` in block `block` may meet: over all discs of all `blocks`
    /// every such pair once.
    fn look_around(blocks: &[Vec<u32>], block: usize, index: usize, look: impl FnMut(&[u32]));

    /// The indices of the entries behind entry `k` whose boxes share a column with its box. `entries` are sorted by
    /// cell.
    fn partners(entries: &[Entry], k: usize) -> Range<usize>;

    /// The number of windows that makes a step cheapest, if there are `crowding` times as many pairs to look at as
    /// [expected](crate::expected_work).
    fn choose_windows(survey: &Survey, square: Square, crowding: f64) -> usize;
}
