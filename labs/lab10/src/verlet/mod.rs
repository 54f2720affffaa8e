//! The engine of variant `verlet`.

mod across;
mod contacts;
mod counts;
mod engine;
mod pushes;
mod sums;
mod sweep;

pub use contacts::Contacts;
pub use counts::Counts;
pub use engine::Verlet;
pub use pushes::Pushes;
