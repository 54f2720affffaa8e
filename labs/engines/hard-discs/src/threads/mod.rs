//! Threads, and what they share.

mod shared;
mod slots;
mod team;
mod workers;

pub use shared::{LockedCount, SharedCount};
pub use slots::Slots;
pub use team::{Schedule, Team};
pub use workers::Workers;
