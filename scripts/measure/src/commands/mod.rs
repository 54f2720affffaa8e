//! The measuring commands.

pub mod complexity;
pub mod race;
pub mod scaling;
pub mod sweep;
pub mod timeline;
pub mod traffic;
pub mod yardstick;
