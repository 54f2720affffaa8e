//! Soft discs whose state stays on the device.

mod build;
mod engine;
mod kernels;
mod positions;
mod scan;
mod scene;
mod sort;

pub use build::Programs;
pub use engine::{SoftDiscs, Sorted};
pub use kernels::SoftKernels;
pub use positions::{Double, Grid, Precision, Single};
pub use scan::{Level, Scan};
pub use scene::Options;
pub use sort::Sort;
