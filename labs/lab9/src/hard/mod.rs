//! Hard discs whose pairs are looked at on the device.

mod choose;
mod engine;
mod finder;
mod margins;

pub use choose::{Choice, Chooser};
pub use engine::HardDiscs;
pub use finder::{Deal, Finder, WALL};
pub use margins::Margins;
