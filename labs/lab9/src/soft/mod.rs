//! Soft discs whose state stays on the device.

mod engine;
mod positions;
mod scan;
mod scene;

pub use engine::{SoftDiscs, Sorted};
pub use positions::{Double, Grid, Precision, Single};
pub use scan::Scan;
pub(crate) use scene::Loaded;
pub use scene::Options;
