//! The given parts of the programs: what a rank keeps from step to step, and what its step is made
//! of.

mod master;
mod reported;
mod seen;
mod strip;

pub use master::MasterWorkers;
pub use reported::AsReported;
pub(crate) use seen::Seen;
pub use strip::{SpatialCuts, walls_of};
