//! Task 5.2: who changed its bin, within the block or out of it.

use std::ops::Range;

use common::soft::Particle;
use solution2::Grid;

/// Takes out of `changed`, the particles that changed their bin in this step, those that no longer
/// lie in the rows `block`, and adds them to `remote`. Those that stay in `changed` have only gone
/// to another bin of this rank. The order does not matter.
///
/// [`Grid::row`] says which row a particle lies in.
///
/// Mind both ends: row `block.start` belongs to the block, row `block.end` does not. A slip here
/// (the course report has one) does not always show in the results. It may instead send nearly
/// every particle through the root.
///
/// Book: chapter 5, *Local and remote*.
pub fn take_leavers_of_block(
    grid: &Grid,
    block: &Range<usize>,
    changed: &mut Vec<Particle>,
    remote: &mut Vec<Particle>,
) {
    // task 5.2: local or remote
    changed.retain(|particle| {
        let stays = block.contains(&grid.row(particle.y));
        if !stays {
            remote.push(*particle);
        }
        stays
    });
    // end 5.2
}
