//! Task 6.6: who moves next door, and who further.

use common_mpi::Wire;
use solution2::Grid;

use crate::Cuts;

/// Particles that left their block, by where they must go.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Leavers {
    /// To the neighbour before and to the neighbour after.
    pub near: [Vec<Wire>; 2],
    /// To any other rank, with its number.
    pub far: Vec<(usize, Wire)>,
}

/// Sorts `leavers`, particles that no longer lie in the block of this rank, by their new
/// owners. `neighbours` are those of this rank: before and after, if there are any.
///
/// In an ordinary step a particle moves a twentieth of a cutoff, and all leavers go next door. But
/// nothing in the model forbids that a particle flies across many blocks in one step, or lands in
/// the block of a rank that is nobody's neighbour because ours is empty.
///
/// Book: chapter 6, *Movers*.
pub fn sort_leavers(
    grid: &Grid,
    cuts: &Cuts,
    neighbours: [Option<usize>; 2],
    leavers: &[Wire],
) -> Leavers {
    let mut sorted = Leavers::default();
    todo!("task 6.6: who moves next door, and who further");
    sorted
}
