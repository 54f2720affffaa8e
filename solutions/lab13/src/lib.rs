//! Lab 13, all of it: lab 10's engine on ranks and threads.
//!
//! Lab 10 is fast and has one machine. Lab 6 has many, and takes three to four times as long on each. Here each
//! rank runs lab 10's engine on a strip of the box, and a rank treats the ghosts of its
//! neighbours as lab 10 treats a list: they are chosen rarely, with a margin, and used until they expire.
//! When lists are rebuilt, particles change their ranks, and each rank chooses the particles that
//! its neighbours need, the ghosts. In the steps between only the positions of ghosts are sent; or, in
//! `strips-deep`, nothing: a rank moves ghosts itself, and all ranks roll back if that was wrong.
//!
//! | task | file | what |
//! |------|------|------|
//! | 13.1 | `width.rs` | how wide ghosts must be, and for how many steps |
//! | 13.2 | `partners.rs` | which ranks need ghosts of each other |
//! | 13.3 | `ghosts.rs` | the ghosts that a rank needs, and the pairs across the border |
//! | 13.4 | `exchange.rs` | places under way while inner particles move |
//! | 13.5 | `balance.rs` | strips of equal work |
//! | 13.6 | `agree.rs` | all ranks agree that lists have expired; then whole steps run |
//! | 13.7 | `depth.rs` | ghosts so deep that a rank moves them itself for several steps |
//! | 13.8 | `confirm.rs` | whether these steps were right; then `strips-deep` runs |
//!
//! The rest is a library, `strips`: the engines of a rank, its border, and how lists are renewed. It calls the functions
//! of this lab by the traits that [`Lab13`] implements below. The engine on a strip is lab 10's
//! ([`neighbour_list::Verlet`]); scenes, rows and movers come from labs 5 and 6.

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
pub use exchange::exchange_places;
pub use ghosts::{choose, pairs_across};
pub use partners::partners;
pub use width::{ACROSS, GHOST, RENEWAL, best_steps, ghost_width};

use std::ops::Range;

use common::soft::{NoStatistics, Simulation};
use common::{BuildError, Config, Parameter, Reproducibility, Variant};
use mpi::Rank;
use mpi::topology::SimpleCommunicator;
use neighbour_list::kernels::{Pair, Positions};
use solution1::Tally;
use strips::{Deep, DeepHalo, Distributed, Halo, Outlook, Partition, Scenery, Strips};

const SKIN: Parameter = Parameter {
    name: "skin",
    about: "how far beyond the cutoff a rank's list looks, in cutoffs; 0: the cheapest",
    default: 0.0,
    range: (0.0, 10.0),
};
const REBALANCE: Parameter = Parameter {
    name: "rebalance",
    about: "lists between two looks at the balance; 0 never looks",
    default: 5.0,
    range: (0.0, 1e9),
};

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    Variant {
        name: "strips",
        about: "lab 10's engine on each rank, ghosts chosen once for each list",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[SKIN, REBALANCE],
        build: |config| build(&config.clone().with_threads(1)),
    },
    Variant {
        name: "strips-threads",
        about: "the same with threads (-t) in each rank",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[SKIN, REBALANCE],
        build,
    },
    Variant {
        name: "strips-deep",
        about: "ghosts several cutoffs deep, moved by the rank itself: no message for several steps",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[SKIN, REBALANCE],
        build: |config| build_deep(&config.clone().with_threads(1)),
    },
];

fn build(config: &Config) -> Result<Box<dyn Simulation>, BuildError> {
    let world = common_mpi::world()?;
    Ok(if config.statistics {
        Box::new(Distributed::<Tally, Lab13>::new(world, config))
    } else {
        Box::new(Distributed::<NoStatistics, Lab13>::new(world, config))
    })
}

/// Two ranks know a pair of ghosts, and each would count it. So with statistics, which are read after each
/// step anyway, `strips` runs instead.
fn build_deep(config: &Config) -> Result<Box<dyn Simulation>, BuildError> {
    if config.statistics {
        return build(config);
    }
    Ok(Box::new(Deep::<Lab13>::new(common_mpi::world()?, config)))
}

/// What the library asks for, answered by the functions of the tasks.
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

    fn exchange_places(
        world: &SimpleCommunicator,
        partners: &[Rank],
        sent: &[Vec<f64>],
        received: &mut [Vec<f64>],
        meanwhile: impl FnOnce(),
    ) {
        exchange_places(world, partners, sent, received, meanwhile);
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

    fn confirm(world: &SimpleCommunicator, said: &mut [f64], steps: usize, width: f64) -> usize {
        confirm(world, said, steps, width)
    }
}
