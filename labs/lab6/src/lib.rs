//! Lab 6, messages to neighbours, without a root in the middle.
//!
//! In lab 5 everything passes through the root, and the root holds the whole scene. Neither can go
//! on: with p ranks the root handles p times what another rank does, and its memory is finite.
//! But a rank only ever needs the row beyond its own on either side. So it talks to the two ranks
//! that have those rows, and to no other: what it sends grows with the length of a row, √n,
//! while its work grows with n / p.
//!
//! | task | file | what |
//! |------|------|------|
//! | 6.1 | `cuts.rs` | blocks of rows with nearly equal numbers of particles |
//! | 6.2 | `cuts.rs` | the neighbours of a rank, where some blocks are empty |
//! | 6.3 | `exchange.rs` | messages both ways at once, and work while they travel |
//! | 6.4 | `exchange.rs` | the same with one collective operation: Alltoallv |
//! | 6.5 | `rows.rs` | which rows can be computed before the ghosts are there |
//! | 6.6 | `leavers.rs` | movers to the neighbours, and movers that go further |
//! | 6.7 | `share.rs` | each rank keeps its share of the scene; then whole steps run |
//!
//! The rest is a library, `halo`: a rank's engine, its forces, movers and new cuts. It calls the functions of this lab by
//! the traits that [`Lab6`] implements below.
//!
//! No rank ever holds all particles. Each replays the official generator and keeps its own share,
//! or, of a counter scene, makes its own share and no more; output is gathered in chunks. The bits
//! are lab 2's with any number of ranks and threads ([`Reproducibility::Bitwise`]), since ghosts
//! carry their ids.

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

use common::soft::{NoStatistics, Observer, Particle, Simulation};
use common::{BuildError, Config, Parameter, Reproducibility, Variant};
use common_mpi::Wire;
use halo::{Blocks, Halo, Messages, Replay, Route};
use mpi::Rank;
use mpi::topology::SimpleCommunicator;
use mpi::traits::*;
use solution1::Tally;
use solution2::{Grid, bin_size};

const REBALANCE: Parameter = Parameter {
    name: "rebalance",
    about: "steps between two looks at the balance; 0 never looks",
    default: 50.0,
    range: (0.0, 1e9),
};

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[
    Variant {
        name: "halo",
        about: "ghosts to neighbours by non-blocking messages, inner rows computed meanwhile",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[bin_size(1.0), REBALANCE],
        build: |config| build(&config.clone().with_threads(1), Route::Neighbours),
    },
    Variant {
        name: "hybrid",
        about: "the same with threads (-t) in each rank",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[bin_size(1.0), REBALANCE],
        build: |config| build(config, Route::Neighbours),
    },
    Variant {
        name: "alltoallv",
        about: "ghosts and movers by one collective operation each, and nothing meanwhile",
        reproducibility: Reproducibility::Bitwise,
        parameters: &[bin_size(1.0), REBALANCE],
        build: |config| build(&config.clone().with_threads(1), Route::AllRanks),
    },
];

fn build(config: &Config, route: Route) -> Result<Box<dyn Simulation>, BuildError> {
    fn engine<O: Observer>(s: &Config, route: Route) -> Result<Box<dyn Simulation>, BuildError> {
        Ok(Box::new(Halo::<O, Lab6>::new(common_mpi::world()?, s, route)))
    }
    if config.statistics {
        engine::<Tally>(config, route)
    } else {
        engine::<NoStatistics>(config, route)
    }
}

/// What the library asks for, answered by the functions of the tasks.
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
