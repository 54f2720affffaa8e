//! Soft discs on ranks: each rank has a block of rows of bins, and ghosts from its neighbours.
//!
//! A rank has the particles of its block and nothing else of the scene. It also needs copies,
//! *ghosts*, of the particles in the next row on either side. The ranks that have those rows send
//! ghosts in each step. [`Halo`] is the engine. The user's type makes the decisions; it implements
//! these traits:
//!
//! | trait | decisions |
//! |-------|-----------|
//! | [`Blocks`] | the partition of the rows, the neighbours, the interior, the targets of movers |
//! | [`Messages`] | how lists travel to the neighbours while a rank works, and to all ranks |
//!
//! The compiler resolves the calls to these traits, so they cost no more than calls to ordinary
//! functions. All ranks run the same program, and call the functions of
//! [`Simulation`](common::soft::Simulation) together.
//!
//! # Example
//!
//! Seven rows are divided among three ranks, and one rank gets no rows. The last line computes
//! which rows of block 2, the rows 3 to 6, need ghosts. The interior of this block is `4..7`. Row 3
//! needs ghosts from row 2. Row 6 is at the wall of the box, so it needs no ghosts, and the second
//! range is empty:
//!
//! ```
//! use halo::{Cuts, border_rows};
//!
//! let cuts = Cuts { starts: vec![0, 3, 3, 7] };
//! assert_eq!((cuts.block(0), cuts.block(1), cuts.block(2)), (0..3, 3..3, 3..7));
//! // Two blocks start at row 3. The row belongs to the last of them, because the other is empty.
//! assert_eq!((cuts.owner(2), cuts.owner(3)), (0, 2));
//! assert_eq!(border_rows(&cuts.block(2), &(4..7)), [3..4, 7..7]);
//! ```
//!
//! # Shapes
//!
//! A row is a row of bins of a [`Grid`](solution2::Grid), numbered along y. Particles are in
//! [`SortedBins`](solution2::SortedBins), and accelerations are in the same order. An index denotes
//! the same particle until bins are sorted. Particles in messages are [`Wire`](common_mpi::Wire)s
//! and [`Ghost`](common_mpi::Ghost)s.
//!
//! # Units
//!
//! Lengths are in units of the box. The parameter `bin-size` is in cutoffs, and `rebalance` in
//! steps.
//!
//! # Errors
//!
//! A scene that is not valid causes a [`SceneError`](common::soft::SceneError). A rank that ends
//! early ends the job.
//!
//! # Bits
//!
//! Ghosts carry their ids, and forces are summed in the order of ids. So the bits are the same on
//! any number of ranks and threads.

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
