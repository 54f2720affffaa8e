//! Lab 11, what to skip: the solution. What the lab is about stands in `labs/lab11/README.md`.

mod flight;
mod tasks;
mod union_find;
mod window_length;

pub use flight::{closest_squared, fly, meets_wall, too_far_off};
pub use tasks::Tasks;
pub use union_find::{join, root};
pub use window_length::{LONGEST, window_length};

use common::Variant;
use common::soft::Simulation;
use windows::Programs;

/// The programs of this lab.
pub static VARIANTS: &[Variant<dyn Simulation>] = Tasks::VARIANTS;
