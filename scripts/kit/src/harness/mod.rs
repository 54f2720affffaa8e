//! Builds test programs, lists their tests, and runs single tests.
//!
//! Every test runs in a separate process with a time limit. So a test that aborts or hangs does not
//! affect other tests, and its output is separate.

mod build;
mod message;
mod verdict;
mod words;

pub use build::{Build, BuildError, CompileError, TestProgram, build};
pub use message::located_panic;
pub use verdict::{Outcome, Verdict};
