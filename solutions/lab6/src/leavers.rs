//! Task 6.6: movers to the neighbours, and movers that go further.

use common_mpi::Wire;
use halo::{Cuts, Leavers};
use solution2::Grid;

/// Sorts `leavers`, particles that no longer lie in the block of this rank, by their new owners, in
/// each list in the order in which they come. `neighbours` are those of this rank, before and
/// after, where there are any ([`neighbours`](crate::neighbours)).
///
/// In an ordinary step a particle moves a twentieth of a cutoff, and all leavers go to a neighbour.
/// But nothing in the model forbids a particle to fly across many blocks in one step.
///
/// Book: chapter 6, *Movers*.
pub fn sort_leavers(
    grid: &Grid,
    cuts: &Cuts,
    neighbours: [Option<usize>; 2],
    leavers: &[Wire],
) -> Leavers {
    let mut sorted = Leavers::default();
    // task 6.6: movers to the neighbours, and further
    for leaver in leavers {
        let owner = cuts.owner(grid.row(leaver.y));
        match neighbours.iter().position(|neighbour| *neighbour == Some(owner)) {
            Some(side) => sorted.near[side].push(*leaver),
            None => sorted.far.push((owner, *leaver)),
        }
    }
    // end 6.6
    sorted
}
