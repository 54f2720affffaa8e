//! The engine of variant `verlet`.

mod counts;
mod engine;
mod forces;
mod pushes;
mod sweep;

pub use counts::Counts;
pub use engine::Verlet;
pub use forces::{BATCH, Contacts};
pub use pushes::Pushes;
