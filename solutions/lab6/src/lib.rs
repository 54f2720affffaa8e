//! Lab 6, messages to neighbours: the solution. The lab is described in `labs/lab6/README.md`.

mod cuts;
mod exchange;
mod leavers;
mod rows;
mod share;

pub use cuts::{balanced, neighbours};
pub use exchange::{exchange_all, exchange_beside};
pub use halo::{Cuts, Leavers, border_rows};
pub use leavers::sort_leavers;
pub use rows::interior_rows;
pub use share::keep_share;

use std::ops::Range;

use common::soft::{Particle, Simulation};
use common::{Variant, bitwise};
use common_mpi::Wire;
use halo::programs::{PARAMETERS, build};
use halo::{Blocks, Messages, Replay, Route};
use mpi::Rank;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution2::Grid;

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    bitwise(
        "halo",
        "ghosts to neighbours by non-blocking messages, inner rows computed meanwhile",
        PARAMETERS,
        |config| build::<Lab6>(config, 1, Route::Neighbours),
    ),
    bitwise("hybrid", "the same with threads (-t) in each rank", PARAMETERS, |config| {
        build::<Lab6>(config, config.threads, Route::Neighbours)
    }),
    bitwise(
        "alltoallv",
        "ghosts and movers by one collective operation each, and nothing meanwhile",
        PARAMETERS,
        |config| build::<Lab6>(config, 1, Route::AllRanks),
    ),
];

/// The functions of the tasks, under the names that the library calls.
pub struct Lab6;

impl Blocks for Lab6 {
    fn balanced(counts: &[u64], ranks: usize) -> Cuts {
        balanced(counts, ranks)
    }

    fn neighbours(cuts: &Cuts, rank: usize) -> [Option<usize>; 2] {
        neighbours(cuts, rank)
    }

    fn interior_rows(block: &Range<usize>, rows: usize) -> Range<usize> {
        interior_rows(block, rows)
    }

    fn sort_leavers(
        grid: &Grid,
        cuts: &Cuts,
        neighbours: [Option<usize>; 2],
        leavers: &[Wire],
    ) -> Leavers {
        sort_leavers(grid, cuts, neighbours, leavers)
    }

    fn keep_share(
        grid: &Grid,
        ranks: usize,
        rank: usize,
        replay: Replay<'_>,
    ) -> (Cuts, Vec<Particle>) {
        keep_share(grid, ranks, rank, replay)
    }
}

impl Messages for Lab6 {
    fn exchange_beside<T, R>(
        world: &SimpleCommunicator,
        outgoing: &[(Rank, Vec<T>)],
        work: impl FnOnce() -> R,
    ) -> (Vec<Vec<T>>, R)
    where
        T: Equivalence + Default + Clone,
    {
        exchange_beside(world, outgoing, work)
    }

    fn exchange_all<T>(world: &SimpleCommunicator, lists: &[Vec<T>]) -> Vec<T>
    where
        T: Equivalence + Default + Clone,
    {
        exchange_all(world, lists)
    }
}
