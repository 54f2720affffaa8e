//! Cargo at work, seen.

use std::io::{self, IsTerminal};
use std::process::{Command, Output, Stdio};

/// Runs cargo to its end and returns what it printed. On a terminal it shows its bar while something is compiled:
/// the first build of anything takes minutes. What it complains of it says itself, and nothing else.
pub fn run_visibly(cargo: &mut Command) -> io::Result<Output> {
    let when = if io::stderr().is_terminal() { "always" } else { "never" };
    cargo.env("CARGO_TERM_QUIET", "true");
    cargo.env("CARGO_TERM_PROGRESS_WHEN", when).env("CARGO_TERM_PROGRESS_WIDTH", "80");
    cargo.stderr(Stdio::inherit()).output()
}
