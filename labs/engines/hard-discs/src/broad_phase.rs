//! The broad phase: before pairs are tested, it excludes pairs that cannot collide.

use std::ops::Range;

use crate::entry::Entry;
use crate::geometry::{Span, Square, Window};
use crate::survey::Survey;

/// The decisions of a broad phase: swept boxes, blocks, cells and windows.
pub trait BroadPhase {
    /// Returns the swept box along one axis: the coordinates that a disc can touch in `window`.
    ///
    /// The disc has centre `x` and velocity `v`; the box extends `reach` beyond the path of the
    /// centre.
    fn span(x: f64, v: f64, window: Window, reach: f64) -> Span;

    /// Returns the smallest block of the [`Grid`](crate::Grid) that contains a box.
    fn block_of(x: Span, y: Span, side: f64) -> usize;

    /// Calls `look` with the discs that the disc at `index` in block `block` may meet.
    ///
    /// If this function is called for all discs of all `blocks`, `look` sees every such pair once.
    fn look_around(blocks: &[Vec<u32>], block: usize, index: usize, look: impl FnMut(&[u32]));

    /// Returns the indices of the entries after entry `k` whose boxes share a column with the box
    /// of entry `k`.
    ///
    /// `entries` are sorted by cell.
    fn partners(entries: &[Entry], k: usize) -> Range<usize>;

    /// Returns the number of windows that makes a step cheapest.
    ///
    /// The number of pair tests is `crowding` times the [expected number](crate::expected_work).
    fn choose_windows(survey: &Survey, square: Square, crowding: f64) -> usize;
}
