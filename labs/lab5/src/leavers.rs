//! Task 5.2: particles that leave the block.

use std::ops::Range;

use common::soft::Particle;
use solution2::Grid;

/// Separates the particles that changed their bin in this step into local and remote ones.
///
/// - At first, `changed` contains all these particles.
/// - A particle that is now in one of the rows `block` is local: it has only changed its bin within
///   this rank. Leave it in `changed`.
/// - A particle in any other row is remote. Take it out of `changed`, and add it to `remote`.
/// - The order does not matter. [`Grid::row`] returns the row that contains a y.
///
/// Check both ends: row `block.start` belongs to the block, row `block.end` does not. A mistake
/// here (the course report contains one) may leave the results unchanged, but send nearly every
/// particle through the root.
///
/// Book: chapter 5, *Local and remote*.
pub fn take_leavers_of_block(
    grid: &Grid,
    block: &Range<usize>,
    changed: &mut Vec<Particle>,
    remote: &mut Vec<Particle>,
) {
    todo!("task 5.2: local or remote")
}
