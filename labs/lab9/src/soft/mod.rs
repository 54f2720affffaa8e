//! Soft discs whose state stays on the device.

mod engine;
mod places;
mod scan;
mod scene;

pub use engine::{SoftDiscs, Sorted};
pub use places::{Double, Grid, Precision, Single};
pub use scan::Scan;
pub(crate) use scene::Loaded;
pub use scene::Options;
