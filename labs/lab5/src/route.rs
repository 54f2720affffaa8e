//! Task 5.5: the root sorts by receiver.

use common_mpi::Wire;
use solution2::Grid;

use crate::Cut;

/// The particles that one rank has sent to the root.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Parcel {
    /// The particles that left the rank's block. The rank no longer has them.
    pub leavers: Vec<Wire>,
    /// Copies of the particles in the rank's border rows. The rank still has the particles.
    pub copies: Vec<Wire>,
}

/// Sorts the parcels of all ranks into one list for each rank: the particles to send to this rank.
///
/// `parcels` are in the order of ranks. Each list of the result may be in any order. The rows of
/// `cut` are the rows of `grid`.
///
/// - A leaver goes to the rank that owns the row in which it is now ([`Cut::owner`]). This row may
///   be anywhere in the box. If it is a border row, the neighbouring ranks need the leaver as a
///   ghost ([`Cut::neighbours`]). Usually, the rank that the particle left is one of them.
/// - A copy goes only to the neighbouring ranks of its row. The owner of the row already has the
///   particle itself.
///
/// Book: chapter 5, *Sorting at the root*.
pub fn sort_by_receiver(grid: &Grid, cut: &Cut, parcels: &[Parcel]) -> Vec<Vec<Wire>> {
    let row_of = |wire: &Wire| grid.row(wire.y);
    let mut lists = vec![Vec::new(); cut.ranks];
    todo!("task 5.5: the root sorts by receiver");
    lists
}
