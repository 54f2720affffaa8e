//! Lab 10, fast: an engine on a neighbour list, with loops that vector registers like.
//!
//! Your engine is variant `serial-list`. It sorts particles by cell, so that neighbours in the box are
//! neighbours in memory, and lists all pairs that may touch until the next rebuild. How far the list looks
//! beyond the cutoff, its skin, decides how long it lasts and how many pairs it has. An inner list has
//! those that may touch within a few steps. From it each step computes the forces, and then all particles move.
//!
//! | task | file | what |
//! |------|------|------|
//! | 10.1 | `drift.rs` | a move that vector registers like |
//! | 10.2 | `collect.rs` | the neighbours of a particle, without a branch |
//! | 10.3 | `skin.rs` | when a neighbour list has expired, and how thick its skin should be |
//! | 10.4 | `filter.rs` | the listed pairs that are near, without a branch |
//! | 10.5 | `engine.rs` | a new list, and a new inner list |
//! | 10.6 | `engine.rs` | forces, and a step: then `serial-list` runs |
//!
//! What the loop in `engine.rs` calls is given, [`neighbour_list_core`]: particles as a structure of arrays
//! ([`Bodies`](neighbour_list_core::Bodies)), cells and sorting by cell ([`neighbour_list_core::cells`]), pairs,
//! positions and the forces of pairs that touch ([`neighbour_list_core::kernels`]).
//!
//! The library's engine, [`Verlet`], is variant `verlet`: that loop on several threads, with forces and move
//! block by block while a block is in the cache, and with particles too fast for a list. It calls your functions
//! of tasks 10.1 to 10.4 (`tasks.rs`); the chapter says what each part of it gains. In `alone.rs` your loops stand
//! alone, for a look at their machine code and for `cargo lab speed 10`.
//!
//! With `--statistics` an engine has [`Tally`], lab 1's observer, and without it [`NoStatistics`], which the
//! compiler removes.

mod alone;
mod collect;
mod drift;
mod engine;
mod filter;
mod skin;
mod tasks;

pub use alone::{ALONE, drift_alone, filter_alone};
pub use collect::collect;
pub use drift::drift;
pub use engine::{Engine, List};
pub use filter::filter;
pub use skin::{best_skin, expired};
pub use tasks::Tasks;

use common::soft::{NoStatistics, Simulation};
use common::{BuildError, Config, Parameter, Reproducibility, Variant};
use neighbour_list_core::{SHARE, Verlet, workers};
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

fn verlet(config: &Config) -> Result<Box<dyn Simulation>, BuildError> {
    let (skin, divide) = (config.parameter("skin"), config.parameter("divide") as u32);
    Ok(if config.statistics {
        Box::new(Verlet::<Tally, Tasks>::new(workers(config), skin, divide))
    } else {
        Box::new(Verlet::<NoStatistics, Tasks>::new(workers(config), skin, divide))
    })
}

const INNER: Parameter = Parameter {
    name: "inner",
    about: "1: with an inner list, 0: without",
    default: 1.0,
    range: (0.0, 1.0),
};

fn serial_list(config: &Config) -> Result<Box<dyn Simulation>, BuildError> {
    let (skin, inner) = (config.parameter("skin"), config.parameter("inner") > 0.0);
    Ok(if config.statistics {
        Box::new(Engine::<Tally>::new(skin, inner))
    } else {
        Box::new(Engine::<NoStatistics>::new(skin, inner))
    })
}

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    Variant {
        name: "serial-list",
        about: "the loop of this lab: sorted cells, a neighbour list and an inner one, one thread",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[SKIN, INNER],
        build: serial_list,
    },
    Variant {
        name: "verlet",
        about: "the library's engine: that loop with threads, and with particles too fast for a list",
        reproducibility: Reproducibility::Deterministic,
        parameters: &[SKIN, DIVIDE, SHARE],
        build: verlet,
    },
];
