//! The engines as programs that a driver lists and builds.

use common::hard::Simulation;
use common::{Parameter, Reproducibility, Variant};
use common_mpi::Clock;
use mpi::traits::*;

use crate::as_reported::AsReported;
use crate::master_workers::{Dealing, MasterWorkers};
use crate::messages::Messages;
use crate::spatial_cuts::{Deciding, SpatialCuts};
use crate::team::Team;

/// The programs for a type that answers all that the library asks.
pub trait Programs: Messages + Dealing + Deciding {
    /// All of them. They give the bits of one rank.
    const VARIANTS: &'static [Variant<dyn Simulation>] = &[
        Variant {
            name: "master-workers",
            about: "a master deals block pairs along the diagonals, collects candidates and decides",
            reproducibility: Reproducibility::Bitwise,
            parameters: &[
                Parameter {
                    name: "master-works",
                    about: "1: the master is a worker as well",
                    default: 0.0,
                    range: (0.0, 1.0),
                },
                Parameter {
                    name: "keep",
                    about: "0: workers get their blocks again in every step",
                    default: 1.0,
                    range: (0.0, 1.0),
                },
            ],
            build: |config| {
                let world = common_mpi::world()?;
                let team = Team::new(world.size() as usize, config.parameter("master-works") > 0.0);
                let (keep, clock) = (config.parameter("keep") > 0.0, Clock::new(config.events));
                Ok(Box::new(MasterWorkers::<Self>::new(world, team, keep, clock)))
            },
        },
        Variant {
            name: "as-reported",
            about: "the report's: blocks again in every step, and the workers move the discs",
            reproducibility: Reproducibility::Bitwise,
            parameters: &[],
            build: |config| {
                let (world, clock) = (common_mpi::world()?, Clock::new(config.events));
                Ok(Box::new(AsReported::<Self>::new(world, clock)))
            },
        },
        Variant {
            name: "spatial-cuts",
            about: "strips on ranks; ghosts and news of decisions travel between neighbours",
            reproducibility: Reproducibility::Bitwise,
            parameters: &[Parameter {
                name: "recut",
                about: "steps between two cuts into strips of equal numbers; 0 cuts once",
                default: 50.0,
                range: (0.0, 1e9),
            }],
            build: |config| {
                let (recut, clock) = (config.parameter("recut") as u64, Clock::new(config.events));
                Ok(Box::new(SpatialCuts::<Self>::new(common_mpi::world()?, recut, clock)))
            },
        },
    ];
}

impl<L: Messages + Dealing + Deciding> Programs for L {}
