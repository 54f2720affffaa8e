//! Builds the engine as a program from its parameters.

use common::soft::Simulation;
use common::{BuildError, Config, Parameter, observed};
use solution1::Tally;
use solution2::bin_size;
use workers::Workers;

use crate::blocks::Blocks;
use crate::engine::Halo;
use crate::messages::{Messages, Route};

/// The parameters of an engine.
pub const PARAMETERS: &[Parameter] = &[bin_size(1.0), REBALANCE, REMAINDER_LAST];

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

/// Builds the engine of this rank, with `threads` threads and messages along this `route`.
///
/// # Errors
/// There is no MPI library, or the system refuses to start the threads.
pub fn build<L: Blocks + Messages + 'static>(
    config: &Config,
    threads: usize,
    route: Route,
) -> Result<Box<dyn Simulation>, BuildError> {
    let world = common_mpi::world()?;
    let workers = Workers::new(threads)?;
    Ok(observed!(config, Tally, |O| Halo::<O, L>::new(world, config, workers, route)))
}
