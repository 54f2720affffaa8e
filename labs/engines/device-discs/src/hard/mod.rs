//! Hard discs whose pairs are filtered on the device.

mod build;
mod choose;
mod engine;
mod finder;
mod kernels;
mod margins;

pub use build::{PARAMETERS, build};
pub use choose::{Choice, ChoiceError, Chooser};
pub use engine::HardDiscs;
pub use finder::{Deal, Finder, WALL};
pub use kernels::{HardKernels, Launches, Search};
pub use margins::Margins;
