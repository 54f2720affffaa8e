//! Builds the engines as programs from their parameters.

use common::hard::Simulation;
use common::{BuildError, Config, Parameter};
use common_mpi::Clock;
use mpi::traits::*;

use crate::as_reported::AsReported;
use crate::master_workers::{Dealing, MasterWorkers};
use crate::spatial_cuts::{Deciding, SpatialCuts};
use crate::team::Team;

/// Whether the master is a worker as well.
pub const MASTER_WORKS: Parameter =
    Parameter::switch("master-works", "1: the master is a worker as well", false);

/// Whether workers keep their blocks from step to step.
pub const KEEP: Parameter =
    Parameter::switch("keep", "0: workers get their blocks again in every step", true);

/// The number of steps after which strips are cut again.
pub const RECUT: Parameter = Parameter {
    name: "recut",
    about: "steps between two cuts into strips of equal numbers; 0 cuts once",
    default: 50.0,
    range: (0.0, 1e9),
};

type Built = Result<Box<dyn Simulation>, BuildError>;

/// Builds the engine [`MasterWorkers`] of this rank, for the parameters [`MASTER_WORKS`] and [`KEEP`].
///
/// # Errors
/// There is no MPI library.
pub fn master_workers<T: Dealing>(config: &Config) -> Built {
    let world = common_mpi::world()?;
    let team = Team::new(world.size() as usize, config.parameter(MASTER_WORKS.name) > 0.0);
    let keep = config.parameter(KEEP.name) > 0.0;
    Ok(Box::new(MasterWorkers::<T>::new(world, team, keep, Clock::new(config.events))))
}

/// Builds the engine [`AsReported`] of this rank.
///
/// # Errors
/// There is no MPI library.
pub fn as_reported<T: Dealing>(config: &Config) -> Built {
    Ok(Box::new(AsReported::<T>::new(common_mpi::world()?, Clock::new(config.events))))
}

/// Builds the engine [`SpatialCuts`] of this rank, for the parameter [`RECUT`].
///
/// # Errors
/// There is no MPI library.
pub fn spatial_cuts<T: Deciding>(config: &Config) -> Built {
    let recut = config.parameter(RECUT.name) as u64;
    Ok(Box::new(SpatialCuts::<T>::new(common_mpi::world()?, recut, Clock::new(config.events))))
}
