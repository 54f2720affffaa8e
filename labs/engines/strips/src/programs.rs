//! The engines as programs that a driver lists and builds.

use common::soft::Simulation;
use common::{BuildError, Config, Parameter, Variant, deterministic, observed};
use solution1::Tally;

use crate::deep::Deep;
use crate::deep_halo::DeepHalo;
use crate::distributed::Distributed;
use crate::sent_halo::Halo;

/// The programs for a type that answers all that the library asks.
pub trait Programs: Halo + DeepHalo + Sized + 'static {
    /// All of them.
    const VARIANTS: &'static [Variant<dyn Simulation>] = &[
        deterministic(
            "strips",
            "lab 10's engine on each rank, ghosts chosen once for each list",
            &[SKIN, REBALANCE],
            |config| build::<Self>(&config.clone().with_threads(1)),
        ),
        deterministic(
            "strips-threads",
            "the same with threads (-t) in each rank",
            &[SKIN, REBALANCE],
            build::<Self>,
        ),
        deterministic(
            "strips-deep",
            "ghosts several cutoffs deep, moved by the rank itself: no message for several steps",
            &[SKIN, REBALANCE],
            |config| build_deep::<Self>(&config.clone().with_threads(1)),
        ),
    ];
}

impl<L: Halo + DeepHalo + 'static> Programs for L {}

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

fn build<L: Halo + 'static>(config: &Config) -> Result<Box<dyn Simulation>, BuildError> {
    let world = common_mpi::world()?;
    Ok(observed!(config, Tally, |O| Distributed::<O, L>::new(world, config)))
}

/// Two ranks know a pair of ghosts, and each would count it. So with statistics, which are read after each
/// step anyway, `strips` runs instead.
fn build_deep<L: Halo + DeepHalo + 'static>(
    config: &Config,
) -> Result<Box<dyn Simulation>, BuildError> {
    if config.statistics {
        return build::<L>(config);
    }
    Ok(Box::new(Deep::<L>::new(common_mpi::world()?, config)))
}
