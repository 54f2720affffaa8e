//! Lab 5, messages through the root: several processes, none of which sees another one's memory.
//!
//! Each process is a *rank*. The rows of bins are cut into blocks, and each rank keeps the
//! particles of its own block. Two things cross the borders between blocks. A particle that moves
//! across must leave one rank's bins and enter another's. And a particle near a border has
//! neighbours on the other side, of which its rank must have copies: *ghosts*. Both are sent to
//! rank 0, the *root*, which sorts them by receiver and sends them on. So did a project in CSC581,
//! of which this lab keeps the structure and not the mistakes.
//!
//! | task | file | what |
//! |------|------|------|
//! | 5.1 | `cut.rs` | which rows a rank has, and which rank has a row |
//! | 5.2 | `leavers.rs` | particles that changed their bin: within the block, or out of it |
//! | 5.3 | `border.rs` | copies of the border rows |
//! | 5.4 | `root.rs` | from all ranks to the root: Gather, Gatherv |
//! | 5.5 | `route.rs` | the root sorts by receiver |
//! | 5.6 | `root.rs` | from the root to all ranks: Scatter, Scatterv |
//! | 5.7 | `border.rs` | old ghosts go, new particles and new ghosts come |
//! | 5.8 | `scene.rs`, `through_root.rs` | all ranks get the scene: Bcast; and a whole step |
//! | 5.9 | `statistics.rs` | statistics of all ranks: Reduce |
//!
//! The scene, the bins and the order of summation are lab 2's, so that the results are too: the
//! same bits with any number of ranks ([`Reproducibility::Bitwise`]).
//!
//! Every rank runs the same program. A function of which it is said that all ranks call it together
//! contains a collective operation. Every rank must make that call, also one that has nothing to
//! send; where a rank leaves it out, the others may wait for ever.

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
