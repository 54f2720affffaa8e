//! The neighbour list: which particles might touch until the next rebuild.

mod block;
mod budget;
mod limits;
mod neighbours;
mod outliers;

pub use block::{Block, Pairs, Piece};
pub use budget::Wear;
pub use limits::{Fast, Limits, Pace};
pub use neighbours::Neighbours;
pub use outliers::{Disc, Runner, Runners, overlapping};
