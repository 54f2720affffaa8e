//! Lab 8, collisions over MPI: the discs of lab 7, on ranks that share no memory.
//!
//! A step of hard discs is a search and a decision (lab 7). The search is easily shared out; the
//! decision goes through the candidates in order of time, and no rank has them all. There are two
//! ways out.
//!
//! **Bring them together.** One rank, the *master*, owns the discs. It deals the pairs to *workers*,
//! who send back what they find, and it decides alone. So did the CS3210 report. The art is in the
//! deal: everybody the same number of pairs, from as few discs as possible.
//!
//! | task | file | what |
//! |------|------|------|
//! | 8.1 | `deal.rs` | few blocks that are every distance apart |
//! | 8.2 | `deal.rs` | a job on each diagonal of the matrix of blocks |
//! | 8.3 | `look.rs` | the pairs of a job |
//! | 8.4 | `messages.rs` | from the master to the workers |
//! | 8.5 | `messages.rs` | from the workers to the master |
//! | 8.6 | `extra.rs` | what a worker cannot know after a step |
//! | 8.7 | `master_workers.rs` | one step of master and workers |
//!
//! **Leave them where they are.** The square is cut into strips, one for each rank, as in lab 6. What
//! flies across a cut is seen on both sides, but each pair is looked at, each collision decided
//! and each disc moved by one rank only, and all know by which. Nobody has all candidates; but a
//! rank that knows every candidate of two discs can tell whether theirs is the first. For discs
//! inside its strip it does. For those that others have too it asks.
//!
//! | task | file | what |
//! |------|------|------|
//! | 8.8 | `strips.rs` | which strips a disc reaches, and who looks at a pair |
//! | 8.9 | `ghosts.rs` | whose copies the others need |
//! | 8.10 | `docket.rs` | what is certain |
//! | 8.11 | `docket.rs` | news for the others, and from them |
//! | 8.12 | `moves.rs` | who moves a disc |
//! | 8.13 | `spatial_cuts.rs` | decide together; a step without a master |
//!
//! The bits are those of lab 7 with any number of ranks ([`Reproducibility::Bitwise`]): the same function
//! finds the candidates, and the order among them does not depend on where they were found.
//!
//! Every rank runs the same program. A function that says «all ranks call it together» returns on
//! none of them before all needed for it have called it.

mod crew;
mod deal;
mod docket;
mod extra;
mod ghosts;
mod look;
mod master_workers;
mod messages;
mod moves;
mod queues;
mod spatial_cuts;
mod strips;
mod tally;
mod wire;

pub use crew::{Crew, MASTER};
pub use deal::{Deal, Job, Part, distance, offsets};
pub use docket::{Docket, UNKNOWN};
pub use extra::{collided, update};
pub use ghosts::ghosts_for;
pub use look::look_at;
pub use master_workers::MasterWorkers;
pub use messages::{collect, hand_out};
pub use moves::move_on;
pub use queues::Queues;
pub use spatial_cuts::{SpatialCuts, walls_of};
pub use strips::{Reach, Strips, looks_at};
pub use wire::{CandidateWire, DiscWire};

use common::hard::Simulation;
use common::{Parameter, Reproducibility, Variant};
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
                about: "0: workers get their blocks anew in every step, as in the report",
                default: 1.0,
                range: (0.0, 1.0),
            },
        ],
        build: |config| {
            let world = common_mpi::world()?;
            let crew = Crew::new(world.size() as usize, config.parameter("master-works") > 0.0);
            Ok(Box::new(MasterWorkers::new(world, crew, config.parameter("keep") > 0.0)))
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
            Ok(Box::new(SpatialCuts::new(common_mpi::world()?, config.parameter("recut") as u64)))
        },
    },
];
