//! The engine of variant `verlet`.

mod boundary;
mod engine;
mod forces;
mod sweep;

pub use engine::{Counts, Verlet};
pub use forces::{BATCH, Contacts};
