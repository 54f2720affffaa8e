//! The engines as programs that a driver lists and builds.

use common::hard::Simulation;
use common::{Parameter, Variant, bitwise};
use common_mpi::Clock;
use mpi::traits::*;

use crate::as_reported::AsReported;
use crate::master_workers::{Dealing, MasterWorkers};
use crate::spatial_cuts::{Deciding, SpatialCuts};
use crate::team::{Messages, Team};

/// The programs for a type that answers all that the library asks.
pub trait Programs: Messages + Dealing + Deciding {
    /// All of them. They give the bits of one rank.
    const VARIANTS: &'static [Variant<dyn Simulation>] = &[
        bitwise(
            "master-workers",
            "a master deals block pairs along the diagonals, collects candidates and decides",
            &[
                Parameter::switch("master-works", "1: the master is a worker as well", false),
                Parameter::switch("keep", "0: workers get their blocks again in every step", true),
            ],
            |config| {
                let world = common_mpi::world()?;
                let team = Team::new(world.size() as usize, config.parameter("master-works") > 0.0);
                let (keep, clock) = (config.parameter("keep") > 0.0, Clock::new(config.events));
                Ok(Box::new(MasterWorkers::<Self>::new(world, team, keep, clock)))
            },
        ),
        bitwise(
            "as-reported",
            "the report's: blocks again in every step, and the workers move the discs",
            &[],
            |config| {
                let (world, clock) = (common_mpi::world()?, Clock::new(config.events));
                Ok(Box::new(AsReported::<Self>::new(world, clock)))
            },
        ),
        bitwise(
            "spatial-cuts",
            "strips on ranks; ghosts and news of decisions travel between neighbours",
            &[Parameter {
                name: "recut",
                about: "steps between two cuts into strips of equal numbers; 0 cuts once",
                default: 50.0,
                range: (0.0, 1e9),
            }],
            |config| {
                let (recut, clock) = (config.parameter("recut") as u64, Clock::new(config.events));
                Ok(Box::new(SpatialCuts::<Self>::new(common_mpi::world()?, recut, clock)))
            },
        ),
    ];
}

impl<L: Messages + Dealing + Deciding> Programs for L {}
