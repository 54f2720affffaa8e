//! Task 5.2: particles that leave the block.

use std::ops::Range;

use common::soft::Particle;
use solution2::Grid;

/// Sorts the particles that changed their bin in this step into local and remote ones.
///
/// `changed` comes in with all of them. A particle that now lies in one of the rows `block` is
/// local and stays in `changed`: it has only gone to another bin of this rank. A particle in any
/// other row is remote: it is taken out of `changed` and added to `remote`. The order does not
/// matter. [`Grid::row`] tells in which row a y lies.
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
