//! Lab 13, the fast engine on ranks: the solution. The lab is described in `labs/lab13/README.md`.

mod agree;
mod balance;
mod confirm;
mod depth;
mod exchange;
mod ghosts;
mod partners;
mod width;

pub use agree::must_renew;
pub use balance::{MOVED, load, weigh_rows};
pub use confirm::{confirm, right_steps};
pub use depth::{STEP, WAIT, best_depth, deep_width};
pub use exchange::exchange_positions;
pub use ghosts::{choose, pairs_across};
pub use partners::partners;
pub use width::{ACROSS, GHOST, RENEWAL, best_steps, ghost_width};

use std::ops::Range;

use common::soft::Simulation;
use common::{Variant, deterministic};
use mpi::Rank;
use mpi::topology::SimpleCommunicator;
use neighbour_list::kernels::{Pair, Positions};
use strips::programs::{PARAMETERS, deep, distributed};
use strips::{DeepHalo, Halo, Outlook, Partition, Scenery, Strips};

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    deterministic(
        "strips",
        "lab 10's engine on each rank, ghosts chosen once for each list",
        PARAMETERS,
        |config| distributed::<Lab13>(config, 1),
    ),
    deterministic(
        "strips-threads",
        "the same with threads (-t) in each rank",
        PARAMETERS,
        |config| distributed::<Lab13>(config, config.threads),
    ),
    deterministic(
        "strips-deep",
        "ghosts several cutoffs deep, moved by the rank itself: no message for several steps",
        PARAMETERS,
        deep::<Lab13>,
    ),
];

/// The functions of the tasks, under the names that the library calls.
pub struct Lab13;

impl Partition for Lab13 {
    fn partners(strips: &Strips, rank: usize, width: f64) -> Vec<Rank> {
        partners(strips, rank, width)
    }

    fn load(particles: usize, pairs: usize) -> u64 {
        load(particles, pairs)
    }

    fn weigh_rows(counts: &[u64], load: u64) -> Vec<u64> {
        weigh_rows(counts, load)
    }
}

impl Halo for Lab13 {
    fn ghost_width(fastest: f64, steps: u32) -> f64 {
        ghost_width(fastest, steps)
    }

    fn best_steps(scenery: Scenery) -> u32 {
        best_steps(scenery)
    }

    fn choose(y: &[f64], strip: &Range<f64>, width: f64) -> Vec<u32> {
        choose(y, strip, width)
    }

    fn pairs_across(own: Positions<'_>, ghosts: Positions<'_>, reach: f64) -> Vec<Pair> {
        pairs_across(own, ghosts, reach)
    }

    fn exchange_positions(
        world: &SimpleCommunicator,
        partners: &[Rank],
        sent: &[Vec<f64>],
        received: &mut [Vec<f64>],
        meanwhile: impl FnOnce(),
    ) {
        exchange_positions(world, partners, sent, received, meanwhile);
    }

    fn must_renew(
        world: &SimpleCommunicator,
        list_has_expired: bool,
        moved: f64,
        width: f64,
    ) -> bool {
        must_renew(world, list_has_expired, moved, width)
    }
}

impl DeepHalo for Lab13 {
    fn deep_width(fastest: f64, steps: u32) -> f64 {
        deep_width(fastest, steps)
    }

    fn best_depth(outlook: Outlook) -> u32 {
        best_depth(outlook)
    }

    fn confirm(world: &SimpleCommunicator, numbers: &mut [f64], steps: usize, width: f64) -> usize {
        confirm(world, numbers, steps, width)
    }
}
