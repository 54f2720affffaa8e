//! Sorted occupied cells, in windows of time.

mod cut;
mod deal;
mod lattice;
mod paths;
mod planned;
mod strip;
mod work;

pub use planned::Planned;
pub use work::{Work, expected_work};
