//! The engine: forces and move in one pass, and what crosses the ends of blocks.

mod across;
mod counts;
mod neighbour_list;
mod sums;
mod sweep;

pub use across::External;
pub use counts::Counts;
pub use neighbour_list::NeighbourList;
