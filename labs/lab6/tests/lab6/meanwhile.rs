//! Two ranks, of which one makes its messages by hand.

use std::time::{Duration, Instant};

use common_mpi::{Ghost, together};
use lab6::exchange_beside;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

const AT_WORK: i32 = 63;

/// More items than the library keeps aside for a rank that has not asked for them.
const MANY: usize = 200_000;

/// Whether rank 0 works while its messages travel, and waits for none of its sends before: rank 1 sends its
/// items, and receives those of rank 0, when it hears that rank 0 works, or at last without that.
pub(super) fn works_meanwhile(world: &SimpleCommunicator) -> bool {
    let other = world.process_at_rank(1 - world.rank());
    let items = vec![Ghost { x: 1.0, y: 2.0, id: 3 }; MANY];
    if world.rank() == 0 {
        let outgoing = [(1, items.clone())];
        let work = || other.send_with_tag(&1_u8, AT_WORK);
        let (incoming, ()) =
            together("exchange_beside", || exchange_beside(world, &outgoing, work));
        assert!(incoming == [items], "the items of rank 1 arrived otherwise");
        return true;
    }
    other.send(&(items.len() as u64));
    let (_, _): (u64, _) = other.receive();
    let start = Instant::now();
    let mut heard = false;
    while !heard && start.elapsed() < Duration::from_secs(5) {
        heard = other.immediate_probe_with_tag(AT_WORK).is_some();
    }
    other.send(&items[..]);
    let (_, _): (Vec<Ghost>, _) = other.receive_vec();
    let (_, _): (u8, _) = other.receive_with_tag(AT_WORK);
    heard
}
