//! Lab 5, messages through the root: the solution. What the lab is about stands in `labs/lab5/README.md`.

mod border;
mod cut;
mod leavers;
mod root;
mod route;
mod scene;
mod statistics;
mod through_root;

pub use border::{border_copies, replace_ghosts};
pub use cut::Cut;
pub use leavers::take_leavers_of_block;
pub use root::{gather_at_root, scatter_from_root};
pub use route::{Parcel, sort_by_receiver};
pub use scene::broadcast;
pub use statistics::reduce;
pub use through_root::ThroughRoot;

use common::soft::{NoStatistics, Simulation};
use common::{Reproducibility, Variant};
use mpi::Rank;
use solution1::Tally;
use solution2::bin_size;

/// The rank that all messages go through.
pub const ROOT: Rank = 0;

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[Variant {
    name: "through-root",
    about: "rows of bins on ranks; movers and ghosts travel by way of rank 0",
    reproducibility: Reproducibility::Bitwise,
    parameters: &[bin_size(2.0)],
    build: |config| {
        let world = common_mpi::world()?;
        Ok(if config.statistics {
            Box::new(ThroughRoot::<Tally>::new(world, config))
        } else {
            Box::new(ThroughRoot::<NoStatistics>::new(world, config))
        })
    },
}];
