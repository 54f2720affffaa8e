//! Lab 8, collisions over MPI: the discs of lab 7, on ranks that share no memory.
//!
//! A step of hard discs is a search and a decision (lab 7). The search is easily shared out; the
//! decision goes through the candidates in order of time, and no rank has them all. There are two
//! ways out.
//!
//! **Bring them together.** One rank, the *master*, owns the discs. It deals the pairs to *workers*,
//! which send back the candidates that they find, and it decides alone. So did the CS3210 report. The
//! art is in the deal: the same number of pairs for every worker, from as few discs as possible. In the
//! report the workers move the discs, too; so does `as-reported`, which is given.
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
//! The rest is a library, `hard-disc-ranks`: the form of discs and candidates in messages, which rank does what, and the
//! engines. It calls the functions of this lab by the traits that [`Lab8`] implements below.
//!
//! The bits are those of lab 7 with any number of ranks ([`Reproducibility::Bitwise`]): the same
//! function finds the candidates, and the order among them does not depend on where they were found.
//!
//! Every rank runs the same program. A function that says «all ranks call it together» returns on
//! none of them before all needed for it have called it.

mod certain;
mod collided;
mod deal;
mod ghosts;
mod jobs;
mod master_workers;
mod messages;
mod moves;
mod news;
mod spatial_cuts;
mod strips;

use common::hard::{Disc, Simulation};
use common::{Parameter, Reproducibility, Variant};
use common_mpi::Clock;
use hard_disc_ranks::{
    AsReported, Deal, Dealing, Deciding, Decisions, DiscWire, Job, MasterWorkers, Messages, Reach,
    SpatialCuts, Strips, Team,
};
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution5::Cut;
use solution7::{Candidate, Lab7};

pub use certain::take_certain;
pub use collided::{collided, update};
pub use deal::{deal_out, distance, jobs, offsets};
pub use ghosts::ghosts_for;
pub use jobs::search_job;
pub use messages::{collect, hand_out};
pub use moves::move_on;
pub use news::{hear, news_for};
pub use strips::{looks_at, reached};

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
            Ok(Box::new(MasterWorkers::<Lab8>::new(world, team, keep, clock)))
        },
    },
    Variant {
        name: "as-reported",
        about: "the report's: blocks again in every step, and the workers move the discs",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[],
        build: |config| {
            let (world, clock) = (common_mpi::world()?, Clock::new(config.events));
            Ok(Box::new(AsReported::<Lab8>::new(world, clock)))
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
            Ok(Box::new(SpatialCuts::<Lab8>::new(common_mpi::world()?, recut, clock)))
        },
    },
];

/// What the library asks for, answered by the functions of the tasks.
pub struct Lab8;

impl Messages for Lab8 {
    fn hand_out<W: Equivalence + Clone>(
        world: &SimpleCommunicator,
        team: Team,
        lists: &[Vec<W>],
    ) -> Vec<W> {
        hand_out(world, team, lists)
    }

    fn collect<W: Equivalence + Clone>(
        world: &SimpleCommunicator,
        team: Team,
        own: &[W],
    ) -> Vec<W> {
        collect(world, team, own)
    }
}

impl Dealing for Lab8 {
    type Rules = Lab7;

    fn deal(workers: usize) -> Deal {
        deal_out(workers)
    }

    fn jobs(deal: &Deal, worker: usize) -> Vec<Job> {
        jobs(deal, worker)
    }

    fn search_job(
        discs: &[Disc],
        blocks: &Cut,
        job: &Job,
        radius: f64,
        list: &mut Vec<Candidate>,
    ) -> u64 {
        search_job(discs, blocks, job, radius, list)
    }

    fn collided(
        discs: &[Disc],
        blocks: &Cut,
        held: &[usize],
        taken: &[Candidate],
    ) -> Vec<DiscWire> {
        collided(discs, blocks, held, taken)
    }

    fn step(engine: &mut MasterWorkers<Self>) {
        master_workers::step(engine);
    }
}

impl Deciding for Lab8 {
    type Rules = Lab7;

    #[inline]
    fn reached(strips: &Strips, disc: &DiscWire, reach: f64) -> Reach {
        reached(strips, disc, reach)
    }

    #[inline]
    fn looks_at(rank: usize, a: Reach, b: Reach) -> bool {
        looks_at(rank, a, b)
    }

    fn take_certain(decisions: &mut Decisions) {
        take_certain(decisions);
    }

    fn step(engine: &mut SpatialCuts<Self>) {
        spatial_cuts::step(engine);
    }
}
