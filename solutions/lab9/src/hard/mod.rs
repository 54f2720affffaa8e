//! Hard discs whose pairs are looked at on the device.

mod choose;
mod engine;
mod finder;
mod parameters;
pub mod wgsl;

pub use choose::{Choice, Chooser};
pub use engine::HardDiscs;
pub use finder::{Deal, Finder, WALL};
pub use parameters::Margins;
