//! Lab 5, messages through the root: the solution. The lab is described in `labs/lab5/README.md`.

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
pub use root::{gather_at_root, read_at_root, scatter_from_root};
pub use route::{Parcel, sort_by_receiver};
pub use scene::broadcast;
pub use statistics::reduce;
pub use through_root::ThroughRoot;

use common::soft::Simulation;
use common::{Variant, bitwise, observed};
use mpi::Rank;
use solution1::Tally;
use solution2::bin_size;

/// The rank that all messages go through.
pub const ROOT: Rank = 0;

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = &[bitwise(
    "through-root",
    "rows of bins on ranks; movers and ghosts travel by way of rank 0",
    &[bin_size(2.0)],
    |config| {
        let world = common_mpi::world()?;
        Ok(observed!(config, Tally, |O| ThroughRoot::<O>::new(world, config)))
    },
)];
