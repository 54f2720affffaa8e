//! Soft discs whose state stays on the device.

mod build;
mod engine;
mod kernels;
mod levels;
mod positions;
mod scan;
mod scene;

pub use build::{PARAMETERS, build};
pub use engine::{SoftDiscs, Sorted};
pub use kernels::SoftKernels;
pub use positions::{Double, Grid, Precision, Single};
pub use scan::{Level, Scan, Sort};
pub use scene::Options;
