//! Task 5.5: the root sorts by receiver.

use common_mpi::Wire;
use solution2::Grid;

use crate::Cut;

/// What one rank sent to the root.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Parcel {
    /// Particles that left its block. It no longer has them.
    pub leavers: Vec<Wire>,
    /// Copies of the particles in its border rows. It still has them.
    pub copies: Vec<Wire>,
}

/// Sorts the parcels of all ranks, in the order of ranks, into a list for each rank: what that rank
/// shall get, in any order.
///
/// - A leaver goes to the rank that owns the row it lies in now ([`Cut::owner`]), anywhere in the
///   box. If that is a border row, the row's neighbours need it as a ghost as well
///   ([`Cut::neighbours`]). The rank that it left is most often one of them.
/// - A copy goes to the row's neighbours only: its owner has the particle itself.
///
/// The rows of `cut` are those of `grid`.
///
/// Book: chapter 5, *Sorting at the root*.
pub fn sort_by_receiver(grid: &Grid, cut: &Cut, parcels: &[Parcel]) -> Vec<Vec<Wire>> {
    let row_of = |wire: &Wire| grid.row(wire.y);
    let mut lists = vec![Vec::new(); cut.ranks];
    todo!("task 5.5: the root sorts by receiver");
    lists
}
