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
//! | 6.7 | `halo/share.rs` | each rank keeps its share of the scene; then whole steps run |
//!
//! No rank ever holds all particles. Each replays the official generator and keeps its own share,
//! or, of a counter scene, makes its own share and no more; output is gathered in chunks. The bits
//! are lab 2's with any number of ranks and threads ([`Reproducibility::Bitwise`]), since ghosts
//! carry their ids.

mod cuts;
mod exchange;
mod halo;
mod leavers;
mod rows;

pub use cuts::{Cuts, balanced};
pub use exchange::{exchange_all, exchange_beside};
pub use halo::{Halo, Replay, Route, keep_share, make_share};
pub use leavers::{Leavers, sort_leavers};
pub use rows::{border_rows, interior_rows};

use common::soft::{NoStatistics, Observer, Simulation};
use common::{BuildError, Config, Parameter, Reproducibility, Variant};
use solution1::Tally;
use solution2::bin_size;

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
        Ok(Box::new(Halo::<O>::new(common_mpi::world()?, s, route)))
    }
    if config.statistics {
        engine::<Tally>(config, route)
    } else {
        engine::<NoStatistics>(config, route)
    }
}
