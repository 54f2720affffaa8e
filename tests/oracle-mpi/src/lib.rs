//! Questions that all ranks of a job answer together.
//!
//! [`on_each`] runs a job on each of several numbers of ranks, and every rank asks the same
//! questions. A judge has no job. It asks the same questions for each rank, but has no world to
//! call. Therefore everything that needs the other ranks is done by [`Rank::call`], or inside an
//! answer's closure.

mod discs;
mod rank;
mod runs;

pub use discs::DiscsOnRanks;
pub use rank::{Rank, on_each};
pub use runs::RunsOnRanks;
