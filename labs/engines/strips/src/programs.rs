//! Builds the engines as programs from their parameters.

use common::soft::Simulation;
use common::{BuildError, Config, Parameter, observed};
use solution1::Tally;

use crate::deep::Deep;
use crate::deep_halo::DeepHalo;
use crate::distributed::Distributed;
use crate::sent_halo::Halo;

/// The parameters of both engines.
pub const PARAMETERS: &[Parameter] = &[SKIN, REBALANCE];

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

type Built = Result<Box<dyn Simulation>, BuildError>;

/// Builds the engine [`Distributed`] of this rank, with `threads` threads.
///
/// # Errors
/// There is no MPI library.
pub fn distributed<L: Halo + 'static>(config: &Config, threads: usize) -> Built {
    let world = common_mpi::world()?;
    let config = config.clone().with_threads(threads);
    Ok(observed!(config, Tally, |O| Distributed::<O, L>::new(world, &config)))
}

/// Builds the engine [`Deep`] of this rank, with one thread.
///
/// A pair of ghosts can be present on two ranks, and both ranks would count the pair. So this
/// function builds the engine [`Distributed`] instead if statistics are requested. Epochs would
/// then bring no advantage, because statistics are read after each step.
///
/// # Errors
/// There is no MPI library.
pub fn deep<L: Halo + DeepHalo + 'static>(config: &Config) -> Built {
    if config.statistics {
        return distributed::<L>(config, 1);
    }
    Ok(Box::new(Deep::<L>::new(common_mpi::world()?, &config.clone().with_threads(1))))
}
