//! The engine as a program that a driver lists and builds.

use common::soft::Simulation;
use common::{BuildError, Config, Parameter, Variant, deterministic, observed};
use solution1::Tally;

use crate::engine::NeighbourList;
use crate::kernels::Primitives;
use crate::threads::{SHARE, workers};

/// How many steps an official one is divided into.
pub const DIVIDE: Parameter = Parameter {
    name: "divide",
    about: "steps that an official step of 0.0005 is divided into",
    default: 1.0,
    range: (1.0, 1000.0),
};

/// How far a list looks.
pub const SKIN: Parameter = Parameter {
    name: "skin",
    about: "how far beyond the cutoff the list looks, in cutoffs; 0: the cheapest",
    default: 0.0,
    range: (0.0, 10.0),
};

/// The program for a type that has the primitives.
pub trait Programs: Primitives {
    /// It takes as many threads as it is given.
    const NEIGHBOUR_LIST: Variant<dyn Simulation> = deterministic(
        "neighbour-list",
        "the library's engine: that loop with threads, and with particles too fast for a list",
        &[SKIN, DIVIDE, SHARE],
        neighbour_list::<Self>,
    );
}

impl<P: Primitives> Programs for P {}

fn neighbour_list<P: Primitives>(config: &Config) -> Result<Box<dyn Simulation>, BuildError> {
    let (skin, divide) = (config.parameter("skin"), config.parameter("divide") as u32);
    Ok(observed!(config, Tally, |O| NeighbourList::<O, P>::new(workers(config), skin, divide)))
}
