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
//! | 13.2 | `strips.rs` | which ranks need ghosts of each other |
//! | 13.3 | `ghosts.rs` | the ghosts that a rank needs, and the pairs across the border |
//! | 13.4 | `exchange.rs` | places under way while inner particles move |
//! | 13.5 | `balance.rs` | strips of equal work |
//! | 13.6 | `agree.rs` | all ranks agree that lists have expired; then whole steps run |
//! | 13.7 | `depth.rs` | ghosts so deep that a rank moves them itself for several steps |
//! | 13.8 | `confirm.rs` | whether these steps were right; then `strips-deep` runs |
//!
//! Everything else is given and need not be read for the tasks:
//!
//! | folder | what |
//! |------|------|
//! | `engine` | the steps of a rank, its border, and how lists are renewed |
//!
//! The engine itself is lab 10's ([`neighbour_list::Verlet`]); scenes, rows and movers come from labs 5
//! and 6.

mod agree;
mod balance;
mod confirm;
mod depth;
mod engine;
mod exchange;
mod ghosts;
mod strips;
mod width;

pub use agree::must_renew;
pub use balance::{MOVED, load, weigh_rows};
pub use confirm::{confirm, right_steps};
pub use depth::{Outlook, STEP, WAIT, best_depth, deep_width};
pub use engine::{Deep, Distributed};
pub use exchange::exchange_places;
pub use ghosts::{choose, pairs_across};
pub use strips::Strips;
pub use width::{ACROSS, GHOST, RENEWAL, Scenery, best_steps, ghost_width};

use common::soft::{NoStatistics, Simulation};
use common::{BuildError, Config, Parameter, Reproducibility, Variant};
use solution1::Tally;

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
        Box::new(Distributed::<Tally>::new(world, config))
    } else {
        Box::new(Distributed::<NoStatistics>::new(world, config))
    })
}

/// Two ranks know a pair of ghosts, and each would count it. So with statistics, which are read after each
/// step anyway, `strips` runs instead.
fn build_deep(config: &Config) -> Result<Box<dyn Simulation>, BuildError> {
    if config.statistics {
        return build(config);
    }
    Ok(Box::new(Deep::new(common_mpi::world()?, config)))
}
