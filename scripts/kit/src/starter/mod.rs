//! Starters of labs: makes them, and finds their unchanged files.
//!
//! [`generate`] makes the starter of a lab, and [`Record`] compares its files.

mod generate;
mod record;
mod todo;

pub(crate) use generate::rename;
pub use generate::{Files, generate, given, own_files, read_below};
pub use record::{Plan, Record};
pub use todo::todo;

/// Folder with a copy of a lab's starter, for `cargo lab reset` in a kit that cannot generate it.
pub const GIVEN: &str = ".given";
