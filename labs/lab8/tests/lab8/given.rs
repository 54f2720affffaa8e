//! Deals, scenes and messages for tests and probes.

use std::thread::sleep;
use std::time::Duration;

use common::hard::{Disc, Scene};
use hard_disc_ranks::{DiscWire, Team};
use lab8::collect;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;

/// Numbers of workers, and offsets for task 8.2 that do not come from task 8.1.
pub(super) const OFFSETS: [(usize, &[usize]); 10] = [
    (1, &[0]),
    (2, &[0, 1]),
    (3, &[0, 1]),
    (4, &[0, 1, 2]),
    (5, &[0, 1, 3]),
    (6, &[0, 1, 3]),
    (7, &[0, 1, 3]),
    (8, &[0, 1, 3, 4]),
    (13, &[0, 1, 3, 9]),
    (16, &[0, 1, 3, 7, 8]),
];

/// A tower: each disc flies into the one above, across every cut; the lowest by 44 / `slow`.
pub(super) fn tower(slow: f64) -> Scene {
    let disc = |k: u32| Disc::new(50.0, 2.2 * f64::from(k) + 1.0, 0.0, f64::from(44 - k) / slow);
    Scene::new(100.0, 1.0, (0..45).map(disc).collect()).expect("all are inside")
}

/// What [`collect`] returns if the highest rank's list comes first, and each other one when the master
/// has had time to take it: a master that takes what arrives first gets another order.
pub(super) fn collected_from_above(
    world: &SimpleCommunicator,
    team: Team,
    own: &[DiscWire],
) -> Vec<DiscWire> {
    let (rank, ranks) = (world.rank(), world.size());
    if (1..ranks - 1).contains(&rank) {
        let _: (u8, _) = world.process_at_rank(rank + 1).receive_with_tag(85);
        sleep(Duration::from_millis(50));
    }
    let found = collect(world, team, own);
    if rank > 1 {
        world.process_at_rank(rank - 1).send_with_tag(&1_u8, 85);
    }
    found
}
