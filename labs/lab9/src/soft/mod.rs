//! Soft discs whose state stays on the device.

mod engine;
mod grid;
mod precision;
mod scan;
pub mod wgsl;

pub use engine::{Options, SoftDiscs, Sorted};
pub use grid::Grid;
pub use precision::{Double, Precision, Single};
pub use scan::Scan;
