//! The fastest search: sorted occupied cells, window by window and strip by strip.
//!
//! ```text
//! survey     the scene: number of discs, extent, speeds        Survey
//! lattice    columns and rows for the mean swept box           Lattice
//! cut        rows divided into strips                          Cut
//! window     deal    workers share the discs and make an       Deal, Entry
//!                    entry for each row that a box touches
//!            search  workers take strips, sort their           Searcher
//!                    entries by cell and test the pairs
//! ```
//!
//! [`Planned`] runs these stages.

mod cut;
mod deal;
mod lattice;
mod paths;
mod planned;
mod strip;
mod work;

pub use planned::Planned;
pub use work::{Work, expected_work};
