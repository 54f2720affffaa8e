//! Questions that all ranks of a job answer together.
//!
//! [`on_each`] has a job run on each of some numbers of ranks, and every rank asks the same questions.
//! Who compares without a job goes through the same questions for each rank, with no world to call:
//! so everything that needs the other ranks is done by [`Rank::call`], or inside an answer's closure.

mod discs;
mod rank;
mod runs;

pub use discs::DiscsOnRanks;
pub use rank::{Rank, on_each};
pub use runs::RunsOnRanks;
