//! Test programs: building them, asking what tests they have, running a test by itself.
//!
//! Every test gets a process of its own, with a time limit. So a test that aborts or hangs takes
//! no other down, and what it printed is its own.

mod build;
mod message;
mod verdict;
mod words;

pub use build::{Build, BuildError, CompileError, TestProgram, build};
pub use message::located_panic;
pub use verdict::{Outcome, Verdict};
