//! Task 7.12: the blocks of the report's grid of three levels.
//!
//! There are 21 blocks:
//!
//! - 4 × 4 small blocks, with numbers 0 to 15;
//! - 2 × 2 medium blocks, with numbers 16 to 19;
//! - the whole square, with number 20.

use hard_discs::Span;

/// Returns the number of the smallest block that a swept box fits into.
///
/// `x` and `y` are the spans of the box, in a square of side `side`.
///
/// - A small block has the number 4 · row + column. A medium block has the number
///   16 + 2 · row + column. Row 0 is the lowest row.
/// - A vertical edge at coordinate c is in column ⌊4 · c / side⌋ of the small blocks, and a
///   horizontal edge at c is in row ⌊4 · c / side⌋. An edge exactly between two columns is
///   therefore in the column to its right.
/// - An edge beyond the square is in the outermost row or column.
///
/// Book: chapter 7, *The grid of three levels*.
pub fn block_of(x: Span, y: Span, side: f64) -> usize {
    todo!("task 7.12: the block of a box")
}

/// Returns the blocks of coarser levels that contain block number `block`.
///
/// A small block is in one medium block and in the whole square.
///
/// Book: chapter 7, *The grid of three levels*.
pub fn blocks_around(block: usize) -> Vec<usize> {
    todo!("task 7.12b: the blocks around a block")
}

/// Calls `look` with lists of the discs that one disc may meet, one list at a time.
///
/// - `blocks[b]` contains the numbers of the discs in block b. The disc is at `index` in block
///   `block`.
/// - Two discs may meet if they are in the same block. They may also meet if the block of one is
///   [around](blocks_around) the block of the other.
/// - This is called for every disc of every block. Of the two calls for a pair of discs that may
///   meet, exactly one must list the pair. No disc meets itself.
///
/// Book: chapter 7, *The grid of three levels*.
pub fn look_around(blocks: &[Vec<u32>], block: usize, index: usize, mut look: impl FnMut(&[u32])) {
    todo!("task 7.12c: the discs that a disc may meet")
}
