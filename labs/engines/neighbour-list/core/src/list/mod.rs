//! The neighbour list: which particles might touch until the next rebuild.

mod block;
mod budget;
mod limits;
mod neighbours;
mod outliers;

pub use block::{Block, Pairs, Piece};
pub use budget::{Budget, LISTED, REBUILD, TESTED, lasting};
pub use limits::{Fast, Limits, SpeedLimit};
pub use neighbours::Neighbours;
pub use outliers::{Disc, Outlier, Outliers, overlapping};
