//! Threads, and the data that they share.

pub(crate) mod pieces;
mod shared;
mod slots;
mod team;

pub use shared::{LockedCount, SharedCount};
pub use slots::Slots;
pub use team::{Schedule, Team};
