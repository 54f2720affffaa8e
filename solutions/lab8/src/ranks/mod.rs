//! What the ranks of both programs have in common: which rank does what, how a disc and a candidate
//! look in a message, and what is counted.

mod tally;
mod team;
mod wire;

pub(crate) use tally::Tally;
pub use team::{MASTER, Team};
pub use wire::{CandidateWire, DiscWire};
