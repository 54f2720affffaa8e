//! The engine as programs that a driver lists and builds.

use common::soft::Simulation;
use common::{BuildError, Config, Parameter, Variant, bitwise, observed};
use solution1::Tally;
use solution2::bin_size;

use crate::blocks::Blocks;
use crate::engine::Halo;
use crate::messages::{Messages, Route};

/// The programs for a type that answers all that the library asks.
pub trait Programs: Blocks + Messages + Sized + 'static {
    /// All of them.
    const VARIANTS: &'static [Variant<dyn Simulation>] = &[
        bitwise(
            "halo",
            "ghosts to neighbours by non-blocking messages, inner rows computed meanwhile",
            PARAMETERS,
            |config| build::<Self>(&config.clone().with_threads(1), Route::Neighbours),
        ),
        bitwise("hybrid", "the same with threads (-t) in each rank", PARAMETERS, |config| {
            build::<Self>(config, Route::Neighbours)
        }),
        bitwise(
            "alltoallv",
            "ghosts and movers by one collective operation each, and nothing meanwhile",
            PARAMETERS,
            |config| build::<Self>(&config.clone().with_threads(1), Route::AllRanks),
        ),
    ];
}

impl<L: Blocks + Messages + 'static> Programs for L {}

const PARAMETERS: &[Parameter] = &[bin_size(1.0), REBALANCE, REMAINDER_LAST];

const REBALANCE: Parameter = Parameter {
    name: "rebalance",
    about: "steps between two looks at the balance; 0 never looks",
    default: 50.0,
    range: (0.0, 1e9),
};

const REMAINDER_LAST: Parameter = Parameter::switch(
    "remainder-last",
    "1: as many rows for each rank and the rest for the last one, for good; 0: by particles",
    false,
);

fn build<L: Blocks + Messages + 'static>(
    config: &Config,
    route: Route,
) -> Result<Box<dyn Simulation>, BuildError> {
    let world = common_mpi::world()?;
    Ok(observed!(config, Tally, |O| Halo::<O, L>::new(world, config, route)))
}
