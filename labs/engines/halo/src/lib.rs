//! Soft discs on ranks: rows of bins cut into blocks, one for each rank, and ghosts from the neighbours in each step.
//!
//! A rank has the particles of its block and nothing else of the scene. Of the row beyond its own on either side it needs
//! copies, *ghosts*, which the ranks that have those rows send in each step. [`Halo`] is the engine around this. What a
//! block is and how lists travel it asks of a type that its user gives:
//!
//! | trait | what it says |
//! |-------|--------------|
//! | [`Blocks`] | how rows are cut, which ranks are neighbours, which rows need no ghosts, where movers go |
//! | [`Messages`] | how lists get to the neighbours while a rank works, and how to all ranks |
//!
//! Calls are resolved by the compiler. All ranks run the same program, and call the functions of
//! [`Simulation`](common::soft::Simulation) together.
//!
//! # Example
//!
//! Seven rows for three ranks, of which one gets none, and the rows of a block that wait for ghosts:
//!
//! ```
//! use halo::{Cuts, border_rows};
//!
//! let cuts = Cuts { starts: vec![0, 3, 3, 7] };
//! assert_eq!((cuts.block(0), cuts.block(1), cuts.block(2)), (0..3, 3..3, 3..7));
//! // Row 3 belongs to the last block that starts at it: the one before is empty.
//! assert_eq!((cuts.owner(2), cuts.owner(3)), (0, 2));
//! assert_eq!(border_rows(&cuts.block(2), &(4..7)), [3..4, 7..7]);
//! ```
//!
//! # Shapes
//!
//! A row is a row of bins of a [`Grid`](solution2::Grid), numbered along y. Particles lie in
//! [`SortedBins`](solution2::SortedBins), accelerations in the same order; an index means the same particle until
//! bins are sorted. Particles in messages are [`Wire`](common_mpi::Wire)s and [`Ghost`](common_mpi::Ghost)s.
//!
//! # Units
//!
//! Lengths are those of the box; the parameter `bin-size` is in cutoffs, `rebalance` in steps.
//!
//! # Errors
//!
//! A scene that cannot be is a [`SceneError`](common::soft::SceneError). A rank that ends early ends the job.
//!
//! # Bits
//!
//! Ghosts carry their ids, and forces are summed in the order of ids: the bits are those of one rank, with any number of
//! ranks and threads.

mod blocks;
mod engine;
mod forces;
mod messages;
mod migrate;
pub mod programs;
mod share;
mod threads;

pub use blocks::{Blocks, Cuts, Leavers, Replay, border_rows};
pub use engine::Halo;
pub use messages::{Messages, Route};
pub use share::make_share;
