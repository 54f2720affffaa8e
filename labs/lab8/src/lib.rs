#![doc = include_str!("../README.md")]

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
use common::{Variant, bitwise};
use hard_disc_ranks::programs::{self, KEEP, MASTER_WORKS, RECUT};
use hard_disc_ranks::{
    Deal, Dealing, Deciding, Decisions, DiscWire, Job, MasterWorkers, Messages, Reach, SpatialCuts,
    Strips, Team,
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
    bitwise(
        "master-workers",
        "a master deals block pairs along the diagonals, collects candidates and decides",
        &[MASTER_WORKS, KEEP],
        programs::master_workers::<Lab8>,
    ),
    bitwise(
        "as-reported",
        "the report's: blocks again in every step, and the workers move the discs",
        &[],
        programs::as_reported::<Lab8>,
    ),
    bitwise(
        "spatial-cuts",
        "strips on ranks; ghosts and news of decisions travel between neighbours",
        &[RECUT],
        programs::spatial_cuts::<Lab8>,
    ),
];

/// The functions of the tasks, under the names that the library calls.
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
