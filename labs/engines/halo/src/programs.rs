//! The engine as programs that a driver lists and builds.

use common::soft::{NoStatistics, Observer, Simulation};
use common::{BuildError, Config, Parameter, Reproducibility, Variant};
use solution1::Tally;
use solution2::bin_size;

use crate::blocks::Blocks;
use crate::engine::Halo;
use crate::messages::{Messages, Route};

/// The programs for a type that answers all that the library asks.
pub trait Programs: Blocks + Messages + Sized + 'static {
    /// All of them.
    const VARIANTS: &'static [Variant<dyn Simulation>] = &[
        Variant {
            name: "halo",
            about: "ghosts to neighbours by non-blocking messages, inner rows computed meanwhile",
            reproducibility: Reproducibility::Bitwise,
            parameters: PARAMETERS,
            build: |config| build::<Self>(&config.clone().with_threads(1), Route::Neighbours),
        },
        Variant {
            name: "hybrid",
            about: "the same with threads (-t) in each rank",
            reproducibility: Reproducibility::Bitwise,
            parameters: PARAMETERS,
            build: |config| build::<Self>(config, Route::Neighbours),
        },
        Variant {
            name: "alltoallv",
            about: "ghosts and movers by one collective operation each, and nothing meanwhile",
            reproducibility: Reproducibility::Bitwise,
            parameters: PARAMETERS,
            build: |config| build::<Self>(&config.clone().with_threads(1), Route::AllRanks),
        },
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

const REMAINDER_LAST: Parameter = Parameter {
    name: "remainder-last",
    about: "1: as many rows for each rank and the rest for the last one, for good; 0: by particles",
    default: 0.0,
    range: (0.0, 1.0),
};

fn build<L: Blocks + Messages + 'static>(
    config: &Config,
    route: Route,
) -> Result<Box<dyn Simulation>, BuildError> {
    fn engine<O: Observer, L: Blocks + Messages + 'static>(
        s: &Config,
        route: Route,
    ) -> Result<Box<dyn Simulation>, BuildError> {
        Ok(Box::new(Halo::<O, L>::new(common_mpi::world()?, s, route)))
    }
    if config.statistics {
        engine::<Tally, L>(config, route)
    } else {
        engine::<NoStatistics, L>(config, route)
    }
}
