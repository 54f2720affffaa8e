//! Lab 10, fast: an engine that sorts, lists and moves particles without branches.
//!
//! Particles are sorted by cell, so that neighbours in the box are neighbours in memory. A list
//! holds all pairs that could touch until the next rebuild: how far it looks beyond the cutoff, its
//! skin, decides how long it lasts and how long it is. One pass over the list computes the forces
//! and moves the particles, block by block, while a block is in the cache.
//!
//! | task | file | what |
//! |------|------|------|
//! | 10.1 | `drift.rs` | a move that vector registers like |
//! | 10.2 | `collect.rs` | the neighbours of a particle, without a branch |
//! | 10.3 | `skin.rs` | when a neighbour list is worn out |
//! | 10.4 | `skin.rs` | how thick its skin should be |
//! | 10.5 | `filter.rs` | the listed pairs that are near, without a branch |
//!
//! Everything else is given and need not be read for the tasks:
//!
//! | room | what |
//! |------|------|
//! | `kernels` | arithmetic, comparisons and lists that vector registers can do |
//! | `particles` | particles as a structure of arrays |
//! | `cells` | the grid, and sorting by cell |
//! | `threads` | work cut into pieces by the scene, never by the number of threads |
//! | `list` | the neighbour list, its short list, and particles too fast for it |
//! | `verlet` | the engine: forces and move in one pass, and what crosses the ends of blocks |
//!
//! Labs 11, 12 and 13 build on these rooms.

pub mod cells;
mod collect;
mod drift;
mod filter;
pub mod kernels;
pub mod list;
pub mod particles;
mod skin;
pub mod threads;
pub mod verlet;

pub use cells::{Cells, Extent, Grid, Kind, Sorter};
pub use collect::collect;
pub use drift::drift;
pub use filter::filter;
pub use kernels::{AnyProcessor, EIGHT, Signs, pack};
pub use list::{Block, Disc, Pairs, overlapping};
pub use particles::{Bodies, Eight};
pub use skin::{LISTED, REBUILD, TESTED, best_skin, worn_out};
pub use threads::Workers;
pub use verlet::{Contacts, Pushes, Verlet};

use common::soft::{NoStatistics, Simulation};
use common::{BuildError, Config, Parameter, Reproducibility, Variant};
use solution1::Tally;

const DIVIDE: Parameter = Parameter {
    name: "divide",
    about: "steps that an official step of 0.0005 is divided into",
    default: 1.0,
    range: (1.0, 1000.0),
};
const SKIN: Parameter = Parameter {
    name: "skin",
    about: "how far beyond the cutoff the list looks, in cutoffs; 0: the cheapest",
    default: 0.0,
    range: (0.0, 10.0),
};

/// The fewest particles of a thread.
pub const SHARE: Parameter = Parameter {
    name: "share",
    about: "particles that each thread has at least; threads that would have fewer are left out",
    default: threads::LEAST as f64,
    range: (1.0, 1e9),
};

/// The threads of a run with the parameter [`SHARE`].
pub fn workers(config: &Config) -> Workers {
    Workers::sharing(config.threads, config.parameter(SHARE.name) as usize)
}

fn verlet(config: &Config) -> Result<Box<dyn Simulation>, BuildError> {
    let (skin, divide) = (config.parameter("skin"), config.parameter("divide") as u32);
    Ok(if config.statistics {
        Box::new(Verlet::<Tally>::new(workers(config), skin, divide))
    } else {
        Box::new(Verlet::<NoStatistics>::new(workers(config), skin, divide))
    })
}

/// The program of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[Variant {
    name: "verlet",
    about: "sorted cells, a neighbour list with a skin, a move without branches",
    reproducibility: Reproducibility::Deterministic,
    parameters: &[SKIN, DIVIDE, SHARE],
    build: verlet,
}];
