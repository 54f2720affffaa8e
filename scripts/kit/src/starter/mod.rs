//! Starters: [`generate`] says what the starter of a lab must be, [`Record`] which of its files are as
//! they were given.

mod generate;
mod record;
mod todo;

pub(crate) use generate::rename;
pub use generate::{Files, generate, given, own_paths, read_below};
pub use record::{Plan, Record};
pub use todo::todo;

/// Where a lab's starter is kept a second time, for `cargo lab reset` in a kit that cannot make it.
pub const GIVEN: &str = ".given";
