//! The neighbour list: the pairs that may touch before the next rebuild.
//!
//! ```text
//! outer list     pairs within cutoff + skin, rebuilt with each sort             Neighbours, Block
//! inner list     pairs within a smaller reach, rebuilt from the outer list      Limits, Budget
//!                every few steps
//! outliers       particles too fast for the lists; their pairs are searched     Outliers
//!                whenever the inner list is rebuilt
//! ```

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
