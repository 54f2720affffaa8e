//! The engine: forces and move in one pass, and what crosses the ends of blocks.

mod across;
mod counts;
mod engine;
mod external;
mod sums;
mod sweep;

pub use counts::Counts;
pub use engine::Verlet;
pub use external::External;
