//! The engine of variant `verlet`.

mod boundary;
mod engine;
mod forces;
mod part;
mod pushes;
mod step;
mod sweep;

pub use engine::{Counts, Verlet};
pub use forces::{BATCH, Contacts};
pub use pushes::Pushes;
pub use step::Step;
