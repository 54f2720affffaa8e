//! Lab 8, collisions over MPI: the discs of lab 7, on ranks that share no memory.
//!
//! A step of hard discs is a search and a decision (lab 7). The search is easily shared out; the
//! decision goes through the candidates in order of time, and no rank has them all. There are two
//! ways out.
//!
//! **Bring them together.** One rank, the *master*, owns the discs. It deals the pairs to *workers*,
//! which send back the candidates that they find, and it decides alone. So did the CS3210 report. The
//! art is in the deal: the same number of pairs for every worker, from as few discs as possible. In the
//! report the workers move the discs, too; `as-reported` is given, and does so.
//!
//! | task | file | what |
//! |------|------|------|
//! | 8.1 | `deal.rs` | few blocks that are every distance apart |
//! | 8.2 | `deal.rs` | a job on each diagonal of the matrix of blocks |
//! | 8.3 | `jobs.rs` | the pairs of a job |
//! | 8.4 | `messages.rs` | from the master to the workers |
//! | 8.5 | `messages.rs` | from the workers to the master |
//! | 8.6 | `collided.rs` | what a worker cannot know after a step |
//! | 8.7 | `master_workers.rs` | one step of master and workers |
//!
//! **Leave them where they are.** The square is cut into strips, one for each rank, as in lab 6. Discs
//! near a cut are known on both sides of it, but each pair is looked at, each collision decided and
//! each disc moved by one rank only, and all ranks know by which. No rank has all candidates; but a
//! rank that knows every candidate of two discs can tell whether a collision of the two comes first.
//! Of discs inside its strip it knows all candidates. About the others it asks its neighbours.
//!
//! | task | file | what |
//! |------|------|------|
//! | 8.8 | `strips.rs` | which strips a disc reaches, and which rank looks at a pair |
//! | 8.9 | `ghosts.rs` | which discs a partner needs copies of |
//! | 8.10 | `certain.rs` | which candidates are certain to happen |
//! | 8.11 | `news.rs` | what ranks tell each other of their decisions |
//! | 8.12 | `moves.rs` | which rank moves a disc |
//! | 8.13 | `spatial_cuts.rs` | decide together; a step without a master |
//!
//! The files with tasks are those of the two tables. The folders below are given, and need not be
//! read: `ranks/` (which rank does what, the form of discs and candidates in messages, counts),
//! `decisions/` (the lists that tasks 8.10 to 8.12 work on), `engines/` (what a step is made of, and the
//! report's program).
//!
//! The bits are those of lab 7 with any number of ranks ([`Reproducibility::Bitwise`]): the same
//! function finds the candidates, and the order among them does not depend on where they were found.
//!
//! Every rank runs the same program. A function that says «all ranks call it together» returns on
//! none of them before all needed for it have called it.

mod certain;
mod collided;
mod deal;
mod decisions;
mod engines;
mod ghosts;
mod jobs;
mod master_workers;
mod messages;
mod moves;
mod news;
mod ranks;
mod spatial_cuts;
mod strips;

pub use collided::{collided, update};
pub use deal::{Deal, Job, Part, distance, offsets};
pub use decisions::{Decisions, Queues, UNKNOWN};
pub use engines::{AsReported, MasterWorkers, SpatialCuts, walls_of};
pub use ghosts::ghosts_for;
pub use jobs::search_job;
pub use messages::{collect, hand_out};
pub use moves::move_on;
pub use ranks::{CandidateWire, DiscWire, MASTER, Team};
pub use strips::{Reach, Strips, looks_at};

use common::hard::Simulation;
use common::{Parameter, Reproducibility, Variant};
use common_mpi::Clock;
use mpi::traits::*;

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
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
            Ok(Box::new(MasterWorkers::new(world, team, keep, clock)))
        },
    },
    Variant {
        name: "as-reported",
        about: "the report's: blocks again in every step, and the workers move the discs",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[],
        build: |config| {
            let (world, clock) = (common_mpi::world()?, Clock::new(config.events));
            Ok(Box::new(AsReported::new(world, clock)))
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
            Ok(Box::new(SpatialCuts::new(common_mpi::world()?, recut, clock)))
        },
    },
];
