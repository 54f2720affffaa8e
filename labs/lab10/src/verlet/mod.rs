//! The engine of variant `verlet`.

mod across;
mod counts;
mod engine;
mod external;
mod sums;
mod sweep;

pub use counts::Counts;
pub use engine::Verlet;
pub use external::External;
