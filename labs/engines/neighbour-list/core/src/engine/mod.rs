//! The engine: it computes forces and moves particles in one pass over each block.
//!
//! Start with [`NeighbourList`]. The pass is in `sweep.rs`; pairs whose particles are in different
//! blocks are in `across.rs`.

mod across;
mod clock;
mod counts;
mod neighbour_list;
mod sums;
mod sweep;

pub use across::External;
pub use counts::Counts;
pub use neighbour_list::NeighbourList;
