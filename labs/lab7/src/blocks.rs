//! Task 7.12: the blocks of the report's grid of three levels.
//!
//! There are 21: 4 × 4 small ones, numbers 0 to 15; 2 × 2 medium ones, 16 to 19; the whole square, 20.

use hard_discs::Span;

/// The smallest block of a square of side `side` that a swept box fits into.
///
/// Small blocks are numbered 4 row + column, medium ones 16 + 2 row + column, rows from below.
/// The edge at x lies in column ⌊4 x / side⌋ of the small blocks: exactly between two columns in the right one.
/// What lies beyond the square counts to the outermost blocks.
///
/// Book: chapter 7, *The grid of three levels*.
pub fn block_of(x: Span, y: Span, side: f64) -> usize {
    todo!("task 7.12: the block of a box")
}

/// The blocks of coarser levels that overlap block number `block`, which are those around it: a
/// small block lies in a medium one and in the whole square.
///
/// Book: chapter 7, *The grid of three levels*.
pub fn blocks_around(block: usize) -> Vec<usize> {
    todo!("task 7.12b: the blocks around a block")
}

/// The search of one disc: calls `look` with discs that it may meet, a list at a time.
///
/// `blocks[b]` are the numbers of the discs in block b, and the disc is the one at `index` in block `block`. Two discs
/// may meet if they are in the same block, or if the block of one is among the [blocks around](blocks_around) that of
/// the other. This is called for every disc of every block: each such pair must come up in the call of one of the two
/// and not of both, and no disc meets itself.
///
/// Book: chapter 7, *The grid of three levels*.
pub fn look_around(blocks: &[Vec<u32>], block: usize, index: usize, mut look: impl FnMut(&[u32])) {
    todo!("task 7.12c: the discs that a disc may meet")
}
