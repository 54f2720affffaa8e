//! Messages between a master and its workers.

use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

use crate::team::Team;

/// How lists travel from the master to the workers, and back. All ranks call each function together.
pub trait Messages: Sized + 'static {
    /// Sends each worker its list, and returns it there: `lists[k]` is for worker k. `lists` matters on the master
    /// only. A master that does not work gets an empty list.
    fn hand_out<W: Equivalence + Clone>(
        world: &SimpleCommunicator,
        team: Team,
        lists: &[Vec<W>],
    ) -> Vec<W>;

    /// Returns the lists of all workers at the master, one behind the other in the order of workers; elsewhere
    /// nothing.
    fn collect<W: Equivalence + Clone>(world: &SimpleCommunicator, team: Team, own: &[W])
    -> Vec<W>;
}
